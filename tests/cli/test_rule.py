"""`sigcat rule`: every rule that `sigcat lint` would run here, listed or explained."""

import pytest

from sigcat.cli import main
from tests.rules.own_rule import OWN_RULE


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "our-rules.yaml").write_text(OWN_RULE)
    return tmp_path


@pytest.fixture
def configured(folder):
    (folder / "sigcat.toml").write_text('[lint]\nrules = ["our-rules.yaml"]\n')


@pytest.mark.parametrize("name", ["V101", "v101"])
def test_a_shipped_rule_is_explained(name, capsys):
    assert main(["rule", name]) == 0
    page = capsys.readouterr().out
    assert page.startswith("# V101 ")
    assert "Good:" in page
    assert "Bad:" in page
    assert "Defined in" not in page


@pytest.mark.usefixtures("configured")
@pytest.mark.parametrize("name", ["ACME001", "short-path"])
def test_a_rule_of_the_company_is_explained_with_where_it_is_defined(name, capsys):
    assert main(["rule", name]) == 0
    page = capsys.readouterr().out
    assert page.startswith("# ACME001 short-path\n\nPaths are short.\n")
    assert page.endswith("Defined in our-rules.yaml, line 1.\n")


@pytest.mark.usefixtures("configured")
def test_rules_of_the_company_are_listed_with_the_others(capsys):
    assert main(["rule"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "ACME001 warning  Paths are short. (our-rules.yaml)" in lines
    assert any(line.startswith("V101 ") for line in lines)


def test_a_configuration_may_be_named(folder, capsys):
    (folder / "other.toml").write_text('[lint]\nrules = ["our-rules.yaml"]\n')
    assert main(["rule", "ACME001", "--config", "other.toml"]) == 0
    assert "Defined in our-rules.yaml" in capsys.readouterr().out


@pytest.mark.usefixtures("configured")
def test_a_rule_that_cannot_be_used_is_reported_at_its_line(folder, capsys):
    (folder / "our-rules.yaml").write_text(OWN_RULE.replace("severity: warning", "severity: grave"))
    assert main(["rule", "ACME001"]) == 2
    error = capsys.readouterr().err
    assert "our-rules.yaml:4:3: error L010 `severity` must be one of error, warning, info, not 'grave'." in error


def test_a_rule_that_does_not_exist_names_the_nearest(capsys):
    assert main(["rule", "V1O1"]) == 2
    assert "Did you mean" in capsys.readouterr().err
