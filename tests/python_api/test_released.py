"""The Python API is compared with that of the last release: what breaks its users is found, and nothing else."""

from pathlib import Path

import pytest

from scripts.python_api import RELEASED, breaking_changes, release, signatures


def test_the_api_breaks_nothing_of_the_released_one():
    assert breaking_changes(RELEASED.read_text("utf-8"), signatures()) == []


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("class Row(NamedTuple):\n", "class Line(NamedTuple):\n", "Public object was removed"),
        ("    def instances(", "    def copies(", "Public object was removed"),
        ("name: str='text'", "name: str", "Parameter is now required"),
        ("limit: int=50", "limit: int=10", "Parameter default was changed"),
        ("def diff(old: PathLike, new: PathLike)", "def diff(old: PathLike)", "Parameter was removed"),
        ("    former: str\n", "", "Public object was removed"),
    ],
)
def test_what_breaks_users_is_found_and_not_released(old, new, found, tmp_path):
    before = RELEASED.read_text("utf-8")
    after = before.replace(old, new, 1)
    assert after != before
    assert any(found in line for line in breaking_changes(before, after))
    released = tmp_path / "released.pyi"
    released.write_text(before)
    assert release(after, released)
    assert released.read_text() == before


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("def open_catalogue(", "def more() -> None:\n    ...\n\ndef open_catalogue("),
        ("limit: int=50", "limit: int=50, offset: int=0"),
        ('"""An attribute of a node."""', '"""Another text."""'),
    ],
)
def test_what_is_added_breaks_nobody(old, new, tmp_path: Path):
    before = RELEASED.read_text("utf-8")
    after = before.replace(old, new, 1)
    assert after != before
    assert breaking_changes(before, after) == []
    assert release(after, tmp_path / "new.pyi") == []
