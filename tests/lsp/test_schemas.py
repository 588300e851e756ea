"""The schemas of sigcat.toml, overlays and rules accept what sigcat accepts."""

import tomllib

import pytest
import yaml
from jsonschema import Draft202012Validator

from sigcat.data import INTERFACE_RULES, OVERLAYS, VSPEC
from sigcat.platforms.schemas import schema
from tests.project.company import OVERLAY, PROJECT, RULES


@pytest.mark.parametrize("name", ["deployment", "overlay", "project", "rules"])
def test_a_schema_is_one(name: str) -> None:
    """In the dialect that it names."""
    Draft202012Validator.check_schema(schema(name))


def test_the_overlay_schema_accepts_the_shipped_files() -> None:
    """All trees and overlays, and that of a company."""
    validator = Draft202012Validator(schema("overlay"))
    texts = [path.read_text(encoding="utf-8") for folder in (VSPEC, OVERLAYS) for path in folder.rglob("*.vspec")]
    for text in (*texts, OVERLAY):
        validator.validate(yaml.safe_load(text) or {})


def test_the_rules_schema_accepts_rules_with_a_check() -> None:
    """Records that sigcat ships for code that composes or reads are not for a company."""
    validator = Draft202012Validator(schema("rules"))
    checks = schema("rules")["patternProperties"]["^[A-Z]+[0-9]{3}$"]["properties"]["check"]["enum"]
    for text in (*(path.read_text(encoding="utf-8") for path in sorted(INTERFACE_RULES.glob("*.yaml"))), RULES):
        records = yaml.safe_load(text)
        validator.validate({code: record for code, record in records.items() if record["check"] in checks})


def test_the_project_schema_accepts_projects() -> None:
    """The one of the tests, and every table of the linter."""
    validator = Draft202012Validator(schema("project"))
    validator.validate(tomllib.loads(PROJECT))
    validator.validate(
        tomllib.loads('[lint]\nignore = ["V1"]\nseverity = {V006 = "off"}\n[lint.per-file]\n"a" = {V1 = "info"}\n')
    )


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("project", {"catalogs": []}),
        ("project", {"catalogue": [{"id": "acme"}]}),
        ("project", {"lint": {"severity": {"V006": "fatal"}}}),
        ("overlay", {"Vehicle.Speed": {"type": "sensr"}}),
        ("overlay", {"Vehicle.Speed": {"min": "slow"}}),
        ("rules", {"ACME001": {"name": "x"}}),
    ],
)
def test_a_schema_refuses_what_is_misspelled(name: str, value: object) -> None:
    """As an editor shows it."""
    assert not Draft202012Validator(schema(name)).is_valid(value)
