"""From a member to the arrays of the kernels."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.contact import EXPECTED_BACKWARD, EXPECTED_FORWARD, GROUTED
from ptbatch.core.model import Contact, Ends, Model, State
from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import ideal_profile, tendon_profile
from ptbatch.geometry.section import gross_section
from ptbatch.losses import Losses
from ptbatch.member import Member
from ptbatch.model import loading, materials
from ptbatch.model.beam_theory import held_nodes, nodal_loads
from ptbatch.model.duct import Duct, TendonStart, duct, tendon_start, turning_tables
from ptbatch.model.mesh import Mesh, mesh

Array = NDArray[np.float64]

ANCHORAGE = 10.0  # times the contact penalty


@dataclass(frozen=True)
class Setup:
    """What does not depend on the jacking stress: geometry, mesh and loads of a member. Load vectors are
    (ndof,).

    profile: what the analysis works on. ideal: without waves for wobble, what eq. (38) is applied to.
    turning: see `turning_tables`.
    """

    member: Member
    profile: Profile
    ideal: Profile
    mesh: Mesh
    duct: Duct
    turning: tuple[Array, Array, Array]
    live: tuple[bool, bool]
    self_weight: Array
    sustained: Array
    pattern: Array
    live_total: float


def set_up(member: Member) -> Setup:
    """Set a member up."""
    profile = tendon_profile(member)
    grid = mesh(member)
    line = duct(profile, grid.x, gross_section(member).centroid, member.sheathing)
    live = loading.live(member)
    return Setup(
        member,
        profile,
        ideal_profile(member),
        grid,
        line,
        turning_tables(profile, line),
        (member.jack in ("left", "both"), member.jack in ("right", "both")),
        load_vector(grid.x, loading.self_weight(member)),
        load_vector(grid.x, loading.sustained(member)),
        load_vector(grid.x, live),
        loading.total(live),
    )


def load_vector(x: Array, loads: list) -> Array:
    """Loads as a vector (ndof,) in the kernels' numbering."""
    n = len(x) - 1
    vector = np.zeros(5 * n + 7)
    nodal = nodal_loads(x, loads)
    vector[3 : 5 * n + 4 : 5] = nodal[:, 0]
    vector[4 : 5 * n + 5 : 5] = nodal[:, 1]
    return vector


def model(setup: Setup, losses: Losses) -> tuple[Model, State, Ends, TendonStart]:
    """Arrays of a member whose tendon is placed for the stresses of `losses`."""
    member, line, x = setup.member, setup.duct, setup.mesh.x
    n = len(x) - 1
    section = gross_section(member)
    bar_y, bar_area, bar_fy = _bars(member, x, section.centroid)
    start = tendon_start(line, setup.profile, losses, setup.live, member.Ep)
    arrays = Model(
        x,
        section.centroid - section.y,
        section.width * section.thickness,
        section.centroid,
        section.centroid - section.h,
        bar_y,
        bar_area,
        bar_fy,
        line.y,
        line.slope,
        line.s,
        *setup.turning,
        start.position,
        start.rest,
        _held(member, x),
        materials.concrete(member),
        materials.steel(member),
        materials.strand(member),
        _contact(member, materials.penalty(member, member.total_length / n)),
    )
    ends = Ends(np.zeros(2, np.int64), np.zeros(2), np.zeros(2))
    return arrays, _initial_state(arrays, start, setup.live), ends, start


def _contact(member: Member, stiff: float) -> Contact:
    """How tendon and duct hold each other; waves for wobble take the place of K."""
    K = 0.0 if member.wobble == "sine" else float(member.K)
    smooth = member.sheathing == "smooth"
    return Contact(stiff, stiff, ANCHORAGE * stiff, float(member.mu), K, smooth, member.correction)


def _bars(member: Member, x: Array, centroid: float) -> tuple[Array, Array, Array]:
    """Heights (r,), areas by element (n, r) and yield stresses (r,) of all bars with an area."""
    middle = 0.5 * (x[1:] + x[:-1])
    rows = [
        (bar.depth, np.where((middle > bar.x_start) & (middle < bar.x_end), bar.area, 0.0), bar.fy)
        for bar in member.all_bars
    ]
    if not rows:
        return np.zeros(0), np.zeros((len(middle), 0)), np.zeros(0)
    depth, area, fy = zip(*rows, strict=True)
    return centroid - np.array(depth), np.column_stack(area), np.array(fy, dtype=float)


def _held(member: Member, x: Array) -> NDArray[np.bool_]:
    n = len(x) - 1
    held = np.zeros(5 * n + 7, bool)
    held[[1, 5 * n + 6]] = True  # an end node has one degree of freedom
    for node, *fixed in held_nodes(member, x):
        held[5 * node + 2 : 5 * node + 5] |= fixed
    return held


def _initial_state(arrays: Model, start: TendonStart, live: tuple[bool, bool]) -> State:
    n = len(arrays.x) - 1
    u = np.zeros(5 * n + 7)
    u[0], u[-2] = start.gap
    fibres = np.zeros((len(arrays.layer_y), 6, 2 * n))
    bars = np.zeros((n, 2, len(arrays.bar_y)))
    slid = start.s.copy()
    slid[0] = start.gap[0] if live[0] else -0.5 * start.s[1]  # as `end_slip` measures it
    slid[-1] = start.gap[1] if live[1] else 0.5 * start.s[-2]
    motion = np.where(start.moves > 0.0, EXPECTED_FORWARD, EXPECTED_BACKWARD)
    if all(live):
        motion[1 + np.argmin(np.abs(start.moves[1:-1]))] = GROUTED  # between two jacks the tendon rests
    return State(u, fibres, bars, np.zeros(n + 1), start.segment, slid, np.zeros(n + 2), motion)


def half_bandwidth(setup: Setup, start: TendonStart) -> int:
    """Half bandwidth that lets every tendon node reach the segments that it starts in and ends in."""
    away = np.abs(start.segment[1:-1] - np.arange(len(setup.mesh.x) - 1))
    return 9 + 5 * int(away.max())
