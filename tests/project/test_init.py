"""`sigcat init`: a project that works at once, and the project file for what is already there."""

import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest
import yaml

from sigcat.cli import main
from sigcat.function.hosting import FunctionLibrary
from sigcat.project.read_project import read_project
from sigcat.project.starting import ci
from sigcat.project.starting.existing import found_in
from tests.catalogue.trees import ROOT
from tests.project.company import OVERLAY, UNITS, write_company


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def project(folder, monkeypatch, capsys):
    assert main(["init", "Acme signals", "--ci", "github"]) == 0
    capsys.readouterr()
    monkeypatch.chdir("Acme signals")


def test_a_new_project_passes_lint(project, capsys):
    assert main(["lint"]) == 0
    assert capsys.readouterr().out == "No findings.\n"


def test_its_function_switches_in_a_simulation(project, capsys):
    if not (shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")):
        pytest.skip("a C compiler: install one")
    assert main(["simulate", "--trace", "functions/cabin_air/trace.csv"]) == 0
    rows = capsys.readouterr().out.splitlines()
    assert [row.rpartition(",")[2] for row in (rows[2], rows[12], rows[-1])] == ["false", "true", "false"]


def test_its_catalogue_is_named_after_the_folder_and_its_functions_are_its_own(project, capsys):
    read = read_project(Path("sigcat.toml"))
    assert [(source.id, source.title) for source in read.catalogues] == [("acme-signals", "Acme signals")]
    assert main(["show", "Vehicle.Cabin.Humidity"]) == 0
    assert main(["function", "validate"]) == 0
    assert main(["integrate", "ros2", "-o", "ros2.json"]) == 0
    library = FunctionLibrary(read.functions, has_shipped=read.has_shipped_functions)
    assert [file.id for file in library.files] == ["cabin_air"]


def test_its_rule_acts(project, capsys):
    overlay = Path("overlays/cabin.vspec")
    overlay.write_text("\n".join(line for line in overlay.read_text().splitlines() if "owner" not in line) + "\n")
    assert main(["lint"]) == 1
    assert "error OWN001" in capsys.readouterr().out


def test_its_pipeline_installs_this_sigcat(project):
    workflow = yaml.safe_load(Path(".github/workflows/signals.yml").read_text())
    assert workflow["env"]["SIGCAT"] == ci.installed_source()


def test_sigcat_from_git_is_installed_from_the_same_commit(monkeypatch):
    origin = '{"url": "https://example.org/sigcat", "vcs_info": {"vcs": "git", "commit_id": "0abc"}}'
    installed = type("Distribution", (), {"read_text": lambda _self, _name: origin})()
    monkeypatch.setattr(ci, "distribution", lambda _name: installed)
    assert ci.installed_source() == "sigcat[c] @ git+https://example.org/sigcat@0abc"


def test_nothing_is_written_over(folder, capsys):
    Path("rules.yaml").write_text("kept")
    assert main(["init"]) == 2
    assert capsys.readouterr().err == "sigcat: nothing was written: rules.yaml is there already\n"
    assert [path.name for path in folder.iterdir()] == ["rules.yaml"]


def test_a_run_that_was_interrupted_is_completed(folder):
    assert main(["init"]) == 0
    whole = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    Path("functions/cabin_air/function.yaml").unlink()
    Path("rules.yaml").unlink()
    assert main(["init"]) == 0
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == whole


def test_a_project_that_is_there_gets_a_pipeline_alone(folder, capsys):
    assert main(["init"]) == 0
    Path("sigcat.toml").write_text('[[catalogue]]\nid = "own"\nrelease = "shipped"\n')
    capsys.readouterr()
    assert main(["init", "--ci", "gitlab"]) == 0
    assert capsys.readouterr().out == ".gitlab-ci.yml\n"


def test_a_source_that_only_an_index_has_is_named(folder, capsys):
    assert main(["init", "--ci", "gitlab"]) == 0
    assert f"The pipeline installs {ci.installed_source()}. If your package index" in capsys.readouterr().err


# -- from a folder ------------------------------------------------------------------------------------------------


def configured(folder="."):
    assert main(["init", "--from", folder]) == 0
    return tomllib.loads((Path(folder) / "sigcat.toml").read_text())


def test_overlays_units_rules_and_functions_are_found(folder, capsys):
    write_company(folder)
    Path("sigcat.toml").unlink()
    Path("can.dbc").unlink()
    Path("units.yaml").unlink()
    Path("common").mkdir()
    Path("common/units.yaml").write_text(UNITS.replace("  symbol: ppm\n", ""))
    found = configured()
    assert found == {
        "functions": ["functions"],
        "rules": ["rules.yaml"],
        "units": ["common/units.yaml"],
        "lint": {"extended-attributes": ["owner"]},
        "catalogue": [
            {"id": folder.name, "title": folder.name, "release": "shipped", "overlays": ["overlays/*.vspec"]},
        ],
    }
    assert main(["lint"]) == 0


def test_a_tree_of_its_own_with_units_beside_it(folder):
    Path("spec").mkdir()
    Path("spec/Own.vspec").write_text(ROOT + "#include part.vspec Vehicle\n")
    Path("spec/part.vspec").write_text("Speed:\n  type: sensor\n  datatype: float\n  description: S.\n")
    Path("spec/units.yaml").write_text(UNITS)
    [catalogue] = configured()["catalogue"]
    assert catalogue["spec"] == "spec/Own.vspec"
    assert "overlays" not in catalogue
    assert read_project(Path("sigcat.toml")).catalogues[0].spec == Path("spec/Own.vspec")


def test_overlays_come_after_those_that_they_build_on(folder, capsys):
    Path("overlays").mkdir()
    Path("overlays/a.vspec").write_text(
        "Vehicle.Own.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"
    )
    Path("overlays/b.vspec").write_text("Vehicle.Own:\n  type: branch\n  description: Own signals.\n")
    [catalogue] = configured()["catalogue"]
    assert catalogue["overlays"] == ["overlays/b.vspec", "overlays/a.vspec"]
    assert main(["lint"]) == 0


def test_a_folder_below_the_current_one(folder):
    write_company(folder / "company")
    Path("company/sigcat.toml").unlink()
    configured("company")
    assert read_project(Path("company/sigcat.toml")).catalogues[0].overlays == (Path("company/overlays/acme.vspec"),)


@pytest.mark.parametrize(("name", "message"), [("missing", "there is no such folder"), (".", "no tree, overlay")])
def test_a_folder_without_anything(folder, capsys, name, message):
    assert main(["init", "--from", name]) == 2
    assert message in capsys.readouterr().err
    assert not list(folder.iterdir())


def test_what_is_not_of_vss_is_an_extended_attribute(folder):
    Path("overlays").mkdir()
    Path("overlays/own.vspec").write_text(OVERLAY + "  supplier: X\n  ASILlevel: A\n")
    assert found_in(Path()).attributes == ("owner", "supplier")


# -- a new function ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("compiler", ["cc", "c++"])
def test_the_code_of_a_new_function_declares_its_variables_and_compiles(folder, capsys, compiler):
    if not shutil.which(compiler):
        pytest.skip(f"{compiler}: install it")
    assert main(["function", "new", "LaneKeeping"]) == 0
    assert main(["lint", "LaneKeeping"]) == 0
    flags = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", *(["-std=c99"] if compiler == "cc" else ["-x", "c++"])]
    subprocess.run([compiler, *flags, "-c", "LaneKeeping/LaneKeeping.c", "-o", "out.o"], check=True)
    assert main(["simulate", "LaneKeeping/function.yaml", "--duration", "0.1"]) == 0


def test_code_that_is_there_is_kept(folder, capsys):
    Path("Park").mkdir()
    Path("Park/Park.c").write_text("kept")
    assert main(["function", "new", "Park"]) == 2
    assert "Park/Park.c is there already" in capsys.readouterr().err
    assert [path.name for path in Path("Park").iterdir()] == ["Park.c"]


@pytest.mark.parametrize(
    ("name", "catalogue"),
    [("vss", "own-vss"), ("v6.0", "own-v6.0"), ("shipped", "own-shipped"), ("VSS 2", "vss-2"), ("5.0", "own-5.0")],
)
def test_a_new_catalogue_hides_no_shipped_tree_and_no_release(folder, name, catalogue):
    assert main(["init", name]) == 0
    assert tomllib.loads((folder / name / "sigcat.toml").read_text())["catalogue"][0]["id"] == catalogue
