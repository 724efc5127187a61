"""The command line. Nothing heavy is imported before a command needs it."""

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NoReturn

import click

from ptbatch import __version__
from ptbatch.errors import OutputNameError, PtbatchError, UnknownMemberError

if TYPE_CHECKING:
    from threading import Event

    from ptbatch.batch import Progress
    from ptbatch.runner import Outcomes
    from ptbatch.workbook.column import System

OK, FAILED, INVALID_ROWS, UNUSABLE, INTERNAL, INTERRUPTED = 0, 1, 3, 4, 70, 130
FIGURES = ("stress", "redistribution", "load-deflection", "cracks", "profile", "all")

EPILOG = """\b
Exit codes:
  0   all rows ran and pass
  1   a check or a comparison failed
  2   usage
  3   some rows invalid or not converged (results written)
  4   nothing could be read or written
  70  internal error
  130 interrupted by Ctrl-C: the rows in flight were finished and what there is was written; a second Ctrl-C
      stops at once and writes nothing. Either way `run --resume` goes on from there
"""

WORKBOOK = click.argument("workbook", type=click.Path(path_type=Path))


@click.group(epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="ptbatch")
def cli() -> None:
    """Analyse post-tensioned concrete members, one per row of a spreadsheet."""


@cli.command(epilog=EPILOG)
@WORKBOOK
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Results [WORKBOOK.results.xlsx].")
@click.option("--jobs", type=click.IntRange(1), help="Members at a time [number of CPUs].")
@click.option("--only", multiple=True, metavar="MEMBER", help="This member alone; may be repeated.")
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Analyse on the workers of this Dask scheduler, e.g. tcp://HOST:8786; needs ptbatch[cluster].",
)
@click.option("--resume", is_flag=True, help="Analyse only what an unfinished run has not yet.")
@click.option(
    "--parquet",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Write summary and long tables there as Parquet [beside the results if there are over 2,000 rows].",
)
@click.option("--units", type=click.Choice(["SI", "US"]), help="Of the results [those of the input].")
@click.option("--json", "as_json", is_flag=True, help="Print the summary rows to stdout as JSON.")
@click.option("-q", "--quiet", is_flag=True, help="Say nothing but errors; the exit code tells the rest.")
@click.option("-v", "--verbose", is_flag=True, help="Say of each row how it ended, as it is done.")
def run(
    workbook: Path,
    output: Path | None,
    jobs: int | None,
    only: Sequence[str],
    scheduler: str | None,
    resume: bool,
    parquet: Path | None,
    units: "System | None",
    as_json: bool,
    quiet: bool,
    verbose: bool,
) -> int:
    """Analyse the members of WORKBOOK and write a results workbook beside it.

    WORKBOOK is an .xlsx workbook, or one table of members as .csv (UTF-8) or .parquet.

    Each row that is done is kept in a journal beside the results until these are complete. After a kill, or
    Ctrl-C, the same command with --resume takes from it what has not changed: member, settings, program.
    """
    if jobs and scheduler:
        raise click.UsageError("--jobs is for this machine: it goes without --scheduler")
    if quiet and verbose:
        raise click.UsageError("--quiet and --verbose exclude each other")
    from ptbatch.workbook.read_ahead import ReadAhead

    ahead = None if scheduler else ReadAhead(workbook)  # before all else is imported
    from ptbatch.batch import results_path, run_workbook
    from ptbatch.closing import closing_table
    from ptbatch.interrupt import interruptible
    from ptbatch.runner import engine

    if not quiet:
        _say(*_about_journal(output or results_path(workbook), resume))
    jobs, progress = jobs or os.cpu_count() or 1, _progress(quiet, verbose)
    try:
        with interruptible() as stop:
            outcomes = _outcomes_of(scheduler, stop) if scheduler else None
            settings = (workbook, output, jobs, only, progress, outcomes)
            if ahead and ahead.under_way:
                engine()  # there is time to load it
            batch = run_workbook(
                *settings, resume=resume, parquet=parquet, stop=stop, units=units, ahead=ahead
            )
    except UnknownMemberError as error:
        raise click.BadParameter(str(error), param_hint="--only") from error
    if as_json:
        from ptbatch.workbook.results import summary_records

        _print_json(summary_records(batch.headers, batch.lines))
    if not quiet:
        _say(*closing_table(batch))
    if batch.interrupted:
        return INTERRUPTED
    if batch.failed:
        return INVALID_ROWS
    return FAILED if batch.checks_failed else OK


@cli.command(epilog=EPILOG)
@WORKBOOK
def check(workbook: Path) -> int:
    """Validate WORKBOOK without analysing it; every problem is printed with its cell and its cure."""
    from ptbatch.workbook.inputs import read_inputs
    from ptbatch.workbook.problems import Listed

    inputs = read_inputs(workbook)
    listed, invalid = Listed(), 0
    _say(*map(str, listed.new(inputs.problems)))
    for row in inputs.rows:
        _say(*map(str, listed.new(row.problems)))
        invalid += row.member is None
    _say(f"{len(inputs.rows)} rows: {len(inputs.rows) - invalid} valid, {invalid} invalid")
    return INVALID_ROWS if invalid else OK


@cli.command(epilog=EPILOG)
@click.argument("results", type=click.Path(path_type=Path))
@click.argument("published", type=click.Path(path_type=Path))
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Comparison [RESULTS.comparison.xlsx].")
@click.option(
    "--rtol",
    type=click.FloatRange(0.0),
    default=1e-6,
    show_default=True,
    help="Tolerance of numbers that come without one, as a share of them.",
)
@click.option(
    "--markdown", type=click.Path(path_type=Path), metavar="FILE", help="Write a report and its figures."
)
@click.option("--json", "as_json", is_flag=True, help="Print the lines to stdout as JSON.")
def compare(
    results: Path, published: Path, output: Path | None, rtol: float, markdown: Path | None, as_json: bool
) -> int:
    """Compare a results workbook with what is PUBLISHED: pass, fail, or not reproducible, because ...

    PUBLISHED is a table of expected numbers (sheet published, see the README) or the results workbook of
    another run, of which every number and text in summary must be met. The figures that it names in a sheet
    figures are drawn into a folder of that name beside the report.
    """
    from ptbatch.compare.comparison import closing_table, compare_workbooks
    from ptbatch.compare.report import records

    comparison = compare_workbooks(results, published, output, rtol, markdown)
    if as_json:
        _print_json(records(comparison.lines))
    _say(*map(str, comparison.warnings), *closing_table(comparison))
    return FAILED if comparison.failed else OK


@cli.command(epilog=EPILOG)
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--units", type=click.Choice(["SI", "US"], case_sensitive=False), default="SI")
def template(file: Path, units: Literal["SI", "US"]) -> int:
    """Write a workbook to start from to FILE: it runs as it is, with a member of each kind.

    Its headers have comments, its columns drop-down lists and limits, and the optional sheets rows in use.
    """
    from ptbatch.workbook.template import write_template

    _say(f"written: {write_template(file, units)}")
    return OK


@cli.command(epilog=EPILOG)
@WORKBOOK
@click.option("--member", "members", multiple=True, required=True, metavar="M", help="May be repeated.")
@click.option("--figure", type=click.Choice(FIGURES), help="One figure of all these members [all].")
@click.option("--geometry", is_flag=True, help="Draw section and tendon from an input workbook.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="A .png, .pdf or .svg file, or a folder."
)
def plot(
    workbook: Path, members: Sequence[str], figure: str | None, geometry: bool, output: Path | None
) -> int:
    """Draw members from the results in WORKBOOK.

    \b
    stress           tendon stress after stressing, with the analytic line
    redistribution   tendon stress at the peak and at the end; members laid over each other
    load-deflection  with cracking, yield, peak and failure; members laid over each other
    cracks           cracked depth of every section, after anchoring, at the peak, at the end
    profile          tendon profile, adjusted for wobble and ideal
    all              elevation, section and the first four, a page for each member

    Without -o the figure is written as .png beside WORKBOOK. With --geometry WORKBOOK is an input: elevation
    and section are drawn before any analysis.
    """
    if geometry and figure:
        raise click.UsageError("--geometry draws from an input workbook: it goes without --figure")
    from ptbatch.plots import draw, draw_geometry

    try:
        if geometry:
            drawn = draw_geometry(workbook, members, output)
        else:
            drawn = draw(workbook, members, figure or "all", output)
    except UnknownMemberError as error:
        raise click.BadParameter(str(error), param_hint="--member") from error
    except OutputNameError as error:
        raise click.BadParameter(str(error), param_hint="-o") from error
    _say(*drawn.lacking, *(f"written: {path}" for path in drawn.written))
    return INVALID_ROWS if drawn.lacking else OK


@cli.command(epilog=EPILOG)
def doctor() -> int:
    """Check this installation and say what to do: packages, cache, disk, compiler, a known member.

    Exit code 0 if ptbatch can work, 1 if not.
    """
    from ptbatch.doctor import examine

    faults = 0
    for finding in examine():
        _say(str(finding))
        faults += finding.state == "fault"
    _say(f"{faults} to be put right" if faults else "ptbatch can work here")
    return FAILED if faults else OK


@cli.command(epilog=EPILOG)
@click.argument("results", type=click.Path(path_type=Path))
@click.option("--member", "members", multiple=True, metavar="M", help="May be repeated [all members].")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="An .html file, or a folder [RESULTS.report.html].",
)
def report(results: Path, members: Sequence[str], output: Path | None) -> int:
    """Write the members of RESULTS as one HTML file, to be read and printed.

    An overview, then of each member: drawing, input, tendon stresses by stage, losses with their formulas and
    numbers, capacity, figures and messages. The file needs no other file and no network; the browser prints
    it on A4, each member from a new page. Of a member that is invalid or did not converge it has what exists
    and says why the rest is missing (exit code 3).
    """
    from ptbatch.report import write_report

    try:
        reported = write_report(results, members, output, _reading())
    except UnknownMemberError as error:
        raise click.BadParameter(str(error), param_hint="--member") from error
    except OutputNameError as error:
        raise click.BadParameter(str(error), param_hint="-o") from error
    _say(*reported.lacking, f"written: {reported.path}")
    return INVALID_ROWS if reported.lacking else OK


def main(args: Sequence[str] | None = None) -> NoReturn:
    """Run the command line and leave with its exit code."""
    code = exit_code(args)
    if code == INTERRUPTED:  # at once: leaving in the usual way would wait for the rows in flight
        sys.stdout.flush()
        os._exit(code)
    sys.exit(code)


def exit_code(args: Sequence[str] | None = None) -> int:
    """Exit code of a command line; errors are told on stderr."""
    try:
        return cli.main(args, prog_name="ptbatch", standalone_mode=False) or OK
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except PtbatchError as error:
        _say(f"Error: {error}")
        return UNUSABLE
    except (click.Abort, KeyboardInterrupt):
        _say("interrupted; no results were written")
        return INTERRUPTED
    except Exception as error:
        import traceback

        _say(traceback.format_exc(), f"Internal error, please report it: {type(error).__name__}: {error}")
        return INTERNAL


def _outcomes_of(scheduler: str, stop: "Event") -> "Outcomes":
    from ptbatch.cluster.outcomes import on_cluster

    return on_cluster(scheduler, stop)


def _say(*lines: str) -> None:
    for line in lines:
        click.echo(line, err=True)


def _progress(quiet: bool, verbose: bool) -> "Progress | None":
    """Tells of the rows as they are done: on a terminal, or if each shall have a line of its own. That the
    first run compiles, which takes long, is said elsewhere as well."""
    from ptbatch.core.cache import is_warm

    terminal = sys.stderr.isatty()
    if not (quiet or terminal or is_warm()):
        _say("compiling (first run only)")
    if quiet or not (terminal or verbose):
        return None
    from ptbatch.progress import Meter

    return Meter(lambda text: click.echo(text, err=True, nl=False), terminal, verbose)


def _reading() -> Callable[[int, int, str], None] | None:
    """Rewrites one line of a terminal as members are read and drawn; silent elsewhere."""
    if not sys.stderr.isatty():
        return None

    def show(done: int, total: int, member: str) -> None:
        click.echo(f"\r\x1b[K{done} of {total}  {member}", err=True, nl=done == total)

    return show


def _about_journal(results: Path, resume: bool) -> Iterator[str]:
    """What is unexpected about the journal of an unfinished run: that there is one, or none."""
    from ptbatch.journal.journal import journal_path

    path = journal_path(results)
    if resume and not path.exists():
        yield f"there is no journal {path} of an unfinished run: every row is analysed"
    if path.exists() and not resume:
        yield f"{path} is the journal of an unfinished run: --resume would go on from it"


def _print_json(records: Iterable[dict[str, Any]]) -> None:
    """A list of records, written one by one."""
    import json
    from textwrap import indent

    between = "[\n"
    for record in records:
        text = json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False, default=str)
        click.echo(between + indent(text, "  "), nl=False)
        between = ",\n"
    click.echo("[]" if between == "[\n" else "\n]")
