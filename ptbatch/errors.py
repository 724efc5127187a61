"""Errors whose message is meant for the person at the keyboard."""


class PtbatchError(Exception):
    """Something that the user can put right; the message says what and how."""


class UnknownMemberError(PtbatchError):
    """A member asked for that the workbook does not have."""


class ReadError(PtbatchError):
    """A workbook that cannot be read at all."""


class WriteError(PtbatchError):
    """Results that cannot be written."""
