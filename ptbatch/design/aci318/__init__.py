"""ACI 318-19. Strengths enter in MPa; where the code has pounds and inches in a constant, it is converted
exactly, so that examples in US units come out to the digit (318M rounds them, by less than 1 %)."""

PSI = 4.4482216152605 / 25.4**2  # MPa
