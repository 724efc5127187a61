"""Settings and optional sheets."""

import pytest

from ptbatch.member import Bar, Load
from ptbatch.workbook.inputs import read_inputs


def only_row(path):
    """The one row of a workbook; shows its problems if there is no member."""
    inputs = read_inputs(path)
    assert [str(problem) for problem in inputs.all_problems() if not problem.warning] == []
    return inputs.rows[0]


def setting(name, value):
    return {"name": name, "value": value}


def test_settings_are_defaults(book, beam):
    del beam["fc"]
    rows = [setting("fc [ksi]", 6), setting("mu", 0.2), setting("jack", "Both"), setting("fpe", 1000)]
    member = only_row(book(beam | {"mu": 0.1}, settings=rows)).member
    assert member.fc == pytest.approx(41.368543759)  # closed form
    assert (member.mu, member.jack, member.fpe) == (0.1, "both", None)


def test_us_units_for_headers_without_one(book, beam):
    beam |= {"span": 40, "b": 12, "h": 24, "fc": 6, "Aps": 0.918, "dp": "12;20;12", "fpj": 202.5, "w_live": 1}
    beam |= {"set": 0.25, "density": 150, "K": 0.001, "deflection_limit": 9}
    member = only_row(book(beam, settings=[setting("units", "US")])).member
    assert member.span == pytest.approx((12192.0,))  # closed form, as all below
    assert member.set == pytest.approx(6.35)
    assert member.w_live == pytest.approx(14.593902937)
    assert member.K == pytest.approx(0.001 / 304.8)
    assert member.deflection_limit == pytest.approx(9 * 25.4)
    assert member.fpu == 1860.0  # defaults are what they are, in any system


def test_faulty_settings(book, beam):
    rows = [setting("mu", "0,2"), setting("mue", 1), setting("Ep", 195), setting("Ep", 1)]
    inputs = read_inputs(book(beam, settings=rows))
    assert [(p.place.cell, p.warning) for p in inputs.all_problems()] == [
        ("A3", True),
        ("B2", False),
        ("B5", False),
    ]
    inputs = read_inputs(book(beam, settings=[setting("fpu", 1000)]))
    assert [(p.place.sheet, p.place.cell) for p in inputs.rows[0].problems] == [("members", "H2")]
    inputs = read_inputs(book(beam, settings=[setting("units", "metric")]))
    assert inputs.rows[0].member is None
    assert "unit system" in inputs.rows[0].message


def test_optional_sheets(book, beam):
    profile = [{"member": "B1", "x [m]": x, "dp": d} for x, d in ((0, 300), (5, 500), (12, 300))]
    rebar = [
        {"member": "B1", "x_end [m]": 6, "depth": 550, "area": 400},
        {"member": "B1", "x_start": 1000, "depth": 50, "area": 300, "fy": 500},
    ]
    loads = [
        {"member": "B1", "case": "live", "type": "Point", "x": 4000, "value": 10},
        {"member": "B1", "case": "dead", "type": "uniform", "value": 3},
    ]
    del beam["dp"]
    path = book(beam | {"live": "loads", "fy": 460}, profile=profile, rebar=rebar, loads=loads)
    member = only_row(path).member
    assert member.profile_points == ((0.0, 300.0), (5000.0, 500.0), (12000.0, 300.0))
    assert member.bars == (Bar(0.0, 6000.0, 550.0, 400.0, 460.0), Bar(1000.0, 12000.0, 50.0, 300.0, 500.0))
    assert member.loads == (
        Load("live", "point", 4000.0, 4000.0, 10e3),
        Load("dead", "uniform", 0.0, 12000.0, 3.0),
    )


def test_loads_follow_the_unit_system(book):
    member = {"member": 1, "span": 40, "b": 12, "h": 24, "fc": 6, "Aps": 0.918, "dp": "12;20;12", "fpj": 200}
    loads = [
        {"member": "1", "case": "dead", "type": "point", "x": 240, "value": 1},
        {"member": 1, "case": "dead", "type": "uniform", "value": 1},
    ]
    row = only_row(book(member, loads=loads, settings=[setting("Units", "us")]))
    assert [load.value for load in row.member.loads] == pytest.approx([4448.22161526, 14.593902937])


def test_faults_in_optional_sheets_have_their_cell(book, beam):
    loads = [
        {"member": "B1", "case": "dead", "type": "point", "x": 13000, "value [kN]": 5},
        {"member": "B2", "case": "dead", "type": "point", "x": "3 m", "value [kN]": 5},
        {"member": "B3", "case": "dead", "type": "uniform", "value [kN]": 5},
        {"member": "B4", "case": "dead", "type": "point", "value [kN]": 5},
        {"member": "B9", "case": "dead", "type": "point", "x": 1, "value [kN]": 5},
    ]
    inputs = read_inputs(book(*(beam | {"member": f"B{i}"} for i in range(1, 6)), loads=loads))
    found = {p.place.cell: p.wrong for p in inputs.all_problems()}
    assert "beyond the right end" in found["D2"]
    assert found["D3"] == "a number with something after it"
    assert found["E4"] == "kN is a unit of force, not of line load"
    assert found["D5"] == "missing"
    assert "no such member" in found["A6"]
    assert [row.member is None for row in inputs.rows] == [True, True, True, True, False]


def test_sheet_of_another_kind_is_left_alone(book, beam):
    inputs = read_inputs(book(beam, loads=[{"crane": 7, "tonnes": 10}]))
    assert inputs.rows[0].member is not None
    assert "no column member" in inputs.problems[0].wrong
