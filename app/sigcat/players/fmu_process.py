"""An FMU in a process of its own: `python -m sigcat.players.fmu_process FILE START_NS`.

Each line of standard input is a step: its length in ns, and what is set before it, as JSON. Each line that is written to standard output
is what the outputs are after the step. What the FMU reports goes to standard error.
"""

import json
import os
import sys
from shutil import rmtree
from typing import Any

_ACCESSED_AS = {"Enumeration": "Int64"}


def main() -> int:
    """Play steps until the input ends."""
    from fmpy import extract, read_model_description

    file, start = sys.argv[1], int(sys.argv[2])
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what the code of the FMU prints is no answer
    description = read_model_description(file)
    folder = extract(file)
    try:
        play(description, folder, start, answers)
    finally:
        rmtree(folder, ignore_errors=True)
    return 0


def play(description: Any, folder: str, start: int, answers: Any) -> None:
    """Instantiate, step, and end."""
    from fmpy.fmi2 import FMU2Slave
    from fmpy.fmi3 import FMU3Slave

    kind = FMU3Slave if description.fmiVersion.startswith("3") else FMU2Slave
    fmu = kind(
        guid=description.guid, modelIdentifier=description.coSimulation.modelIdentifier, unzipDirectory=folder, instanceName="sigcat"
    )  # fmt: skip
    outputs = [each for each in description.modelVariables if each.causality == "output"]
    fmu.instantiate()
    begin = start / 1e9
    if kind is FMU2Slave:
        fmu.setupExperiment(startTime=begin)
    fmu.enterInitializationMode(**({} if kind is FMU2Slave else {"startTime": begin}))
    fmu.exitInitializationMode()
    now = start
    for line in sys.stdin:
        length, values = json.loads(line)
        for reference, type_, numbers in values:
            getattr(fmu, f"set{_ACCESSED_AS.get(type_, type_)}")([reference], numbers)
        fmu.doStep(currentCommunicationPoint=now / 1e9, communicationStepSize=length / 1e9)
        now += length
        json.dump([_values(fmu, each) for each in outputs], answers)
        answers.write("\n")
        answers.flush()
    fmu.terminate()
    fmu.freeInstance()


def _values(fmu: Any, variable: Any) -> list[Any]:
    count = 1
    for dimension in variable.dimensions:
        count *= int(dimension.start)
    get = getattr(fmu, f"get{_ACCESSED_AS.get(variable.type, variable.type)}")
    many = {"nValues": count} if count > 1 else {}
    return [getattr(each, "value", each) for each in get([variable.valueReference], **many)]


if __name__ == "__main__":
    sys.exit(main())
