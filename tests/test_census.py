"""The census of changes between official releases."""

from pathlib import Path

import pytest

from scripts.census import PAGE, RELEASES, Step, page, steps
from tests.catalogue.comparing.running import changes, signal
from tests.needs import OFFICIAL


def test_a_step_has_its_changes_by_binding_and_class():
    inserted = changes(signal("Vehicle.B"), signal("Vehicle.A") + signal("Vehicle.B"))
    text = page([Step("v1.0", "v1.1", inserted)])
    assert "| 1.0 → 1.1 | 1 | 0 / 0 / 1 | 0 / 0 / 1 | 1 / 0 / 0 | 1 / 0 / 0 |" in text
    assert "| 1.0 → 1.1 | `Vehicle.A` | added | 1 | protobuf, ros2 | `added-before`, `added-beside` |" in text
    assert (
        "1 of 1 steps break no lookup by path. Of these, Protocol Buffers break in 1 and ROS 2 messages in 1." in text
    )


def test_the_heaviest_changes_are_first_and_are_ten():
    many = changes("".join(signal(f"Vehicle.A{number}") for number in range(20)), signal("Vehicle.A0"))
    assert page([Step("v1.0", "v1.1", many)]).count("| removed |") == 10


@pytest.mark.skipif(
    not all((OFFICIAL / name).is_dir() for name in RELEASES), reason="every official release of VSS: `sigcat pull`"
)
def test_the_page_is_that_of_the_releases():
    assert page(steps(Path(OFFICIAL))) == PAGE.read_text("utf-8")
