"""From function files to Integration JSON and ARXML: `python -m bench.integration STAGE FOLDER` is one process of it.

The set is the one of the paper's case study, 3 executables, 18 services and 162 events, or several times that.
"""

import sys
from pathlib import Path

from sigcat.cli import set_up_process

SIGNALS = 9
"""Signals of a service: 18 services have 162 events."""
BRANCHES = 5
"""Branches that a function consumes; the sixth service of each is its own."""

_STEP = "cycleTime: 50, priority: 10, scheduling: NonPreemptive, ASILlevel: QM"


def write_set(folder: Path, times: int = 1) -> Path:
    """Write a tree and the functions of a set that is `times` as large; return their folder."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = [
        "Vehicle: {type: branch, description: Vehicle.}",
        "Vehicle.Function: {type: branch, description: Functions.}",
    ]
    for number in range(3 * times):
        lines.extend(_tree(number))
        (folder / f"function{number:03d}.yaml").write_text(_function(number), encoding="utf-8")
    (folder / "tree.vspec").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder


def _tree(number: int) -> list[str]:
    function = f"Vehicle.Function.Control{number}"
    lines = [
        f"{function}: {{type: branch, description: Control {number}.}}",
        f"{function}.Scheduling: {{type: branch, description: Calls.}}",
        f"{function}.Scheduling.Init: {{type: branch, description: Begins., runType: Init, ASILlevel: QM}}",
        f"{function}.Scheduling.Step: {{type: branch, description: Runs., runType: Cyclic, {_STEP}}}",
        f"{function}.Scheduling.Terminate: {{type: branch, description: Ends., runType: Shutdown, ASILlevel: QM}}",
    ]
    for branch in (*_inputs(number), _output(number)):
        lines.append(f"{branch}: {{type: branch, description: Signals.}}")
        lines.extend(
            f"{branch}.Signal{i}: {{type: sensor, datatype: float, unit: km/h, min: 0, max: 250, "
            f"ASILlevel: QM, description: Signal {i} of {branch}.}}"
            for i in range(SIGNALS)
        )
    return lines


def _inputs(number: int) -> list[str]:
    return [f"Vehicle.Input{number}x{branch}" for branch in range(BRANCHES)]


def _output(number: int) -> str:
    return f"Vehicle.Output{number}"


def _function(number: int) -> str:
    items = [(branch, "consumed") for branch in _inputs(number)] + [(_output(number), "provided")]
    data = "".join(
        f"\n          - {{path: {branch}.Signal{i}, role: {role}, name: {_name(branch)}Signal{i}, init: 0.0, "
        f"variable: control{number}.{_name(branch)}Signal{i}}}"
        for branch, role in items
        for i in range(SIGNALS)
    )
    return (
        f"function: Control{number}\ndescription: Controls.\nresponsible: Team\nversion: 1.0.0\ndate: 2025-09-12\n"
        f"code: {{signature: globals, headers: [control{number}.h]}}\n"
        f"components:\n  - name: Control{number}\n    runnables:\n"
        f"      - {{interface: Control{number}_Init, symbol: control{number}_init}}\n"
        f"      - interface: Control{number}_Step\n        symbol: control{number}_step\n        data:{data}\n"
        f"      - {{interface: Control{number}_Terminate, symbol: control{number}_end}}\n"
    )


def _name(branch: str) -> str:
    return branch.rpartition(".")[2]


def derive_all(folder: Path) -> None:
    """Everything, from the files of the set to the files of the platform."""
    from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
    from sigcat.catalogue.composing.compose import read_catalogue
    from sigcat.function.function_json.wire import written
    from sigcat.integration.autosar_adaptive.adaptive_integration import derive
    from sigcat.integration.reading import read_functions

    catalogue = read_catalogue(folder / "tree.vspec")
    paths = sorted(folder.glob("function*.yaml"))
    read = read_functions([(path.read_bytes(), path.name) for path in paths], catalogue)
    derived = derive(read.functions)
    output = folder / "output"
    output.mkdir(exist_ok=True)
    (output / "integration.json").write_bytes(written(derived.model))
    for file in generate(derived.model):
        (output / file.name).write_bytes(file.data)


def copy_all(folder: Path) -> None:
    """The floor: read the same inputs, write the same bytes."""
    for path in (folder / "tree.vspec", *sorted(folder.glob("function*.yaml"))):
        path.read_bytes()
    copies = folder / "copies"
    copies.mkdir(exist_ok=True)
    for path in sorted((folder / "output").iterdir()):
        (copies / path.name).write_bytes(path.read_bytes())


STAGES = {"derive": derive_all, "floor": copy_all}


def main() -> int:
    """Run one stage."""
    stage, folder = sys.argv[1:]
    set_up_process()
    STAGES[stage](Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
