"""The tables of a run, filled row by row: sheets of a workbook, the long ones Parquet files if there are many
rows."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any, Protocol

from ptbatch.workbook.column import System
from ptbatch.workbook.echo import TABLES as ECHO
from ptbatch.workbook.echo import echo_headers, echo_lines
from ptbatch.workbook.fields import fields
from ptbatch.workbook.inputs import Inputs
from ptbatch.workbook.legend import LEGEND, legend, notes
from ptbatch.workbook.page import FullSheetError, Page
from ptbatch.workbook.parquet import ParquetTable
from ptbatch.workbook.places import Places
from ptbatch.workbook.problems import Listed, Problem
from ptbatch.workbook.results import DETAILS, PROBLEMS, Outcome, named, rows_in, summary_headers
from ptbatch.workbook.rows import Row
from ptbatch.workbook.site import SHEET, site_columns, site_headers
from ptbatch.workbook.status import coloured
from ptbatch.workbook.systems import headers_in
from ptbatch.workbook.viewer import write_viewer
from ptbatch.workbook.write import Book, unwritable

ORDER = ("summary", "viewer", *DETAILS, "problems", *ECHO, "settings", "run", "legend", "places")
ALWAYS = ("summary", "tendon", "curves", "cracks", "problems", "members")
FILES = ("summary", *(name for name in DETAILS if name != SHEET), *ECHO)  # that Parquet can take
CURE = "let --parquet FOLDER take the long tables; with --resume nothing is analysed again"


class Table(Protocol):
    """A sheet or a file that takes rows."""

    def extend(self, columns: Sequence[Sequence[Any]]) -> None:
        """Add rows, column by column."""


class Output:
    """Results of a run on their way to `path`, and to Parquet files in `folder` if there is one.

    With a folder the workbook holds summary, problems, run and legend, and no viewer; the files hold the
    rest and the summary as well. Raises WriteError.
    """

    def __init__(self, path: Path, inputs: Inputs, folder: Path | None, system: System) -> None:
        self._path, self._folder, self._system = path, folder, system
        self._headers = {"summary": summary_headers(inputs, system), "problems": list(PROBLEMS)}
        self._headers |= {name: headers_in(headers, system) for name, headers in DETAILS.items()}
        self._headers |= {SHEET: site_headers(system)}
        self._headers |= {name: echo_headers(name, system) for name in ECHO}
        self._book = Book()
        self._tables: dict[str, list[Table]] = {}
        self._files: list[ParquetTable] = []
        self._listed, self._unlisted = Listed(), 0
        self._places = Places(system)
        try:
            self._open(inputs.problems)
        except BaseException:
            self.discard()
            raise

    def _open(self, problems: Sequence[Problem]) -> None:
        with unwritable(self._folder or self._path):
            if self._folder:
                self._folder.mkdir(parents=True, exist_ok=True)
            for name in ALWAYS:
                self._tables[name] = list(self._opened(name))
            self._add_problems(problems)

    def add(self, row: Row, line: Sequence[Any], outcome: Outcome | None) -> None:
        """Add a row of the input: its line of the summary, and its outcome (None where it is invalid), both
        in the unit system of this output."""
        with unwritable(self._folder or self._path):
            self._add("summary", [[value] for value in line])
            if not self._folder:
                self._places.add(dict(zip(self._headers["summary"], line, strict=True)), outcome)
            for name in DETAILS:
                if outcome and rows_in(columns := getattr(outcome, name)):
                    all_of_it = named(row.name, columns)
                    self._add(name, site_columns(all_of_it) if name == SHEET else all_of_it)
            self._add_problems(row.problems)
            if row.member:
                for name in ECHO:
                    if lines := echo_lines(name, row.member, self._system):
                        self._add(name, list(zip(*lines, strict=True)))

    def finish(self, run: Mapping[str, Any]) -> Path:
        """Write what is known of the run, and put everything in its place; the path of the workbook."""
        with unwritable(self._folder or self._path):
            page = self._book.page("run", ("name", "value"))
            unlisted = {"problems beyond the sheet": self._unlisted} if self._unlisted else {}
            for item in chain(run.items(), unlisted.items()):
                page.add(item)
            if self._system != "SI":
                self._settings()
            self._explain()
            for file in self._files:
                file.finish()
            if self._folder:
                for name in FILES:
                    if name not in self._tables:  # nobody uses it: one of an earlier run would mislead
                        (self._folder / f"{name}.parquet").unlink(missing_ok=True)
        return self._book.save(self._path)

    def _settings(self) -> None:
        """The unit system, for whoever runs the results again: loads name no unit."""
        page = self._book.page("settings", ("name", "value"), self._place("settings"))
        page.add(("units", self._system))

    def _explain(self) -> None:
        """Filters on the tables; legend and viewer, which come when all rows are known."""
        for name in ("summary", "problems", *DETAILS):
            for table in self._tables.get(name, ()):
                if isinstance(table, Page):
                    table.filtered()
        page = self._book.page("legend", LEGEND)
        for line in legend(
            {name: headers for name, headers in self._headers.items() if name in self._tables}
        ):
            page.add(line)
        if self._places.places:
            write_viewer(self._book, self._places, self._place("viewer"))

    def discard(self) -> None:
        """Delete what is not in its place."""
        self._book.discard()
        for file in self._files:
            file.discard()

    def _opened(self, name: str) -> Iterator[Table]:
        """Where a table goes."""
        filed = self._folder is not None and name in FILES
        if not filed or name == "summary":
            dress = coloured if name == "summary" else None
            comments = notes(name, self._headers[name])
            yield self._book.page(name, self._headers[name], self._place(name), comments, dress)
        if filed:
            assert self._folder is not None
            reasons = name == "summary"
            file = ParquetTable(self._folder / f"{name}.parquet", fields(name, self._headers[name]), reasons)
            self._files.append(file)
            yield file

    def _place(self, name: str) -> int:
        """Place of a new sheet among those that there are."""
        return sum(ORDER.index(other) < ORDER.index(name) for other in self._book.names)

    def _add(self, name: str, columns: Sequence[Sequence[Any]]) -> None:
        """Add rows to a table, which is opened with the first of them."""
        if name not in self._tables:
            self._tables[name] = list(self._opened(name))
        for table in self._tables[name]:
            try:
                table.extend(columns)
            except FullSheetError as error:
                raise FullSheetError(f"{error}; {CURE}") from None

    def _add_problems(self, problems: Sequence[Problem]) -> None:
        """List new problems, up to what the sheet takes."""
        (page,) = self._tables["problems"]
        for problem in self._listed.new(problems):
            try:
                page.extend([[value] for value in problem.row()])
            except FullSheetError:
                self._unlisted += 1
