"""Dependencies are pinned with their hashes, and exactly where names of theirs are used that are not public."""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from scripts.shipped import shipped

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PAGE = (ROOT / "docs/reference/dependencies.md").read_text(encoding="utf-8")
LOCKED = ("requirements.txt", "requirements-build.txt", "requirements-dev.txt")
OF_PYTHON = "argparse."
"""Private names of the standard library."""


def required() -> Iterator[str]:
    yield from PROJECT["dependencies"]
    for extra in PROJECT["optional-dependencies"].values():
        yield from extra


def private_names() -> dict[str, tuple[str, list[str]]]:
    """Packages by file, with their private names in it, as the page lists them."""
    table = PAGE.split("## Private functions")[1].split("\n## ")[0]
    rows = [row.split(" | ") for row in re.findall(r"^\| (.*) \|$", table, re.MULTILINE)]
    return {file.strip("`"): (package, re.findall(r"`(_\w+)`", names)) for package, names, file, _ in rows[1:]}


@pytest.mark.parametrize("name", LOCKED)
def test_every_package_is_pinned_with_its_hashes_and_without_the_address_of_a_registry(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    pinned = re.findall(
        r"^[a-z0-9.-]+==\S+(?: ; [^\\]+)? \\\n(?:    --hash=sha256:[0-9a-f]{64}(?: \\)?\n)+", text, re.MULTILINE
    )
    assert len(pinned) == len(re.findall(r"^[a-z0-9]", text, re.MULTILINE)) > 0
    assert "://" not in text
    assert not re.search(r"^--(?!hash)", text, re.MULTILINE)


def test_whoever_installs_them_checks_the_hashes() -> None:
    for name in ("Makefile", "Dockerfile"):
        text = (ROOT / name).read_text(encoding="utf-8")
        installing = [
            line
            for line in text.splitlines()
            if re.search(r"requirements[\w-]*\.txt", line) and "--require-hashes" not in line
        ]
        assert not [line for line in installing if "install" in line.lower()], name
        assert "--require-hashes" in text


def test_the_base_image_is_named_by_its_digest() -> None:
    text = (ROOT / "Dockerfile").read_text(encoding="utf-8")
    (image,) = set(re.findall(r"^FROM (\S+)", text, re.MULTILINE))
    assert image == "${PYTHON}"
    assert re.search(r"^ARG PYTHON=python:[\w.-]+@sha256:[0-9a-f]{64}$", text, re.MULTILINE)


def test_packages_whose_private_names_are_used_are_pinned_exactly() -> None:
    for package, _ in private_names().values():
        versions = [each for each in required() if re.split(r"[=<>~! ;\[]", each)[0] == package]
        assert versions
        assert not [each for each in versions if not re.fullmatch(rf"{package}==[\w.]+", each)]


def test_the_page_lists_every_private_name() -> None:
    listed = {file: set(names) for file, (_, names) in private_names().items()}
    for file, names in listed.items():
        text = (ROOT / "app/sigcat" / file).read_text(encoding="utf-8")
        assert not [name for name in names if name not in text], file
    for path in (ROOT / "app/sigcat").rglob("*.py"):
        file = path.relative_to(ROOT / "app/sigcat").as_posix()
        lines = [line for line in path.read_text(encoding="utf-8").splitlines() if "noqa: SLF001" in line]
        for line in lines:
            code = line.partition("#")[0]
            assert OF_PYTHON in code or any(name in code for name in listed.get(file, ())), f"{file}: {line.strip()}"


def test_what_the_container_has_exports_traces() -> None:
    names = {package.name for package in shipped()}
    assert {"opentelemetry-sdk", "opentelemetry-exporter-otlp-proto-http"} <= names
