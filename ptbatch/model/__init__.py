"""A member as plain arrays: materials, mesh, loads and duct, ready for the kernels."""
