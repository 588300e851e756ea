"""A project of 5,000 signals with overlays that stack and a function, and an editor in it."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from bench.editor import Editor, editor

PROJECT = """\
functions = ["functions"]

[[catalogue]]
id = "acme"
spec = "tree/Acme.vspec"
overlays = ["overlays/cabin.vspec", "overlays/limits.vspec"]
"""
CABIN = """\
Vehicle.Cabin.Door.IsOpen:
  type: sensor
  datatype: boolean
  description: Whether the door is open.

Vehicle.Cabin.Gas:
  type: sensor
  datatype: float
  unit: percent
  min: 0
  description: Carbon dioxide in the air.
"""
LIMITS = """\
Vehicle.Cabin.Gas:
  type: sensor
  datatype: float
  max: 50
"""
FUNCTION = """\
function: CabinAir
description: Watches the air in the cabin.
responsible: Air team

code:
  signature: globals
  sources: [CabinAir.c]
  headers: [CabinAir.h]

define:
  scheduling:
    Init: {asil: QM, description: Clears the mean.}
    Step: {cycleTime: 100, asil: QM, description: Adds a value to the mean.}
    Terminate: {asil: QM, description: Gives resources back.}

components:
  - name: CabinAir
    runnables:
      - interface: CabinAir_Init
        symbol: CabinAir_initialize
      - interface: CabinAir_Step
        symbol: CabinAir_step
        contract: Global variables
        data:
          - path: Vehicle.Cabin.Gas
            role: consumed
            variable: input_gas
            provider: Sensor
          - path: Vehicle.Cabin.Door.Left.IsOpen
            role: consumed
            variable: input_door
            provider: Sensor
      - interface: CabinAir_Terminate
        symbol: CabinAir_terminate
"""
HEADER = "#include <stdbool.h>\n\nextern float input_gas;\nextern bool input_door;\n\nvoid CabinAir_step(void);\n"
SOURCE = '#include "CabinAir.h"\n\nfloat input_gas;\nbool input_door;\n\nvoid CabinAir_step(void) {}\n'


def tree_text(signals: int = 5_000) -> str:
    """A tree in one file: a cabin with doors, and many more signals."""
    parts = [
        "Vehicle:\n  type: branch\n  description: A vehicle.\n",
        "Vehicle.Cabin:\n  type: branch\n  description: The cabin.\n",
        "Vehicle.Cabin.Door:\n  type: branch\n  instances: [Left, Right]\n  description: A door.\n",
        "Vehicle.More:\n  type: branch\n  description: All other signals.\n",
    ]
    for number in range(signals):
        text = f"Vehicle.More.Signal{number}:\n  type: sensor\n  datatype: float\n  unit: km/h\n"
        parts.append(f"{text}  description: Signal number {number}.\n")
    return "\n".join(parts)


def write_project(folder: Path) -> Path:
    """Write the project."""
    files = {
        "sigcat.toml": PROJECT,
        "tree/Acme.vspec": tree_text(),
        "overlays/cabin.vspec": CABIN,
        "overlays/limits.vspec": LIMITS,
        "functions/cabin_air/function.yaml": FUNCTION,
        "functions/cabin_air/CabinAir.h": HEADER,
        "functions/cabin_air/CabinAir.c": SOURCE,
    }
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="session")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project on the disk, which no test changes."""
    return write_project(tmp_path_factory.mktemp("project"))


@pytest.fixture(scope="session")
def running(project: Path) -> Iterator[Editor]:
    """An editor with a server for the project."""
    pytest.importorskip("pygls")
    with editor(project) as found:
        yield found


@pytest.fixture
def client(running: Editor) -> Iterator[Editor]:
    """The editor without open files."""
    yield running
    for path in tuple(running.texts):
        running.close(path)
