"""An integration starts from resolved functions: findings point into the file, and carried definitions are used."""

from collections import Counter

import pytest

from sigcat.errors import InputRefused
from sigcat.function.declaration.scaffold import scaffold
from sigcat.function.function_file import build_function
from sigcat.function.function_json.model import to_json
from sigcat.function.function_json.wire import WireModel
from sigcat.function.sets.check_set import check_functions
from sigcat.integration.declared_fields import TARGETS, target
from sigcat.integration.reading import read_functions
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.function.shipped import FUNCTIONS, interfaces

TEXT = scaffold("Parking")
DISTANCE = "Vehicle.ADAS.WallDistance"
DEFINED = f"  data:\n    {DISTANCE}: {{type: sensor, datatype: float, unit: m, description: Distance to the wall.}}\n"
PROVIDED = f"data:\n          - {{path: {DISTANCE}, role: provided, name: Distance, variable: out.distance, asil: QM, init: 0.0}}"
PROVIDING = TEXT.replace("data:\n", f"{PROVIDED}\n", 1).replace("define:\n", f"define:\n{DEFINED}", 1)
CONSUMING = scaffold("Warning").replace("path: Vehicle.Speed", f"path: {DISTANCE}").replace("in.speed", "in.distance")


def found(data, name, platform="ros2"):
    read = read_functions([(data, name)], interfaces())
    return {finding.rule: finding for finding in integrate(PLATFORMS[platform], read.functions).findings}


def line_at(text, finding):
    """The text of the file from the position of a finding on, to the end of the line."""
    return text.splitlines()[finding.line - 1][finding.column - 1 :]


def test_a_finding_about_a_field_stands_where_its_author_wrote_it():
    text = TEXT.replace("            asil: QM\n", "            asil: B\n", 1)
    assert text != TEXT
    finding = found(text.encode(), "parking.yaml")["N201"]
    assert (finding.file, line_at(text, finding)) == ("parking.yaml", "B")
    assert finding.pointer == "/components/0/runnables/1/data/0/asil"


def test_a_finding_about_what_the_catalogue_says_stands_at_the_reference():
    text = next(path for path in FUNCTIONS if path.parent.name == "core_acc").read_text(encoding="utf-8")
    finding = found(text.encode(), "acc.yaml")["N202"]
    assert finding.path == "CoreAcc_Step"
    assert line_at(text, finding).startswith("interface: CoreAcc_Step")


def test_in_function_json_it_stands_at_the_field():
    data = to_json(build_function(TEXT.encode(), "parking.yaml", interfaces())[0])
    text = data.decode().replace('"Scheduling": "Preemptive"', '"Scheduling": "Sometimes"', 1)
    assert text != data.decode()
    finding = found(text.encode(), "parking.json", "autosar-adaptive")["A011"]
    assert finding.file == "parking.json"
    assert finding.pointer.endswith("/Scheduling")
    assert line_at(text, finding).startswith('"Sometimes"')


@pytest.mark.parametrize("platform", PLATFORMS)
def test_every_finding_about_an_example_has_a_position(platform):
    files = [(path.read_bytes(), str(path)) for path in FUNCTIONS]
    findings = integrate(PLATFORMS[platform], read_functions(files, interfaces()).functions).findings
    assert [finding for finding in findings if not (finding.file and finding.line and finding.column)] == []


def test_what_a_function_json_carries_the_others_may_use():
    carrying = to_json(build_function(PROVIDING.encode(), "parking.yaml", interfaces())[0])
    consuming = (CONSUMING.encode(), "warning.yaml")
    with pytest.raises(InputRefused) as alone:
        read_functions([consuming], interfaces())
    assert [finding.rule for finding in alone.value.findings if finding.severity == "error"] == ["F010"]
    read = read_functions([(carrying, "parking.json"), consuming], interfaces())
    assert [function.name for function in read.functions] == ["Parking", "Warning"]


def refused(*files):
    """Rules of the errors for which functions are not integrated."""
    with pytest.raises(InputRefused) as told:
        read_functions(files, interfaces())
    return [finding.rule for finding in told.value.findings if finding.severity == "error"]


def test_what_does_not_fit_together_is_told_as_validate_tells_it():
    consuming = CONSUMING.replace("            asil: QM\n", "            asil: D\n", 1)
    assert consuming != CONSUMING
    files = [(PROVIDING.encode(), "parking.yaml"), (consuming.encode(), "warning.yaml")]
    read = read_functions(files, interfaces())
    assert "F110" in {finding.rule for finding in read.findings}
    assert read.findings == check_functions(files, interfaces())


def test_function_json_is_compared_with_the_catalogue_too():
    data = to_json(build_function(TEXT.encode(), "parking.yaml", interfaces())[0])
    gone = data.replace(b'"Vehicle.Speed"', b'"Vehicle.Haste"')
    assert gone != data
    assert refused((gone, "parking.json")) == ["F010"]


def names_of_function_json(model=WireModel):
    return {str(field.alias) for field in model.model_fields.values()}.union(
        *map(names_of_function_json, model.__subclasses__())
    )


@pytest.mark.parametrize("part", TARGETS)
def test_each_field_of_a_function_yaml_has_a_place_in_function_json(part):
    fields = {info.alias: str(info.annotation) for info in part.model_fields.values()}
    assert TARGETS[part][1].keys() <= fields.keys()
    holds_others = {key for key, annotation in fields.items() if any(each.__name__ in annotation for each in TARGETS)}
    for key in fields.keys() - holds_others - TARGETS[part][1].keys():
        assert target(part, key).split(": ")[-1] in names_of_function_json()


@pytest.mark.parametrize("platform", PLATFORMS)
def test_the_report_begins_with_what_the_author_wrote(platform):
    read = read_functions([(TEXT.encode(), "some/parking.yaml")], interfaces())
    report = integrate(PLATFORMS[platform], read.functions).report
    written = {entry.field: entry for entry in report if entry.kind == "declaration"}
    assert report[0].kind == "declaration"
    asil = written["components.0.runnables.1.data.0.asil"]
    line = TEXT.splitlines().index("            asil: QM") + 1
    assert (asil.function, asil.interface) == ("Parking", f"parking.yaml:{line}")
    assert "AsilLevel" in asil.target
    assert [entry for entry in written.values() if entry.target == "Function JSON, "] == []


@pytest.mark.parametrize("platform", PLATFORMS)
def test_the_report_of_each_platform_has_every_field_that_has_a_value(platform):
    (function,) = read_functions([((FULL / "function.yaml").read_bytes(), "full.yaml")], interfaces()).functions
    filled = Counter(_filled(function.function))
    report = integrate(PLATFORMS[platform], [function]).report
    told = Counter(entry.field for entry in report if entry.kind != "declaration")
    assert len(filled) > 70
    assert filled - told == Counter()


def _filled(function):
    """The names of the fields that have a value, of each call and of each of its interfaces."""
    for component in function.components:
        for call in component.runnables:
            parts = [call, *(each for contract in call.contracts or () for each in _interfaces(contract))]
            yield from (name for part in parts for name, value in _fields(part) if value not in (None, (), [], {}))


def _interfaces(contract):
    return [each for _, value in _fields(contract) if isinstance(value, list | tuple) for each in value]


def _fields(model):
    return [(field.alias or name, getattr(model, name)) for name, field in type(model).model_fields.items()]
