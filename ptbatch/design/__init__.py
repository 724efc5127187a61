"""Design checks by a code, from a member and its analysis: pure functions, one a clause."""
