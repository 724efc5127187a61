"""What is measured rather than tested: speed, and how well the solver arrives on members nobody tuned it for."""
