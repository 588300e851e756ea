"""A hosted catalogue with vehicles."""

from pathlib import Path

from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.vehicle import Setting, Vehicle

TREE = Path(__file__).parents[1] / "api" / "tree"


def _without(*paths: str) -> tuple[Setting, ...]:
    return tuple(Setting(path, True, line, 13) for line, path in enumerate(paths, 3))


VEHICLES = (
    Vehicle(
        "coupe", "Coupé", "fleet", "sigcat.toml", 1, "sop", (("steering", "left"),), without=_without("Vehicle.Door")
    ),
    Vehicle("coupe", "Coupé", "fleet", "sigcat.toml", 1, "ota2", (("steering", "left"), ("release", "OTA 2"))),
    Vehicle(
        "truck", "Truck", "fleet", "sigcat.toml", 9, labels=(("steering", "right"),), without=_without("Vehicle.Speed")
    ),
)
FLEET = Source("fleet", "A fleet", TREE / "tree.vspec", vehicles=VEHICLES)
