"""Words of code, pages and rules are spelled as codespell spells them, but for those in spelling.yaml."""

import re
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import yaml

from tests.documentation.pages import ROOT

EXCEPTIONS = {
    each["word"]: each["in"] for each in yaml.safe_load((Path(__file__).parent / "spelling.yaml").read_text("utf-8"))
}
CHECKED = [
    "app", "bench", "docs", "editors", "interface_rules", "overlays", "scripts", "README.md", "CHANGELOG.md",
    "CONTRIBUTING.md", "SECURITY.md",
]  # fmt: skip
SKIPPED = "*.png,*.pyc,*.lock,openapi*.json,licences.md,package-lock.json,node_modules"
FOUND = re.compile(r"^\./?(?P<file>[^:]+):(?P<line>\d+): (?P<word>\S+) ==> (?P<better>.*)$", re.MULTILINE)


def mistakes(paths, cwd):
    """Return file, line, word and proposal of each mistake."""
    command = [sys.executable, "-m", "codespell_lib", "--skip", SKIPPED, *(f"./{path}" for path in paths)]
    run = subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)
    found = FOUND.finditer(run.stdout)
    return [(each["file"], int(each["line"]), each["word"].lower(), each["better"]) for each in found]


def test_every_word_is_spelled_right():
    found = mistakes(CHECKED, ROOT)
    wrong = [
        f"{file}:{line}: {word} ==> {better}"
        for file, line, word, better in found
        if not any(fnmatch(file, pattern) for pattern in EXCEPTIONS.get(word, ()))
    ]
    assert not wrong, "\n".join(wrong)
    assert {word for _, _, word, _ in found} == set(EXCEPTIONS)


def test_a_misspelled_word_is_found_where_it_is(tmp_path):
    (tmp_path / "page.md").write_text("Right.\nIts lenght is 5.\n")
    assert mistakes(["page.md"], tmp_path) == [("page.md", 2, "lenght", "length")]
