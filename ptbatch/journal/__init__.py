"""What was analysed already, on disk beside the results, so that a run can be resumed."""
