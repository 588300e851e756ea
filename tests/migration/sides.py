"""Two small trees, a table of moves between them, and the command over files in a folder."""

from pathlib import Path
from typing import NamedTuple

from sigcat.cli import main

OLD = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, description: Speed.}
Vehicle.Trip: {type: actuator, datatype: float, unit: km, description: Distance of the trip.}
Vehicle.Coolant:
  type: sensor
  datatype: int16
  unit: celsius
  description: Temperature of the coolant.
  deprecation: V1.1 moved to Engine.Coolant
Vehicle.Mode: {type: actuator, datatype: string, allowed: [A, B], description: Mode.}
Vehicle.Profile: {type: actuator, datatype: string, allowed: [SLOW, 'FAST 1', OLD], description: Profile.}
Vehicle.Gear: {type: actuator, datatype: uint8, enum: {PARK: 0, DRIVE: 1, LOW: 2}, description: Gear.}
Vehicle.Level: {type: sensor, datatype: uint8, unit: percent, description: Level.}
Vehicle.Gone: {type: sensor, datatype: uint8, description: Gone.}
Vehicle.Lamp: {type: branch, description: Lamps.}
Vehicle.Lamp.IsOn: {type: actuator, datatype: boolean, description: Whether it is on.}
Vehicle.Door: {type: branch, instances: ['Row[1,2]', [Left, Right]], description: Doors.}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether it is open.}
Vehicle.Same: {type: sensor, datatype: uint8, description: The only one that is described like this.}
"""
NEW = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, unit: m/s, description: Speed.}
Vehicle.Trip: {type: actuator, datatype: uint32, unit: m, description: Distance of the trip.}
Vehicle.Engine: {type: branch, description: Engine.}
Vehicle.Engine.Coolant: {type: sensor, datatype: float, unit: celsius, description: Coolant temperature.}
Vehicle.Mode: {type: actuator, datatype: string, allowed: [A, B, C], description: Mode.}
Vehicle.Drive: {type: branch, description: Drive.}
Vehicle.Drive.Profile: {type: actuator, datatype: string, allowed: [ECO, SPORT, RACE], description: Profile of the drive.}
Vehicle.Gear: {type: actuator, datatype: uint8, enum: {P: 0, DRIVE: 1}, description: Gear.}
Vehicle.Level: {type: sensor, datatype: uint8, unit: l, description: Level.}
Vehicle.Light: {type: branch, description: Lights.}
Vehicle.Light.IsOn: {type: actuator, datatype: boolean, description: Whether it is on.}
Vehicle.Door: {type: branch, instances: ['Row[1,2]', [DriverSide, PassengerSide]], description: Doors.}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether it is open.}
Vehicle.Renamed: {type: sensor, datatype: uint8, description: The only one that is described like this.}
"""
TABLE = """\
from: '1'
to: '2'
moves:
  Vehicle.Coolant: Vehicle.Engine.Coolant
  Vehicle.Lamp: Vehicle.Light
  Vehicle.Profile: Vehicle.Drive.Profile
  Vehicle.Gone: {to: [], why: Nobody measures it.}
labels:
  Vehicle.Door:
    Left: {to: [DriverSide, PassengerSide], confidence: 0.9, why: Most drivers sit on the left.}
    Right: PassengerSide
values:
  Vehicle.Profile: {SLOW: ECO, 'FAST 1': SPORT}
"""


class Result(NamedTuple):
    """Status and messages of a run."""

    status: int
    messages: str
    output: str


class Sides:
    """A folder with files to migrate between the two trees."""

    def __init__(self, folder: Path, trees: Path, capsys) -> None:
        self.folder = folder
        self._trees = trees
        self._capsys = capsys
        for name, text in (("old.vspec", OLD), ("new.vspec", NEW), ("table.yaml", TABLE)):
            (trees / name).write_text(text, encoding="utf-8")

    def write(self, name: str, text: str | bytes) -> Path:
        """Write a file, its line ends as they are."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def text(self, name: str) -> str:
        """Return the text of a file, its line ends as they are."""
        return (self.folder / name).read_bytes().decode()

    def decide(self, entry: str, more: str) -> None:
        """Add to an entry of the table."""
        self._change("table.yaml", entry, entry + more)

    def new(self, text: str, other: str) -> None:
        """Change the new tree."""
        self._change("new.vspec", text, other)

    def old(self, text: str, other: str) -> None:
        """Change the old tree."""
        self._change("old.vspec", text, other)

    def _change(self, name: str, text: str, other: str) -> None:
        tree = self._trees / name
        assert text in tree.read_text(encoding="utf-8")
        tree.write_text(tree.read_text(encoding="utf-8").replace(text, other), encoding="utf-8")

    def run(self, *options: str, back: bool = False) -> Result:
        """Migrate the folder."""
        sides = [str(self._trees / name) for name in ("old.vspec", "new.vspec")]
        table = () if back else ("--table", str(self._trees / "table.yaml"))
        self._capsys.readouterr()
        status = main(["migrate", "--isolated", *(reversed(sides) if back else sides), *options, *table])
        shown = self._capsys.readouterr()
        return Result(status, shown.err, shown.out)
