"""Members that several tests analyse, and short ways through the stages."""

import numpy as np

from ptbatch.analysis import Run, prepare, stress
from ptbatch.losses import analytic_losses
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.stages import jack, sustain

INCH, FOOT, KSI = 25.4, 304.8, 6.894757293168

ELASTIC = dict(concrete_law="elastic", tendon_law="elastic", self_weight=False)
RIGID = ELASTIC | dict(Ec=1e9)

# The paper's imaginary beam, its Fig. 6 and text (published)
IMAGINARY = dict(
    member="imaginary", span=15200, b=254, h=1016, fc=27.6, ft=3.3, Aps=987, Ep=195000,
    dp=(508, 787, 508), fpj=1407, set=0.5, mu=0.3, K=0,
)  # fmt: skip

# Ahmad, SAB4323 example 4.3 (published); the section is ours, the beam being rigid
TWENTY = RIGID | dict(
    member="20 m", span=20000, b=500, h=1200, fc=40, Aps=2850, Ep=195000,
    dp=(300, 858, 300), fpj=1239, set=5, mu=0.25, K=1.7e-6,
)  # fmt: skip
REACHING = TWENTY | dict(member="set reaches the far end", mu=0.10, K=1.7e-7)


def specimen(h: float, wedge_set: float) -> dict:
    """Burns et al.'s specimens as reconstructed: h in inches, wedge_set in mm."""
    depths = (h / 2, h - 3.25, 3.25, h - 3.25, h / 2)
    return dict(
        member=f"specimen {h} in", span=(300 * INCH, 300 * INCH),
        support_left="roller", support_right="roller",
        b=12 * INCH, h=h * INCH, fc=30, Aps=3 * 0.153 * INCH**2, Ep=29000 * KSI,
        dp=tuple(INCH * depth for depth in depths), inflection=0.15, fpj=202 * KSI, set=wedge_set,
        mu=0.07, K=0.001 / FOOT,
    )  # fmt: skip


def jacked(values: dict) -> Run:
    """The member after stage 1."""
    setup = set_up(Member(**values))
    run = prepare(setup, setup.member.fpj)
    jack(run.rig, run.fpj * setup.member.Aps, setup.self_weight)
    return run


def anchored(values: dict) -> Run:
    """The member after stage 3."""
    setup = set_up(Member(**values))
    run = prepare(setup, setup.member.fpj)
    stress(run)
    return run


def sustained(values: dict) -> Run:
    """The member after stage 3 under self-weight and sustained load."""
    run = anchored(values)
    weight = run.setup.self_weight
    sustain(run.rig, (weight, weight + run.setup.sustained), run.setup.member.bond == "bonded")
    return run


def last_row(run: Run, stage: int) -> int:
    """Row of the record where a stage ended."""
    history = run.rig.case.history
    return int(np.flatnonzero(history.stage[: history.rows[0]] == stage)[-1])


def stations(run: Run, stage: int) -> tuple[np.ndarray, np.ndarray]:
    """x of left anchor, middle of each tendon element, right anchor, and the stress there [MPa]."""
    history, setup, row = run.rig.case.history, run.setup, last_row(run, stage)
    s = np.concatenate([setup.duct.s[:1], history.s[row, 1:-1], setup.duct.s[-1:]])
    fine = np.linspace(0.0, setup.duct.x[-1], 4001)
    middle = np.interp(0.5 * (s[1:] + s[:-1]), setup.profile.arc_length(fine), fine)
    force = np.concatenate([history.anchor[row, :1], history.T[row], history.anchor[row, 1:]])
    return np.concatenate([[0.0], middle, fine[-1:]]), force / setup.member.Aps


def closed_form(run: Run, reversal: str = "friction"):
    """Analytic losses of the same member."""
    m = run.setup.member
    return analytic_losses(run.setup.ideal, m.fpj, m.mu, m.K, m.Ep, m.set, m.jack, reversal)


# A little of everything: bars, friction, wobble, a bent tendon; for tests of elements and their assembly
SMALL = dict(
    member="small", span=6000, b=300, h=500, fc=35, Aps=400, dp=(250, 400, 250),
    fpj=1200, set=2, mu=0.15, K=1e-6, As=(300, 200), ds=(450, 420),
    As_top=150, ds_top=50, elements=6, layers=12,
)  # fmt: skip

# Different enough for what holds of every member
KINDS = {
    "imaginary": IMAGINARY | dict(w_dead=5.0),
    "two spans": specimen(22, 3.18) | dict(w_dead=20.0),
    "cracked": SMALL | dict(w_dead=45.0),
    "grouted": SMALL | dict(w_dead=45.0, bond="bonded"),
    "fixed": SMALL | dict(support_left="fixed", w_dead=30.0, jack="both"),
}
