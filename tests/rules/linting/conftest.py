"""A small tree to lint, in a repository with a folder of overlays."""

import pytest

TREE = """\
Vehicle:
  type: branch
  description: A vehicle.
#include Cabin.vspec Vehicle
"""
CABIN = """\
Cabin:
  type: branch
  description: The cabin.

Cabin.Noise:
  type: sensor
  datatype: float
  description: noise in the cabin
"""


@pytest.fixture
def tree(tmp_path):
    (tmp_path / "vspec").mkdir()
    (tmp_path / "overlays").mkdir()
    (tmp_path / "vspec" / "VehicleSignalSpecification.vspec").write_text(TREE)
    (tmp_path / "vspec" / "Cabin.vspec").write_text(CABIN)
    (tmp_path / ".git").mkdir()
    return tmp_path
