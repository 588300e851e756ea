"""Exports over HTTP: the bytes of `sigcat export`, JSON while it is made."""

import io
import zipfile

import pytest

from sigcat.api.application import create_app
from sigcat.catalogue.exporting import json_stream
from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.catalogue.exporting.json_stream import json_parts
from sigcat.catalogue.hosting.library import Library, Source, load, shipped_sources
from tests.api.conftest import Ask, asker

CLEAN = "/api/v1/catalogues/clean"
TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, description: How fast it moves., ASILlevel: B}
Vehicle.Door: {type: branch, instances: [Left, Right], description: A door.}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether it stands open.}
"""


@pytest.fixture(scope="module")
def clean(tmp_path_factory: pytest.TempPathFactory) -> Library:
    file = tmp_path_factory.mktemp("clean") / "tree.vspec"
    file.write_text(TREE)
    return Library([Source("clean", "Clean", file)])


@pytest.fixture(scope="module")
def get(clean: Library) -> Ask:
    return asker(create_app(clean))


def test_json_is_what_the_command_writes(get: Ask, clean: Library) -> None:
    answer = get(f"{CLEAN}/export/json")
    assert answer.text == tree_json(tree_data(clean.default.catalogue))
    assert answer.headers["content-disposition"] == 'attachment; filename="Vehicle.json"'


OPTIONS: tuple[dict[str, object], ...] = (
    {},
    {"extend-all-attributes": True},
    {"extended-attributes": ["ASILlevel"]},
    {"keep-instances": True},
    {"pretty": True},
)


@pytest.mark.parametrize("options", OPTIONS, ids=str)
@pytest.mark.parametrize("at_once", [0, 3, 500])
def test_the_stream_is_the_whole_byte_for_byte(
    options: dict[str, object], at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(json_stream, "_AT_ONCE", at_once)
    catalogue = load(shipped_sources()[0])
    names = {name.replace("-", "_"): value for name, value in options.items()}
    kept, pretty = names.pop("extended_attributes", ()), names.pop("pretty", False)
    wanted = {"all_extended": names.pop("extend_all_attributes", False), **names}
    whole = tree_json(tree_data(catalogue, kept, **wanted), pretty=pretty)  # type: ignore[arg-type]
    assert b"".join(json_parts(catalogue, options)).decode() == whole


def test_the_stream_begins_before_the_tree_is_written() -> None:
    parts = json_parts(load(shipped_sources()[1]), {})
    assert next(parts) == b'{"Vehicle": '
    assert max(map(len, parts)) < 400_000


def test_options_are_spelled_as_parameters(get: Ask) -> None:
    assert get(f"{CLEAN}/export/json?pretty=true").text.startswith('{\n  "Vehicle"')
    narrow = get(f"{CLEAN}/export/json?expand=false").json()
    assert "instances" in narrow["Vehicle"]["children"]["Door"]


@pytest.mark.parametrize("query", ["prety=true", "pretty=perhaps", "types_output=a", "output=/etc/passwd"])
def test_an_option_that_does_not_fit_is_refused_by_name(get: Ask, query: str) -> None:
    refused = get(f"{CLEAN}/export/json?{query}")
    assert refused.status_code == 422
    assert query.partition("=")[0] in refused.json()["detail"]


def test_an_option_of_another_format_is_refused_by_name(get: Ask) -> None:
    assert "'pretty'" in get(f"{CLEAN}/export/yaml?pretty=true").json()["detail"]


@pytest.mark.parametrize("query", ["pretty=false", "expand=true", "strict=no&expand=1", "pretty=FALSE"])
def test_an_option_may_be_given_as_it_is_anyway(get: Ask, query: str) -> None:
    assert get(f"{CLEAN}/export/json?{query}").content == get(f"{CLEAN}/export/json").content


def test_a_flag_may_stand_alone(get: Ask) -> None:
    assert get(f"{CLEAN}/export/json?pretty").content == get(f"{CLEAN}/export/json?pretty=true").content


def test_a_list_is_given_by_repeating_it(get: Ask) -> None:
    kept = get(f"{CLEAN}/export/json?extended_attributes=ASILlevel&extended_attributes=Other").json()
    assert kept["Vehicle"]["children"]["Speed"]["ASILlevel"] == "B"


def test_a_format_of_vss_tools_is_run_in_a_process_of_its_own(get: Ask) -> None:
    table = get(f"{CLEAN}/export/csv")
    assert table.headers["content-type"].startswith("text/csv")
    assert b"Vehicle.Speed" in table.content


def test_a_folder_becomes_a_zip(get: Ask) -> None:
    archive = get(f"{CLEAN}/export/ros2interface")
    assert archive.headers["sigcat-warnings"] == "0"
    assert archive.headers["content-type"] == "application/zip"
    names = zipfile.ZipFile(io.BytesIO(archive.content)).namelist()
    assert any(name.endswith(".msg") for name in names)


def test_warnings_of_an_export_are_counted(get: Ask) -> None:
    assert get(f"{CLEAN}/export/apigear").headers["sigcat-warnings"] == "1"  # no layer is named


def test_an_export_of_another_version_is_refused(get: Ask) -> None:
    assert get(f"{CLEAN}/export/json", headers={"If-Match": '"1"'}).status_code == 412
    assert get(f"{CLEAN}/export/json", headers={"If-Match": "*"}).status_code == 200


def test_an_unknown_format_proposes_near_ones(get: Ask) -> None:
    refused = get(f"{CLEAN}/export/jsn")
    assert (refused.status_code, refused.json()["nearest"][0]) == (404, "json")


def test_a_tree_with_errors_is_not_exported(ask: Ask) -> None:
    refused = ask("/api/v1/catalogues/broken/export/json")
    assert refused.status_code == 422
    assert refused.json()["findings"]
