"""Git as the gate of a repository that holds overlays alone: the tree is that of each revision's own sigcat.toml."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.catalogue.hosting.archives import saved, tar_bytes
from tests.project.company import OVERLAY, PROJECT, UNITS, write_company

NOISE = """\
Vehicle.Cabin.AcmeNoise:
  type: sensor
  datatype: float
  unit: dB
  owner: Air team
  description: Noise.
"""


def git(*arguments):
    identity = ["-c", "user.name=Test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", *identity, *arguments], check=True, capture_output=True)


def commit(tag):
    git("add", "--all")
    git("commit", "--quiet", "--message", tag)
    git("tag", tag)


@pytest.fixture
def company(tmp_path, monkeypatch):
    """A company's repository with the tag v1.2.0 and one signal more in the folder."""
    for name in ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", os.devnull)
    folder = write_company(tmp_path / "company")
    monkeypatch.chdir(folder)
    git("init", "--quiet", "--initial-branch", "main")
    commit("v1.2.0")
    Path("overlays/noise.vspec").write_text(NOISE)
    return folder


def test_git_may_write_more_than_the_archive_without_finding_the_pipe_closed(company, tmp_path, monkeypatch, capsys):
    """git pads an archive; how much of that it has written when the reader is done depends on the machine."""
    (tmp_path / "bin").mkdir()
    program = tmp_path / "bin/git"
    padded = "head -c 1000000 /dev/zero"
    real = shutil.which("git")
    program.write_text(
        f'#!/bin/sh\ncase " $* " in *" archive "*) {real} "$@" && exec {padded};; *) exec {real} "$@";; esac\n'
    )
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}{os.pathsep}{os.environ['PATH']}")
    assert main(["diff", "git:v1.2.0", "."]) == 0
    assert "AcmeNoise" in capsys.readouterr().out


def changes(capsys, *arguments):
    """Return the changes that diff reports, as words."""
    capsys.readouterr()
    assert main(["diff", *arguments, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["changes"]
    return [f"{change['kind']} {change['path']}" for change in found]


ADDED = ["added Vehicle.Cabin.AcmeNoise"]


@pytest.mark.parametrize(
    "sides",
    [
        ["git:main", "."],
        ["git:main"],
        ["main"],
        ["v1.2.0", "acme"],
        ["git:main:acme", "."],
        ["git:main:.", "."],
        ["--merge-base", "main"],
        ["--merge-base", "git:main", "."],
    ],
)
def test_the_folder_is_compared_with_a_revision(company, capsys, sides):
    assert changes(capsys, *sides) == ADDED


@pytest.mark.parametrize(
    "sides",
    [
        ["git:main..HEAD"],
        ["main..HEAD"],
        ["main...topic"],
        ["git:main..."],
        ["git:v1.2.0..topic:acme"],
        ["v1.2.0", "topic"],
    ],
)
def test_revisions_are_compared(company, capsys, sides):
    git("switch", "--quiet", "--create", "topic")
    commit("topic")
    Path("overlays/noise.vspec").unlink()
    assert changes(capsys, *sides) == ADDED


def test_a_pull_request_does_not_answer_for_what_its_target_has_done_since(company, capsys):
    git("switch", "--quiet", "--create", "pull-request")
    commit("request")
    git("switch", "--quiet", "main")
    Path("overlays/acme.vspec").write_text(OVERLAY.replace("float", "double"))
    commit("target")
    git("switch", "--quiet", "pull-request")
    assert changes(capsys, "--merge-base", "main") == ADDED
    assert changes(capsys, "--merge-base", "main", "git:HEAD") == ADDED
    assert changes(capsys, "git:main...HEAD") == ADDED
    assert len(changes(capsys, "git:main")) == 2


def test_a_misspelled_revision_is_proposed(company, capsys):
    assert main(["diff", "mian"]) == 2
    expected = "sigcat: no file, folder, release or revision is named 'mian'. Did you mean 'main'?\n"
    assert capsys.readouterr().err == expected


def test_a_clone_without_history_says_how_to_fetch_it(company, capsys, tmp_path, monkeypatch):
    git("commit", "--quiet", "--allow-empty", "--message", "second")
    git("clone", "--quiet", "--depth", "1", company.as_uri(), str(tmp_path / "shallow"))
    monkeypatch.chdir(tmp_path / "shallow")
    assert main(["diff", "git:HEAD~1"]) == 2
    assert "fetch it whole (`git fetch --unshallow`; fetch-depth: 0 on GitHub" in capsys.readouterr().err


@pytest.mark.parametrize("folder", ["functions/cabin_air", "overlays"])
def test_the_project_is_found_from_a_folder_below_it(company, capsys, monkeypatch, folder):
    monkeypatch.chdir(company / folder)
    assert changes(capsys, "git:main", ".") == ADDED


def test_units_are_those_of_each_revision(company, capsys):
    Path("overlays/noise.vspec").unlink()
    Path("units.yaml").write_text(UNITS.replace("ppm:", "ppb:"))
    Path("overlays/acme.vspec").write_text(OVERLAY.replace("ppm", "ppb"))
    assert changes(capsys, "git:main") == ["changed Vehicle.Cabin.AcmeGas"]


def test_the_release_is_that_of_each_revision(company, capsys, monkeypatch, tmp_path):
    monkeypatch.setenv("SIGCAT_DATA", str(tmp_path / "data"))
    assert main(["pull", "v5.0", "--from", str(saved(tmp_path, tar_bytes()))]) == 0
    Path("overlays/noise.vspec").unlink()
    Path("sigcat.toml").write_text(PROJECT.replace('"shipped"', '"v5.0"') + '[lint.severity]\nV020 = "warning"\n')
    told = changes(capsys, "git:main")
    assert "removed Vehicle.ADAS" in told
    assert not any("AcmeGas" in change for change in told)


def test_another_project_file_is_that_of_the_revision_too(company, capsys):
    Path("other").mkdir()
    Path("other/sigcat.toml").write_text('[[catalogue]]\nid = "other"\nrelease = "shipped"\noverlays = ["o.vspec"]\n')
    Path("other/o.vspec").write_text(NOISE)
    commit("other")
    Path("other/o.vspec").write_text(NOISE.replace("AcmeNoise", "Other"))
    told = changes(capsys, "git:other", ".", "--config", "other/sigcat.toml")
    assert told == ["moved Vehicle.Cabin.Other"]


def test_a_revision_without_a_project_is_the_tree_before_it_began(company, capsys):
    git("rm", "--quiet", "--cached", "sigcat.toml")
    Path("sigcat.toml").rename("kept.toml")
    commit("before")
    Path("kept.toml").rename("sigcat.toml")
    assert changes(capsys, "git:before") == ["added Vehicle.Cabin.AcmeGas", *ADDED]
    assert main(["diff", "git:before", ".", "--isolated"]) == 2
    assert "A `sigcat.toml` with a [[catalogue]] names the tree of overlays." in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "name the sides"),
        (["git:main..HEAD", "."], "git:main..HEAD names both sides; remove ."),
        (["git:main", ".", "--merge-base", "main"], "--merge-base is the old side"),
        (["--merge-base", "missing"], "has no such branch, tag or commit"),
        (["--merge-base", "-x=y"], "name a revision"),
        (["git:mian..main"], "Did you mean 'main'?"),
    ],
)
def test_sides_that_are_not_two(company, capsys, arguments, message):
    arguments = [f"--merge-base={arguments[1]}"] if arguments[:1] == ["--merge-base"] else arguments
    assert main(["diff", *arguments]) == 2
    assert message in capsys.readouterr().err


def test_a_shallow_clone_is_told_what_it_lacks(company, capsys, tmp_path, monkeypatch):
    for branch in ("topic", "other"):
        git("switch", "--quiet", "--create", branch, "main")
        Path(branch).write_text("")
        commit(f"{branch}-1")
    clone = tmp_path / "shallow"
    git("clone", "--quiet", "--depth", "1", "--no-single-branch", company.as_uri(), str(clone))
    monkeypatch.chdir(clone)
    assert main(["diff", "--merge-base", "origin/topic"]) == 2
    assert "fetch-depth: 0" in capsys.readouterr().err


def test_histories_without_a_common_commit_are_not_for_want_of_a_fetch(company, capsys):
    git("switch", "--quiet", "--orphan", "alone")
    Path("x").write_text("")
    commit("alone-1")
    assert main(["diff", "--merge-base", "main"]) == 2
    assert capsys.readouterr().err == "sigcat: git:main: it has no commit in common with HEAD.\n"


def test_what_is_wrong_in_a_revision_is_named_by_the_revision(company, capsys):
    Path("sigcat.toml").write_text(PROJECT + 'unit = ["x"]\n')
    commit("broken")
    git("checkout", "--quiet", "main", "--", ".")
    Path("sigcat.toml").write_text(PROJECT)
    assert main(["diff", "git:broken"]) == 1
    told = capsys.readouterr().err
    assert told.startswith("git:broken:sigcat.toml:15:1: error ")
    assert "/tmp" not in told


def test_files_outside_of_the_repository_are_refused(company, capsys, tmp_path):
    (tmp_path / "outside.vspec").write_text(NOISE)
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", str(tmp_path / "outside.vspec")))
    commit("leaving")
    assert main(["diff", "git:leaving"]) == 2
    assert "the path leaves the repository" in capsys.readouterr().err


# -- reports ------------------------------------------------------------------------------------------------------


def test_annotations_are_at_the_changed_lines(company, capsys):
    text = "Vehicle.Cabin.AcmeFirst:\n  type: sensor\n  datatype: float\n  description: F.\n"
    Path("overlays/acme.vspec").write_text(text + OVERLAY)
    commit("more")
    Path("overlays/acme.vspec").write_text("\n" + text.replace("F.", "First."))
    assert main(["diff", "git:more", "--format", "github", "--fail-on", "breaking"]) == 1
    removed, changed, count = capsys.readouterr().out.splitlines()
    assert removed == (
        "::error file=overlays/acme.vspec,line=2,col=1,title=sigcat removed::Removed: Vehicle.Cabin.AcmeGas (breaking). "
        "Lookups by its path fail."
    )
    assert changed == (
        "::notice file=overlays/acme.vspec,line=5,col=16,title=sigcat text::Changed: Vehicle.Cabin.AcmeFirst; "
        "description: F. → First. (text only). Only people read it."
    )
    assert count == "Found 1 error and 1 note in 1 file."


def test_a_deletion_by_an_overlay_is_at_its_line_and_a_change_of_the_release_has_none(company, capsys):
    Path("overlays/noise.vspec").write_text("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  delete: true\n")
    assert main(["diff", "git:main", "--format", "github"]) == 0
    assert "::error file=overlays/noise.vspec,line=4,col=11,title=sigcat removed::" in capsys.readouterr().out
    Path("overlays/noise.vspec").unlink()
    Path("sigcat.toml").write_text(PROJECT.replace('"shipped"', '"interfaces"'))
    assert main(["diff", "git:main", "--format", "github"]) == 0
    assert "::notice title=sigcat added::Added: Vehicle.Function" in capsys.readouterr().out


def test_gitlab_reads_changes_as_code_quality(company, capsys):
    assert main(["diff", "git:main", "--format", "gitlab"]) == 0
    [issue] = json.loads(capsys.readouterr().out)
    assert issue["location"] == {"path": "overlays/noise.vspec", "lines": {"begin": 1}}


def test_a_comment_has_a_mark_and_fits(company, capsys):
    many = "".join(NOISE.replace("AcmeNoise", f"AcmeNoise{number}{'x' * 200}") for number in range(400))
    Path("overlays/noise.vspec").write_text(many + "Vehicle.Speed:\n  type: sensor\n  delete: true\n")
    assert main(["diff", "git:main", "--format", "markdown"]) == 0
    comment = capsys.readouterr().out
    assert comment.startswith("<!-- sigcat diff -->\n# Changes from `git:main` to `.`\n\n401 changes: 1 breaking,")
    assert "- Removed: `Vehicle.Speed`" in comment
    assert 64_000 < len(comment) <= 65_000
    assert comment.endswith("\nThe comment is full: further changes are not shown. `sigcat diff` lists them all.\n")


def test_the_changelog_of_a_version(company, capsys):
    text = OVERLAY + "  deprecation: v1.3.0 use AcmeNoise.\n"
    Path("overlays/acme.vspec").write_text(text)
    assert main(["diff", "v1.2.0", ".", "--changelog"]) == 0
    assert capsys.readouterr().out.startswith("## [Unreleased]\n\n### Added\n\n- `Vehicle.Cabin.AcmeNoise`\n\n### Dep")
    Path("overlays/noise.vspec").write_text(NOISE.replace("float", "double"))
    commit("v1.3.0")
    Path("overlays/acme.vspec").unlink()
    commit("v2.0.0")
    day = subprocess.run(
        ["git", "log", "-1", "--format=%cs"], capture_output=True, text=True, check=True
    ).stdout.strip()
    assert main(["diff", "v1.3.0", "v2.0.0", "--changelog"]) == 0
    assert capsys.readouterr().out == (
        f"## [2.0.0] - {day}\n\n### Removed\n\n- **Breaking:** `Vehicle.Cabin.AcmeGas`\n"
        "  - its deprecation said: `v1.3.0 use AcmeNoise.`\n"
    )


@pytest.mark.parametrize(
    ("overlay", "version"),
    [
        (OVERLAY.replace("Carbon", "The carbon"), "v1.2.1"),
        (OVERLAY + NOISE, "v1.3.0"),
        (OVERLAY.replace("sensor", "actuator"), "v1.3.0"),
        (OVERLAY.replace("float", "double"), "v2.0.0"),
        (OVERLAY, "v1.2.0"),
    ],
)
def test_the_version_follows_from_the_worst_change(company, capsys, overlay, version):
    Path("overlays/noise.vspec").unlink()
    Path("overlays/acme.vspec").write_text(overlay)
    assert main(["version-bump"]) == 0
    assert capsys.readouterr().out == f"{version}\n"


def test_without_a_version_in_its_name_the_part_is_printed(company, capsys):
    assert main(["version-bump", "git:main", "."]) == 0
    output = capsys.readouterr()
    assert output.out == "minor\n"
    assert output.err == "git:main to .: minor. 1 change: 1 compatible\n"


def test_without_a_tag_the_old_side_must_be_named(company, capsys):
    git("tag", "--delete", "v1.2.0")
    assert main(["version-bump"]) == 2
    assert "no tag found before the current commit; name the old side" in capsys.readouterr().err


@pytest.mark.usefixtures("company")
def test_a_revision_has_the_severities_of_its_project():
    project = '[[catalogue]]\nid = "a"\nspec = "undefined.vspec"\n[lint]\nseverity.V020 = "info"\n'
    Path("sigcat.toml").write_text(f'{project}baseline = "a file that the revision lacks"\n')
    Path("undefined.vspec").write_text("A: {type: branch, description: A.}\nA.B.C: {type: branch, description: C.}\n")
    commit("undefined")
    Path("sigcat.toml").write_text(project)
    assert main(["diff", "git:undefined", "a"]) == 0
