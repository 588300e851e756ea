"""Official releases: the same tree as vss-tools makes of them, expanded and not, bare and with their own overlays."""

import json
from functools import cache
from pathlib import Path

import pytest

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.cli import main
from tests.catalogue.vss_tools_output import Job, outputs
from tests.needs import IS_SLOW_RUN, OFFICIAL, official_releases
from tests.reference_tools import checked_with

pytestmark = official_releases

OVERLAYS = ("", "extensions/OBD", "extensions/dual_wiper_systems", "profiles/motorbike")
USUAL = (("v6.0", "extensions/OBD", "--expand"), ("v5.0", "", "--no-expand"))
CASES = [
    (release, overlay, expand)
    for release in ("v5.0", "v6.0")
    for overlay in OVERLAYS
    for expand in ("--expand", "--no-expand")
    if IS_SLOW_RUN or (release, overlay, expand) in USUAL
]


def arguments(release: str, overlay: str, expand: str) -> list[str]:
    folder = OFFICIAL / release
    chosen = ["-l", str(folder / "overlays" / f"{overlay}.vspec")] if overlay else []
    return ["-s", str(folder / "spec" / "VehicleSignalSpecification.vspec"), *chosen, expand]


@cache
def expected_outputs(units: Path) -> dict[str, str | None]:
    """Return the result of vss-tools for each case. It refuses the units of v6.0, so it gets corrected ones."""
    corrected = ["-u", str(units)]
    return outputs(
        {
            " ".join(case): Job("json", OFFICIAL, [*arguments(*case), *(corrected if case[0] == "v6.0" else [])])
            for case in CASES
        }
    )


@pytest.fixture(scope="module")
def corrected_units(tmp_path_factory):
    """The units of v6.0 with a separate name for `mpg`, as in the next release."""
    text = (OFFICIAL / "v6.0/spec/units.yaml").read_text()
    head, _, tail = text.partition("\nmpg:\n")
    tail = tail.replace("unit: miles per US gallon\n", "unit: miles per US gallon (deprecated)\n", 1)
    file = tmp_path_factory.mktemp("units") / "units.yaml"
    file.write_text(f"{head}\nmpg:\n{tail}")
    return file


@checked_with("vss-tools", "Official releases and their overlays have the same meaning, expanded and not")
@pytest.mark.parametrize("case", CASES, ids=" ".join)
def test_the_export_equals_that_of_vss_tools(case, corrected_units, capsys):
    output = expected_outputs(corrected_units)[" ".join(case)]
    assert output is not None
    assert main(["export", "json", *arguments(*case)]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads(output)


def test_the_double_unit_name_of_v6_is_a_warning_and_nothing_else_is_found():
    findings = read_catalogue(OFFICIAL / "v6.0/spec/VehicleSignalSpecification.vspec").findings
    assert [(f.rule, f.severity, f.path) for f in findings] == [("U001", "warning", "mpg")]


def test_v5_has_no_findings():
    assert read_catalogue(OFFICIAL / "v5.0/spec/VehicleSignalSpecification.vspec").findings == ()
