"""The configuration of a lint: where it is found, and what is wrong with it."""

from pathlib import Path

import pytest

from sigcat.errors import InputRefused
from sigcat.rules.linting.configuration import find_configuration, read_configuration
from sigcat.rules.linting.lint import lint_paths


def test_the_configuration_is_found_upwards_and_its_paths_are_relative_to_it(tree):
    (tree / "pyproject.toml").write_text('[tool.sigcat.lint]\nbase = "vspec/VehicleSignalSpecification.vspec"\n'
                                         'ignore = ["V105"]\n[tool.sigcat.lint.severity]\nV106 = "error"\n')  # fmt: skip
    options = read_configuration(find_configuration(tree / "vspec") or Path())
    assert options.base is not None
    assert options.base.resolve() == (tree / "vspec" / "VehicleSignalSpecification.vspec").resolve()
    assert [(f.rule, f.severity) for f in lint_paths([tree / "vspec"], options).findings] == [("V106", "error")]


def test_every_severity_that_is_wrong_is_told(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text(
        '[lint.severity]\nV101 = "bad"\nV102 = "eror"\nV103 = "off"\n[lint.per-file]\na.V1 = "x"\nb.V2 = 1\nc = 5\n'
    )
    with pytest.raises(InputRefused) as refused:
        read_configuration(path)
    told = " ".join(finding.message for finding in refused.value.findings)
    for wrong in ("'bad' of V101", "'eror' of V102", "'x' of V1", "1 of V2", "`per-file.c` must be a table"):
        assert wrong in told
    assert "V103" not in told


def test_everything_wrong_with_a_configuration_is_told_at_once(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text('[lint]\nignroe = []\nbase = "no.vspec"\nselect = 5\n[lint.severity]\nV1 = "fatal"\n')
    with pytest.raises(InputRefused) as refused:
        read_configuration(path)
    assert len(refused.value.findings) == 4
    assert "Did you mean 'ignore'?" in refused.value.findings[0].message
