"""What is measured rather than tested: speed, and whether the solver arrives on members nobody tuned it for."""
