"""Whether the solver arrives: `python -m benchmarks.robustness` analyses a population, prints how it ended.

Prints how many members ended in which way, every member that did not arrive with its message, the largest
imbalance of any accepted step, and how iterations and time are distributed.
"""

import argparse
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from time import thread_time

import numpy as np

from benchmarks.population import population
from ptbatch.analysis import analyse
from ptbatch.member import Member

SHARES = (10, 50, 90, 99, 100)  # per cent


@dataclass(frozen=True)
class Outcome:
    """How one member ended."""

    member: str
    status: str
    failure: str
    message: str
    iterations: int
    residual: float
    seconds: float


def outcome(member: Member) -> Outcome:
    """Analyse a member."""
    start = thread_time()
    response = analyse(member)
    return Outcome(
        member.member,
        response.status,
        response.failure,
        response.message,
        response.newton_iterations,
        response.residual_max,
        thread_time() - start,
    )


def report(outcomes: list[Outcome]) -> list[str]:
    """Lines to print."""
    arrived = [o for o in outcomes if o.status == "ok"]
    ends = Counter(o.failure for o in arrived)
    lines = [f"{len(arrived)} of {len(outcomes)} members arrived"]
    lines += [f"  {count:5}  {end}" for end, count in ends.most_common()]
    lines += [f"  {o.member}: {o.status}, {o.message}" for o in outcomes if o.status != "ok"]
    lines += [f"largest imbalance of an accepted step: {max(o.residual for o in outcomes):.1e}"]
    lines += ["share of the members [%]  " + "".join(f"{share:>9}" for share in SHARES)]
    for name, values, form in (
        ("iterations, at most", [o.iterations for o in outcomes], "9.0f"),
        ("milliseconds, at most", [1e3 * o.seconds for o in outcomes], "9.1f"),
    ):
        lines += [f"{name:26}" + "".join(f"{value:{form}}" for value in np.percentile(values, SHARES))]
    return lines


def main() -> None:
    """Run it."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--members", type=int, default=1000)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    chosen = options.parse_args()
    members = population(chosen.members, chosen.seed)
    outcome(members[0])  # compiles, which is not to be timed
    with ThreadPoolExecutor(chosen.jobs) as pool:
        print(*report(list(pool.map(outcome, members))), sep="\n")


if __name__ == "__main__":
    main()
