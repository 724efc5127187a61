"""What is measured rather than tested: speed, and whether the solver arrives on members that nobody tuned it
for."""
