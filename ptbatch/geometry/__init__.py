"""Geometry of a member: where its tendon runs and what its section is made of."""
