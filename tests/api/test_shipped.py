"""Shipped packages: the licence of each, the bill of materials, the verdict of an audit."""

import json
import re

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from scripts import audit
from scripts.sbom import bill_of_materials
from scripts.shipped import PERMITTED, REQUIREMENTS, licences_in, shipped


def test_every_pinned_package_is_listed_once() -> None:
    pinned = re.findall(r"^([a-z0-9.-]+)==(\S+)", REQUIREMENTS.read_text(), re.MULTILINE)
    assert [(package.name, package.version) for package in shipped()] == pinned
    assert all(package.needed_by for package in shipped())


@pytest.mark.parametrize("package", shipped(), ids=lambda package: package.name)
def test_every_package_may_be_shipped(package) -> None:
    assert licences_in(package.licence) <= PERMITTED


@pytest.mark.parametrize("licence", ["GPL-3.0-only", "AGPL-3.0-or-later", "unknown", "MIT AND LGPL-2.1-only"])
def test_a_licence_that_reaches_over_would_be_found(licence: str) -> None:
    assert not licences_in(licence) <= PERMITTED


def test_the_bill_of_materials_is_valid_cyclonedx() -> None:
    document = bill_of_materials()
    validator = JsonStrictValidator(SchemaVersion.V1_6)
    assert validator.validate_str(json.dumps(document)) is None
    assert validator.validate_str(json.dumps({**document, "components": [{"type": "nonsense"}]})) is not None


def test_the_bill_of_materials_tells_who_needs_what() -> None:
    needs = {each["ref"]: each["dependsOn"] for each in bill_of_materials()["dependencies"]}
    assert {"fastapi", "vss-tools", "pyyaml"} <= set(needs["sigcat"])
    assert "starlette" in needs["fastapi"]
    assert needs.keys() == {"sigcat", *(package.name for package in shipped())}


KNOWN = {"name": "a", "version": "1", "vulns": []}
BAD = {"name": "b", "version": "2", "vulns": [{"id": "PYSEC-1", "fix_versions": ["3"]}]}


@pytest.mark.parametrize(
    ("packages", "status", "line"),
    [
        ([KNOWN], 0, "1 packages, no known vulnerabilities"),
        ([KNOWN, BAD], 1, "b 2: PYSEC-1, fixed in 3"),
        (
            [KNOWN, {"name": "c", "skip_reason": "not found"}],
            2,
            "not audited: the package index tells nothing of 1 of 2",
        ),
    ],
)
def test_an_audit_says_in_a_line_what_it_found(packages: list[object], status: int, line: str) -> None:
    found, lines = audit.verdict(json.dumps({"dependencies": packages}))
    assert (found, len(lines)) == (status, 1)
    assert line in lines[0]


def test_an_audit_without_the_network_says_so() -> None:
    assert audit.verdict("") == (
        2,
        ["sigcat: not audited: the database of vulnerabilities cannot be reached from here"],
    )
