"""Files that pages show can be used as they are shown."""

import re
import shutil
import textwrap
import tomllib
from pathlib import Path

import pytest
import yaml

from sigcat.api.read_settings import TABLE, read_settings
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.cli import main
from sigcat.data import ROOT_FILE
from sigcat.function.hosting import FunctionLibrary
from sigcat.project.read_project import CATALOGUE_KEYS, TOP_KEYS, read_project
from sigcat.rules.linting.configuration import FIELDS
from sigcat.rules.linting.selection import rules_for, selected
from sigcat.rules.record import parse_rules
from tests.catalogue.hosting.archives import saved, tar_bytes
from tests.documentation.pages import ROOT, block, blocks, text_of

CONFIGURATION = "docs/reference/configuration.md"
COMPANY = "docs/how-to/own-catalogue-and-rules.md"
PIPELINE = "docs/how-to/pipeline.md"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_configuration_of_the_linter_is_one(folder):
    (folder / "generated").mkdir()
    shutil.copytree(ROOT / "vspec", "vspec")
    Path("our-rules.yaml").write_text(block(COMPANY, "yaml", "ACME001"))
    Path("sigcat.toml").write_text(block(CONFIGURATION, "toml", "[lint]"))
    options = read_project(Path("sigcat.toml")).lint
    codes = {rule.id: rule for rule in selected(rules_for(options), options)}
    assert {"ACME001", "P001"} <= set(codes)
    assert codes["V102"].severity == "error"
    assert codes["V102"].options["prefixes"] == ["Is", "Has"]


def test_every_key_of_the_linter_is_documented():
    table = text_of(CONFIGURATION).split("## Lint")[1].split("## Service")[0]
    assert set(FIELDS) <= set(re.findall(r"`([a-z-]+)`", table))


def test_every_key_of_the_project_is_documented():
    text = text_of(CONFIGURATION)
    keys = {*TOP_KEYS, *CATALOGUE_KEYS} - {"catalogue", "service", "lint"}
    assert [key for key in sorted(keys) if key not in text] == []
    assert {"[[catalogue]]", "[lint]", "[service]"} <= set(re.findall(r"\[+[a-z]+\]+", text))


def test_the_catalogues_of_the_configuration_are_some(folder, monkeypatch):
    monkeypatch.setenv("SIGCAT_DATA", str(folder / "data"))
    assert main(["pull", "v5.0", "--from", str(saved(folder, tar_bytes()))]) == 0
    (folder / "trees" / "common").mkdir(parents=True)
    (folder / "overlays").mkdir()
    (folder / "functions").mkdir()
    (folder / "can").mkdir()
    (folder / "common").mkdir()
    for name in ("our-rules.yaml", "common/units.yaml", "common/quantities.yaml", "can/vehicle.dbc", "deployment.yaml"):
        (folder / name).write_text("")
    for name in ("Own.vspec", "units.yaml", "quantities.yaml", "types.vspec"):
        (folder / "trees" / name).write_text("")
    (folder / "overlays" / "body.vspec").write_text("")
    Path("sigcat.toml").write_text(block(CONFIGURATION, "toml", "functions = "))
    configuration = read_project(Path("sigcat.toml"))
    assert [source.id for source in configuration.catalogues] == ["body", "own"]
    assert configuration.is_watching
    assert not configuration.has_shipped_catalogues
    assert configuration.functions == (Path("functions"),)


def test_the_files_of_a_company_fit_together(folder):
    for each in blocks(COMPANY):
        if each.title:
            (folder / each.title).parent.mkdir(parents=True, exist_ok=True)
            (folder / each.title).write_text(each.text)
    assert parse_rules(Path("our-rules.yaml").read_bytes(), "our-rules.yaml", trusted=False).findings == ()
    hosted = read_project(Path("sigcat.toml"), {TABLE: lambda table, _: read_settings(table)})
    assert [source.id for source in hosted.catalogues] == ["acme"]
    assert [file.id for file in FunctionLibrary(hosted.functions, has_shipped=False).files] == ["cabin_noise"]
    assert main(["lint", "functions", "our-rules.yaml"]) == 0


def test_the_suppression_suppresses(folder):
    text = block("docs/reference/linting.md", "yaml", "Vehicle.Cabin.noise")
    Path("noise.vspec").write_text(text)
    assert main(["lint", "noise.vspec"]) == 0
    Path("noise.vspec").write_text(text.replace("  # sigcat: ignore[V101]", ""))
    assert main(["lint", "noise.vspec"]) == 1


def test_hooks_are_those_that_exist():
    hooks = {hook["id"] for hook in yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))}
    named = yaml.safe_load(block(PIPELINE, "yaml", "repos:"))["repos"][0]["hooks"]
    assert {hook["id"] for hook in named} == hooks


def test_python_runs():
    catalogue = read_catalogue(ROOT_FILE)
    names: dict[str, object] = {"catalogue": catalogue}
    for page in ("CONTRIBUTING.md", "docs/reference/exports.md"):
        for each in blocks(page, "python"):
            exec(textwrap.dedent(each.text), names)
    assert names["archive"]
    assert names["PATHS"]


def test_toml_is_toml():
    for each in blocks(CONFIGURATION, "toml"):
        assert tomllib.loads(each.text)
    assert read_settings({}, {})
