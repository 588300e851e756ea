"""Clients that are generated from the running service compile, pass type checks, and do the same round trip: in `make clients` and `make slow`."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from tests.clients.generating import (
    ROOT,
    NoNode,
    check_python_client,
    check_typescript_client,
    lint_with_redocly,
    lint_with_spectral,
    running_service,
)
from tests.needs import slow
from tests.reference_tools import checked_with

DOCUMENT = ROOT / "docs" / "reference" / "openapi.json"


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with running_service() as found:
        yield found


@slow
@checked_with("clients", "Generated clients pass strict type checks and do the same round trip")
def test_a_python_client_passes_mypy_and_does_the_round_trip(address: str, tmp_path: Path) -> None:
    check_python_client(address, tmp_path)


@slow
@checked_with("clients", "Generated clients pass strict type checks and do the same round trip")
def test_a_typescript_client_passes_tsc_and_does_the_round_trip(address: str, tmp_path: Path) -> None:
    try:
        check_typescript_client(address, tmp_path)
    except NoNode as reason:
        pytest.skip(str(reason))


@checked_with("redocly", "The OpenAPI document has no finding")
def test_the_document_passes_the_strict_rules_of_redocly() -> None:
    try:
        lint_with_redocly(DOCUMENT)
    except NoNode as reason:
        pytest.skip(str(reason))


@slow
@checked_with("spectral", "The OpenAPI document has no finding")
def test_the_document_passes_all_rules_of_spectral_once_the_operator_says_who_answers(tmp_path: Path) -> None:
    document = tmp_path / "openapi.json"
    stated = Settings(contact_url="https://signals.example/help", contact_email="help@signals.example")
    document.write_text(json.dumps(create_app(Library(()), stated).openapi()))
    try:
        lint_with_spectral(document)
    except NoNode as reason:
        pytest.skip(str(reason))
