"""The reference beam as an OpenSees model; `python -m benchmarks.opensees_model 20` prints [points,
iterations, seconds]. See benchmarks/opensees.py for what it is compared with."""

import json
import sys
from time import perf_counter
from typing import Any

import numpy as np

from benchmarks.named import FOLLOWED, REFERENCE
from ptbatch.geometry.section import gross_section
from ptbatch.member import Member
from ptbatch.model.arrays import Setup, set_up

JACKING, LIVE = 30, 100  # steps
MOST = 30  # iterations of a step
ALGORITHMS = "Newton", "KrylovNewton", "NewtonLineSearch"
TOLERANCE = 1e-7  # of the jacking force
STIFF = 2e6  # N/mm, of all springs between duct and tendon; the anchors' are ten times as stiff as one
ARM, TENDON = 1000, 2000  # what node numbers of duct and tendon start with
CONCRETE, BARS, STRAND, ACROSS, ANCHOR, FRICTION = 1, 2, 3, 4, 5, 100  # materials


def materials(ops: Any, member: Member) -> None:
    """Concrete that softens in tension, bars, strand, springs."""
    fc, ft, Ec = member.fc, member.ft, member.Ec
    ops.uniaxialMaterial("Concrete02", CONCRETE, -fc, -2.0 * fc / Ec, -0.85 * fc, -0.0038, 0.1, ft, 0.1 * Ec)
    ops.uniaxialMaterial("Steel02", BARS, member.fy, member.Es, 0.01, 18.0, 0.925, 0.15)
    ops.uniaxialMaterial("Steel02", STRAND, member.fpy, member.Ep, 0.01, 18.0, 0.925, 0.15)
    ops.uniaxialMaterial("Elastic", ACROSS, STIFF / member.elements)
    ops.uniaxialMaterial("Elastic", ANCHOR, 10.0 * STIFF / member.elements)


def beam(ops: Any, member: Member, setup: Setup) -> None:
    """Nodes, fibre section, elements, supports."""
    section, x = gross_section(member), setup.mesh.x
    ops.section("Fiber", 1)
    for y, width, thickness in zip(section.y, section.width, section.thickness, strict=True):
        ops.fiber(section.centroid - y, 0.0, width * thickness, CONCRETE)
    for area, depth in zip(member.As, member.ds, strict=True):
        ops.fiber(section.centroid - depth, 0.0, area, BARS)
    ops.geomTransf("Corotational", 1)
    ops.beamIntegration("Legendre", 1, 1, 2)
    for i, place in enumerate(map(float, x)):
        ops.node(i, place, 0.0)
        if i:
            ops.element("dispBeamColumn", i, i - 1, i, 1, 1)
    ops.fix(0, 1, 1, 0)
    ops.fix(len(x) - 1, 0, 1, 0)


def tendon(ops: Any, member: Member, setup: Setup, force: float) -> None:
    """Nodes of the duct on rigid arms, tendon nodes in the same places, trusses between these."""
    x, y = setup.mesh.x, setup.duct.y
    last = len(x) - 1
    slope, stiff = np.diff(y) / np.diff(x), STIFF / member.elements
    for i in range(last + 1):
        ops.node(ARM + i, float(x[i]), float(y[i]))
        ops.node(TENDON + i, float(x[i]), float(y[i]))
        ops.fix(TENDON + i, 0, 0, 1)
        ops.rigidLink("beam", i, ARM + i)
        along = ANCHOR
        if 0 < i < last:
            turn, length = abs(slope[i] - slope[i - 1]), 0.5 * (x[i + 1] - x[i - 1])
            capacity, along = force * (member.mu * turn + member.K * length), FRICTION + i
            ops.uniaxialMaterial("ElasticPP", along, stiff, float(capacity / stiff))
        if i:
            ops.element("corotTruss", TENDON + i, TENDON + i - 1, TENDON + i, member.Aps, STRAND)
            ops.element("zeroLength", ARM + i, ARM + i, TENDON + i, "-mat", along, ACROSS, "-dir", 1, 2)
        else:  # the live end
            ops.element("zeroLength", ARM, ARM, TENDON, "-mat", ACROSS, "-dir", 2)


def set_loads(ops: Any, setup: Setup, force: float) -> None:
    """Jacking with the self-weight; the live pattern stands by."""
    last = len(setup.mesh.x) - 1
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(TENDON, -force, 0.0, 0.0)
    ops.load(ARM, force, 0.0, 0.0)
    for i in range(last + 1):
        ops.load(i, 0.0, *map(float, setup.self_weight[5 * i + 3 : 5 * i + 5]))


def advance(ops: Any, steps: int) -> tuple[int, int, float]:
    """Take steps, each by the first algorithm that arrives; returns how many did, iterations, seconds."""
    iterations, seconds = 0, 0.0
    for step in range(steps):
        for algorithm in ALGORITHMS:
            ops.algorithm(algorithm)
            start = perf_counter()
            failed = ops.analyze(1)
            seconds += perf_counter() - start
            iterations += int(ops.testIter())
            if not failed:
                break
        else:
            return step, iterations, seconds
    return steps, iterations, seconds


def run(ops: Any, elements: int) -> tuple[int, int, float]:
    """Jack, lock, load; returns (points, iterations, seconds in `analyze`)."""
    member = Member(member="15 m beam", **REFERENCE | {"elements": elements})
    setup = set_up(member)
    force = float(member.fpj or 0.0) * member.Aps
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    materials(ops, member)
    beam(ops, member, setup)
    tendon(ops, member, setup, force)
    set_loads(ops, setup, force)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormUnbalance", TOLERANCE * force, MOST)
    ops.integrator("LoadControl", 1.0 / JACKING)
    ops.analysis("Static", "-noWarnings")
    jacked = advance(ops, JACKING)
    ops.loadConst("-time", 0.0)
    ops.element("zeroLength", ARM + TENDON, ARM, TENDON, "-mat", ANCHOR, "-dir", 1)  # born without stress
    ops.pattern("Plain", 2, 1)
    for i in range(len(setup.mesh.x)):
        ops.load(i, 0.0, *map(float, setup.pattern[5 * i + 3 : 5 * i + 5]))
    ops.integrator("DisplacementControl", setup.mesh.control, 2, setup.mesh.sense * FOLLOWED / LIVE)
    loaded = advance(ops, LIVE)
    a, b, c = (one + two for one, two in zip(jacked, loaded, strict=True))
    return int(a), int(b), float(c)


if __name__ == "__main__":
    import openseespy.opensees

    print(json.dumps(run(openseespy.opensees, int(sys.argv[1]))))
