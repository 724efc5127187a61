"""Members to outcomes, on threads: the kernels let go of the interpreter, each row stands for itself."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from time import perf_counter
from typing import Any

from ptbatch.member import Member
from ptbatch.workbook.results import CRACKS, CURVES, SUMMARY, TENDON, Outcome

Progress = Callable[[int, int, str], None]  # rows done, rows in all, the member just finished
NOT_ANALYSED = "not analysed: internal error"


def run_members(members: Sequence[Member], jobs: int = 1, progress: Progress | None = None) -> list[Outcome]:
    """Outcomes in the order of the members. An exception in one row stays in that row."""
    if not members:
        return []
    run = engine()
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        futures = {pool.submit(run, member): member for member in members}
        try:
            for done, future in enumerate(as_completed(futures), 1):
                if progress:
                    progress(done, len(members), futures[future].member)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        return [future.result() for future in futures]


def engine() -> Callable[[Member], Outcome]:
    """The analysis of one member; what it needs is imported here, before any thread starts."""
    from ptbatch.analysis import analyse
    from ptbatch.tables import crack_rows, curve_rows, summary_row, tendon_rows

    def run(member: Member) -> Outcome:
        start = perf_counter()
        try:
            response = analyse(member)
            summary = {"time [ms]": 1e3 * (perf_counter() - start)} | summary_row(member, response)
            return Outcome(
                response.status,
                response.message,
                {header: summary[header] for header in SUMMARY},
                [_checked(row, TENDON) for row in tendon_rows(member, response)],
                [_checked(row, CURVES) for row in curve_rows(member, response)],
                [_checked(row, CRACKS) for row in crack_rows(member, response)],
            )
        except Exception as error:
            return crashed(error)

    return run


def _checked(row: Mapping[str, Any], headers: Sequence[str]) -> dict[str, Any]:
    return {header: row[header] for header in headers if header != "member"}


def crashed(error: Exception) -> Outcome:
    """What is told of a row that the program failed at."""
    message = f"internal error: {type(error).__name__}: {error}; please report it, with this row"
    return Outcome("not converged", message, dict.fromkeys(SUMMARY, NOT_ANALYSED))
