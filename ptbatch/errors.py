"""Errors whose message is meant for the person at the keyboard."""


class PtbatchError(Exception):
    """Something that the user can put right; the message says what and how."""


class UnknownMemberError(PtbatchError):
    """A member asked for that the workbook does not have."""


class OutputNameError(PtbatchError):
    """A file name that does not fit what is to be written."""


class NothingToDrawError(PtbatchError):
    """Members of which there is nothing to be seen."""


class ReadError(PtbatchError):
    """A workbook that cannot be read at all."""


class WriteError(PtbatchError):
    """Results that cannot be written."""


class ClusterError(PtbatchError):
    """Other machines that do not do their part."""
