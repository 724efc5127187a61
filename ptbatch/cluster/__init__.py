"""Members to outcomes on many machines: chunks of rows to the workers of a Dask scheduler, back in order."""
