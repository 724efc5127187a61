"""Results held against what is known: a published table, or the results of another run."""
