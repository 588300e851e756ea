"""Vehicles over the standard tree: the time to compose fifty, and their memory beside that of one."""

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from random import Random

from bench.measuring import probe
from bench.rows import Bench, Row, time_of

_COUNT = 50
_WITHOUT = (
    "Cabin.Sunroof",
    "Cabin.Convertible",
    "Powertrain.FuelSystem",
    "Powertrain.TractionBattery",
    "*.ParkingBrake*",
)


def compose(bench: Bench) -> Row:
    """Fifty vehicles, each with other seats, axles, missing parts and an overlay."""
    seconds = probe("vehicles", project(bench.folder, _COUNT))()
    return Row("compose 50 vehicles over the standard tree", time_of(seconds), "", "", "at most 2 s", seconds <= 2)


def memory(bench: Bench) -> Row:
    """Memory of fifty vehicles, with the catalogue that they share."""
    one, fifty = (probe("vehicles-memory", project(bench.folder, count))() for count in (1, _COUNT))
    ratio = fifty / one
    return Row(
        "memory for 50 vehicles over the standard tree", f"{fifty / 1e6:.1f} MB", f"one vehicle: {one / 1e6:.1f} MB",
        f"{ratio:.2f} ×", "at most 1.5 ×", ratio <= 1.5,
    )  # fmt: skip


ROWS: Mapping[str, Callable[[Bench], Row]] = {"vehicles": compose, "vehicles-memory": memory}


def project(folder: Path, count: int) -> Path:
    """The project file of so many vehicles."""
    home = folder / f"vehicles{count}"
    home.mkdir(parents=True)
    (home / "small.vspec").write_text("Vehicle:\n  type: branch\n  description: A vehicle.\n", encoding="utf-8")
    small = '[[catalogue]]\nid = "small"\nspec = "small.vspec"\n[[vehicle]]\nid = "small"\n'
    (home / "small.toml").write_text(small, encoding="utf-8")
    file = home / "sigcat.toml"
    file.write_text(
        '[[catalogue]]\nid = "std"\nrelease = "shipped"\n' + "".join(_vehicles(home, count)), encoding="utf-8"
    )
    return file


def _vehicles(home: Path, count: int) -> Iterator[str]:
    random = Random(1)
    for number in range(count):
        without = [f"Vehicle.{path}" for path in random.sample(_WITHOUT, 2)]
        overlay = home / f"overlay{number}.vspec"
        overlay.write_text(f"Vehicle.Speed:\n  max: {200 + number}\n", encoding="utf-8")
        yield (
            f'[[vehicle]]\nid = "v{number}"\nwithout = {without}\nwith = ["{overlay.name}"]\n'
            f'attributes = {{steering = "{random.choice(("left", "right"))}"}}\n'
            f'[vehicle.instances]\n"Vehicle.Cabin.Seat" = {random.randint(1, 3)}\n'
            f'"Vehicle.Chassis.Axle" = {random.randint(2, 4)}\n'
        )
