"""FMUs with a CAN bus for tests, by the commands that a user types."""

import json
from pathlib import Path

from sigcat.cli import main
from tests.adapter.fmi.fmus import run

HERE = Path(__file__).parent
TREE, DBC = HERE / "tree.vspec", HERE / "bus.dbc"


def made(
    folder: Path, function: Path = HERE / "function.yaml", tree: Path = TREE, dbc: Path = DBC, signals: str = "beside"
) -> Path:
    """The FMU of a function with a bus."""
    bus = f"{{name: Powertrain, dbc: ['{dbc}'], signals: {signals}}}"
    (folder / "deployment.yaml").write_text(f"name: Tested\nfmi: {{bus: {bus}}}\n")
    document = folder / "fmi.json"
    options = ["-s", str(tree), "--deployment", str(folder / "deployment.yaml"), "-o", str(document)]
    assert main(["integrate", "fmi", str(function), *options]) in (0, 1)
    assert main(["generate", "fmi", str(document), "-o", str(folder / "made")]) == 0
    (name,) = [each["Name"] for each in json.loads(document.read_text())["FmuList"]]
    setting = f"-D{name.upper()}_CODE={function.parent.absolute()}"
    run("cmake", "-S", folder / "made", "-B", folder / "build", "-DCMAKE_C_FLAGS=-Wall -Wextra -Werror", setting)
    run("cmake", "--build", folder / "build")
    return folder / "build" / f"{name}.fmu"
