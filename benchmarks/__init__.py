"""What is measured, not tested: speed, and whether the solver arrives on members nobody tuned it for."""
