"""The journal of a run: outcomes of its rows, kept until the results are complete."""

from pathlib import Path
from types import TracebackType

from ptbatch.errors import WriteError
from ptbatch.journal.content import decode, encode
from ptbatch.journal.key import member_key
from ptbatch.journal.records import Records
from ptbatch.member import Member
from ptbatch.workbook.results import Outcome


def journal_path(results: Path) -> Path:
    """`beams.results.xlsx` has `.beams.results.xlsx.journal`, beside it."""
    return results.with_name(f".{results.name}.journal")


class Journal:
    """Outcomes on disk. With `resume` those of earlier runs are known; without they are left alone, and the
    new ones come behind them. Raises WriteError."""

    def __init__(self, path: Path, resume: bool) -> None:
        self.path, self._resume = path, resume
        self.used = 0
        try:
            self._records = Records(path)
        except OSError as error:
            raise self._unwritable(error) from error

    def key(self, member: Member) -> bytes | None:
        """Where the outcome of a member is to be found; None if it is not known."""
        if not self._resume:
            return None
        key = member_key(member)
        return key if key in self._records else None

    def read(self, key: bytes) -> Outcome:
        """A known outcome."""
        self.used += 1
        return decode(self._records[key])

    def add(self, member: Member, outcome: Outcome) -> None:
        """Keep an outcome, unless an interruption or an internal error took its place."""
        if not outcome.analysed:
            return
        try:
            self._records.add(member_key(member), encode(outcome))
        except OSError as error:
            raise self._unwritable(error) from error

    def remove(self) -> None:
        """The results are complete."""
        self._records.close()
        self.path.unlink(missing_ok=True)

    def __enter__(self) -> "Journal":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close it; without an outcome there is nothing to go on from."""
        empty = not len(self._records)
        self._records.close()
        if empty:
            self.path.unlink(missing_ok=True)

    def _unwritable(self, error: OSError) -> WriteError:
        return WriteError(f"{self.path} cannot be written: {error.strerror or error}")
