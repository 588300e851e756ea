"""Trees made for measuring: with any number of signals, and with words, units and ranges as in real ones."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from random import Random

WORDS = [
    "Wheel",
    "Speed",
    "Front",
    "Left",
    "Right",
    "Rear",
    "Battery",
    "Voltage",
    "Current",
    "Temperature",
    "Engine",
    "Torque",
    "Brake",
    "Pressure",
    "Seat",
    "Position",
    "Door",
    "Window",
    "Light",
    "Beam",
    "Fuel",
    "Level",
    "Oil",
    "Cabin",
    "Steering",
    "Angle",
    "Yaw",
    "Rate",
    "Acceleration",
    "Lateral",
    "Sensor",
    "Status",
    "Charge",
    "Cell",
    "Motor",
    "Inverter",
    "Coolant",
    "Pump",
    "Fan",
    "Mirror",
    "Wiper",
    "Tire",
    "Gear",
    "Clutch",
    "Pedal",
    "Camera",
    "Radar",
    "Distance",
    "Object",
    "Lane",
    "Warning",
]
"""Names and descriptions are made of these, and searches look for them."""

_UNITS = """\
km/h: {definition: Kilometers in an hour., unit: kilometer per hour, quantity: speed, allowed-datatypes: [numeric]}
percent: {definition: Parts of a hundred., unit: percent, quantity: relation, allowed-datatypes: [numeric]}
V: {definition: Volts., unit: volt, quantity: voltage, allowed-datatypes: [numeric]}
"""
_QUANTITIES = """\
speed: {definition: Distance by time.}
relation: {definition: A part of a whole.}
voltage: {definition: Difference of electric potential.}
"""


def copied(tree: Path, folder: Path) -> Path:
    """A copy of a shipped tree, which is parsed as one's own is: what is shipped is kept parsed."""
    return Path(shutil.copytree(tree, folder / tree.name, dirs_exist_ok=True))


def flat(folder: Path, signals: int) -> Path:
    """So many signals, all directly below the root."""
    return _written(folder, f"flat{signals}", (_signal(f"Vehicle.{name}", random) for name, random in _names(signals)))


def below_instances(folder: Path, signals: int) -> Path:
    """So many signals when expanded: a thousandth of them written, below a thousand instances on two levels."""
    written = signals // 1000
    instances = 'Vehicle.Part:\n  type: branch\n  instances: ["Row[1,25]", "Place[1,40]"]\n  description: A part.\n'
    signals_below = (_signal(f"Vehicle.Part.{name}", random) for name, random in _names(written))
    return _written(folder, f"instances{signals}", (instances, *signals_below))


def overlay(folder: Path, maximum: int) -> Path:
    """An overlay that changes one value of the shipped tree."""
    file = folder / "overlay.vspec"
    file.write_text(f"Vehicle.Speed:\n  max: {maximum}\n", encoding="utf-8")
    return file


def queries(count: int) -> list[str]:
    """Three words each, as someone types them: the last one not yet whole."""
    random = Random(3)
    return [" ".join((*random.sample(WORDS, 2), random.choice(WORDS)[:3])) for _ in range(count)]


def _names(count: int) -> Iterator[tuple[str, Random]]:
    random = Random(1)
    for number in range(count):
        yield "".join(random.sample(WORDS, 3)) + str(number), random


def _signal(path: str, random: Random) -> str:
    text = " ".join(random.sample(WORDS, 8)).lower()
    number = random.randrange(5)
    body = (
        "  type: sensor\n  datatype: float\n  unit: km/h\n  min: -250\n  max: 250\n",
        "  type: actuator\n  datatype: uint8\n  unit: percent\n  min: 0\n  max: 100\n  default: 50\n",
        "  type: actuator\n  datatype: boolean\n",
        "  type: sensor\n  datatype: string\n  allowed: ['LOW', 'MEDIUM', 'HIGH']\n  comment: What it says.\n",
        "  type: attribute\n  datatype: double\n  unit: V\n",
    )[number]
    return f"{path}:\n{body}  description: The {text} of the vehicle.\n\n"


def _written(folder: Path, name: str, statements: Iterator[str] | tuple[str, ...]) -> Path:
    home = folder / name
    home.mkdir(parents=True)
    (home / "units.yaml").write_text(_UNITS, encoding="utf-8")
    (home / "quantities.yaml").write_text(_QUANTITIES, encoding="utf-8")
    text = "Vehicle:\n  type: branch\n  description: A vehicle.\n\n" + "".join(statements)
    (home / "tree.vspec").write_text(text, encoding="utf-8")
    return home / "tree.vspec"
