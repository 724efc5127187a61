"""The tendon stage by stage: least, mean and largest stress, of the analysis and analytic."""

from typing import NamedTuple

import numpy as np

from ptbatch.report.words import DASH, Words
from ptbatch.response import STAGES
from ptbatch.workbook.stored import Stored, Table

X, FE, ANALYTIC = "x [mm]", "stress_fe [MPa]", "stress_analytic [MPa]"
MEANINGS = {
    "jacked": "live ends pulled",
    "set": "wedges drawn in",
    "anchored": "jacks away",
    "service": "time has taken its part",
    "peak": "largest live load",
    "end": "end of the curve",
}
KNOWN = {  # of the summary: as exact as the analysis has it
    "anchored": tuple(f"stress_anchored_{name} [MPa]" for name in ("min", "mean", "max")),
    "peak": ("", "tendon_stress_peak_mean [MPa]", "tendon_stress_peak_max [MPa]"),
}


class Stage(NamedTuple):
    """A stage and its stresses: least, mean, largest of the analysis, then analytic ones."""

    name: str
    meaning: str
    fe: tuple[str, ...]
    analytic: tuple[str, ...]


def stages(stored: Stored) -> list[Stage]:
    """The stages that were reached."""
    lines = {name: stored.tendon.stage(name) for name in STAGES}
    return [
        Stage(name, MEANINGS[name], _fe(stored, name, line), _three(stored, line, ANALYTIC))
        for name, line in lines.items()
        if len(line)
    ]


def _fe(stored: Stored, name: str, line: Table) -> tuple[str, ...]:
    known = [stored.value(header) for header in KNOWN.get(name, ("", "", ""))]
    along, words = _three(stored, line, FE), Words(stored.system)
    return tuple(
        words.number(v, "MPa") if np.isfinite(v) else text for v, text in zip(known, along, strict=True)
    )


def _three(stored: Stored, line: Table, header: str) -> tuple[str, ...]:
    """Least, mean over x, largest; dashes where there is no curve."""
    x, stress = line.numbers(X), line.numbers(header)
    if not np.isfinite(stress).all() or len(x) < 2:
        return (DASH,) * 3
    mean = float(np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(x)) / (x[-1] - x[0]))
    words = Words(stored.system)
    return tuple(words.number(value, "MPa") for value in (float(stress.min()), mean, float(stress.max())))


def camber(stored: Stored) -> str:
    """Camber after anchoring, or why there is none, and when time has taken its part, if that is known."""
    text = _length(stored, "camber_anchored [mm]")
    if np.isfinite(stored.value("camber_service [mm]")):
        later = _length(stored, "camber_service [mm]")
        text += f"; under the sustained load, when time has taken its part: {later}"
    return text


def _length(stored: Stored, name: str) -> str:
    words = Words(stored.system)
    text = words.said(stored.summary.get(name), "mm")
    return f"{text} {words.unit('mm')}" if np.isfinite(stored.value(name)) else text
