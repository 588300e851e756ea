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


def test_everything_wrong_with_a_configuration_is_told_at_once(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text('[lint]\nignroe = []\nbase = "no.vspec"\nselect = 5\n[lint.severity]\nV1 = "fatal"\n')
    with pytest.raises(InputRefused) as refused:
        read_configuration(path)
    assert len(refused.value.findings) == 4
    assert "Did you mean 'ignore'?" in refused.value.findings[0].message
