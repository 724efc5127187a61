"""EN 1992-1-1:2004 with its recommended values; national ones are arguments."""
