"""Results in the units of the input, or in those that were asked for."""

import json

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook
from ptbatch.cli import exit_code
from ptbatch.compare.regression import compare_results
from ptbatch.compare.results import read_results
from ptbatch.member import Member
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.results import DETAILS, SUMMARY
from ptbatch.workbook.stored import read_all
from ptbatch.workbook.systems import headers_in, sentence_in, typical, written
from ptbatch.workbook.units import factor

US = {
    "member": "B1", "span [ft]": "30", "b [in]": 12, "h [in]": 24, "fc [psi]": 5000, "Aps [in2]": 0.918,
    "dp [in]": "12; 20; 12", "fpj [ksi]": 202.5, "As [in2]": 1.2, "ds [in]": 21.5, "w_dead [plf]": 400,
    "w_live [klf]": 0.8, "elements": 4, "layers": 10,
}  # fmt: skip
KINDS = {
    "span": "length", "b": "length", "h": "length", "fc": "stress", "Aps": "area", "dp": "length",
    "fpj": "stress", "As": "area", "ds": "length", "w_dead": "line load", "w_live": "line load",
}  # fmt: skip
SI_UNIT = {"length": "m", "stress": "MPa", "area": "mm2", "line load": "kN/m"}
LOADS = [{"member": "B1", "case": "dead", "type": "point", "x": 100, "value": 3}]
SKIPPED = ("time [ms]", "newton_iterations", "residual_max")


def in_si() -> dict:
    """The same row as an engineer would type it in SI units."""
    row = {}
    for header, value in US.items():
        name = header.partition(" ")[0]
        if name not in KINDS:
            row[header] = value
            continue
        unit = header[header.index("[") + 1 : -1]
        to = factor(KINDS[name], unit) / factor(KINDS[name], SI_UNIT[KINDS[name]])
        numbers = [repr(float(part) * to) for part in str(value).split(";")]
        row[f"{name} [{SI_UNIT[KINDS[name]]}]"] = (
            "; ".join(numbers) if len(numbers) > 1 else float(numbers[0])
        )
    return row


@pytest.mark.parametrize(
    ("si", "us"),
    [
        ("concrete crushing at x = 6096 mm under the load", "concrete crushing at x = 240 in under the load"),
        ("beyond 4.4482216 kN, deflection 25.4 mm", "beyond 1 kip, deflection 1 in"),
        ("at 99.6% of the stage; 3 mmm", "at 99.6% of the stage; 3 mmm"),
        ("0 to 25.4 mm; 30.48 mm to 3.048 m", "0 to 1 in; 1.2 in to 10 ft"),
        ("8 to 5 of it; 14.593903 kN/m; 3 kN/mm; 2 of 5 m", "8 to 5 of it; 1 kip/ft; 3 kN/mm; 2 of 16.4 ft"),
    ],
)
def test_messages_are_in_the_units_of_the_results(si, us):
    assert sentence_in(si, "US") == us
    assert sentence_in(si, "SI") == si


def table(path, name) -> list[dict]:
    rows = load_workbook(path)[name].iter_rows(values_only=True)
    headers = next(rows)
    return [dict(zip(headers, row, strict=True)) for row in rows]


@pytest.mark.parametrize(
    ("headers", "system"),
    [
        ([], "SI"),
        (["member", "mu [1/rad]"], "SI"),
        (["span [ft]", "b [in]", "mu [1/rad]"], "US"),
        (["span [ft]", "b [in]", "fc [psi]", "set [mm]"], "US"),
        (["span [m]", "span [ft]", "fc [MPa]", "fc [ksi]"], "SI"),
        (["span [m]", "b", "h"], "SI"),
    ],
)
def test_results_are_in_the_units_of_the_headers(headers, system):
    assert typical(headers) == system


@pytest.mark.parametrize("header", [*SUMMARY, *(h for headers in DETAILS.values() for h in headers)])
def test_every_header_goes_and_comes_back(header):
    other, there = written(header, "US")
    again, back = written(other, "SI")
    assert again == header
    assert there * back == pytest.approx(1.0, rel=1e-15)
    assert not {"[mm]", "[MPa]", "[kN]", "[kN m]"} & {other[other.find("[") :]}


@pytest.mark.parametrize(
    ("header", "us", "one"),
    [
        ("x [mm]", "x [in]", 1 / 25.4),
        ("stress_fe [MPa]", "stress_fe [ksi]", 0.14503773773020923),  # NIST SP 811: 1 ksi = 6.894757 MPa
        ("load [kN]", "load [kip]", 0.2248089430997105),  # 1 lbf = 4.4482216152605 N exactly
        ("moment_peak [kN m]", "moment_peak [kip ft]", 0.7375621492772654),
        ("time [ms]", "time [ms]", 1.0),
    ],
)
def test_units_of_the_us(header, us, one):
    assert written(header, "US") == (us, pytest.approx(one, rel=1e-14))


def same(one, two) -> bool:
    """Whether two members are the same but for the last digit, which a factor may have moved."""
    if isinstance(one, float):
        return two == pytest.approx(one, rel=4e-16)
    if isinstance(one, tuple):
        return len(one) == len(two) and all(map(same, one, two))
    return one == two


def fields(inputs) -> tuple:
    """What the first member is made of."""
    return values(inputs.rows[0].member)


def values(member) -> tuple:
    """Its fields in their order."""
    return tuple(getattr(member, name) for name in Member.__dataclass_fields__)


def test_the_same_member_in_either_system_gives_the_same_answer(book):
    """Closed form: it is one member. The analysis itself, to what statics is checked to."""
    us, si = (run_workbook(book(row, name=f"{i}.xlsx")).path for i, row in enumerate((US, in_si())))
    (one,), (two,) = table(us, "summary"), table(si, "summary")
    assert list(one)[3:] == headers_in(list(two)[3:], "US")
    for header, value in two.items():
        name, times = written(header, "US")
        if header in SKIPPED:
            continue
        if isinstance(value, float):
            assert one[name] == pytest.approx(value * times, rel=1e-6), header
        else:
            assert one[name] == value
    lines = compare_results(read_results(us), read_results(si), 1e-6)
    assert len(lines) > 20
    assert {line.verdict for line in lines} == {"pass"}


def test_units_can_be_asked_for(book, engine, capsys):
    source = book(in_si() | {"live": "uniform"}, loads=LOADS)
    assert exit_code(["run", str(source), "--units", "US", "--json"]) == 0
    (record,) = json.loads(capsys.readouterr().out)
    path = source.with_name(f"{source.stem}.results.xlsx")
    assert record["load_peak [kip]"] == table(path, "summary")[0]["load_peak [kip]"]
    for name, headers in DETAILS.items():
        if name in ("checks", "elongation", "losses", "moments", "reactions"):  # the stand-in makes none
            continue
        assert list(table(path, name)[0]) == headers_in(headers, "US")
    assert {row["name"]: row["value"] for row in table(path, "run")}["units of the results"] == "US"
    legend = {(row["sheet"], row["column"]): row["unit"] for row in table(path, "legend")}
    assert legend["curves", "moment_max"] == "kip ft"


def test_a_setting_of_units_counts_for_results_too(book, engine):
    row = {key.partition(" ")[0]: value for key, value in US.items()} | {"fc": 5, "w_dead": 0.4}
    path = run_workbook(book(row, settings=[{"name": "units", "value": "US"}])).path
    assert "load_peak [kip]" in table(path, "summary")[0]


def test_results_in_us_units_can_be_run_again_and_read_back(book, engine):
    """Loads name no unit, so that the results say which system they are in."""
    source = book(in_si(), loads=LOADS)
    first = run_workbook(source, units="US").path
    again = run_workbook(first).path
    assert same(fields(read_inputs(first)), fields(read_inputs(source)))
    assert "load_peak [kip]" in table(again, "summary")[0]
    (si,) = read_all(run_workbook(source, source.with_name("si.xlsx")).path)
    (us,) = read_all(first)
    assert same(values(us.member), values(si.member))
    for header in ("x [mm]", "stress_fe [MPa]"):
        assert us.tendon.numbers(header) == pytest.approx(si.tendon.numbers(header), rel=1e-12)
    assert us.value("moment_peak [kN m]") == pytest.approx(si.value("moment_peak [kN m]"), rel=1e-12)
