"""Generated files in the repository are up to date: pages of docs, the OpenAPI document, outputs of examples.

The expected outputs in folders of cases are compared one by one, by the tests that are about them.
"""

import difflib

import pytest

from scripts.generate import GENERATORS, made_by, outdated, text_of


@pytest.mark.parametrize("name", [name for name in GENERATORS if name != "cases"])
def test_it_is_up_to_date(name):
    for path, text in outdated(made_by(name), GENERATORS[name]).items():
        lines = difflib.unified_diff((text_of(path) or "").splitlines(), (text or "").splitlines(), path, "as made")
        pytest.fail("\n".join(["Run `make generate`, and read the diff.", *list(lines)[:50]]))


def test_what_is_no_longer_made_is_removed(tmp_path, monkeypatch):
    monkeypatch.setattr("scripts.generate.ROOT", tmp_path)
    for name in ("kept", "gone"):
        (tmp_path / f"{name}.txt").write_text(name)
    assert outdated({"kept.txt": "kept", "new.txt": "new"}, "*.txt") == {
        "gone.txt": None,
        "new.txt": "new",
    }
