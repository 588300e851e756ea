"""An FMU in a separate process: `python -m sigcat.players.fmu_process FILE MEMORY_MIB`, which limits what it may allocate.

The first line of standard input lists the outputs to read, as JSON: value reference, type and count of elements. Each other line is a step:
its length in ns, and what is set before it. Standard output has `ready`, and then a line for each step: its outputs. What the FMU
reports goes to standard error.
"""

import json
import os
import sys
from pathlib import Path
from shutil import rmtree
from typing import Any

_NUMBERS_OF_ENUMERATIONS = {"2": "Integer", "3": "Int64"}


def main() -> int:
    """Play steps until the input ends."""
    from fmpy import extract, read_model_description

    file, memory = sys.argv[1], int(sys.argv[2])
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # the code of the FMU prints to standard error
    description = read_model_description(file)
    folder = extract(file)
    _limit(memory)
    try:
        play(description, folder, answers)
    finally:
        rmtree(folder, ignore_errors=True)
    return 0


def play(description: Any, folder: str, answers: Any) -> None:
    """Instantiate, step, and end."""
    from fmpy.fmi2 import FMU2Slave
    from fmpy.fmi3 import FMU3Slave

    kind = FMU3Slave if description.fmiVersion.startswith("3") else FMU2Slave
    fmu = kind(
        guid=description.guid, modelIdentifier=description.coSimulation.modelIdentifier, unzipDirectory=folder, instanceName="sigcat"
    )  # fmt: skip
    accessed_as = {"Enumeration": _NUMBERS_OF_ENUMERATIONS[description.fmiVersion[0]]}
    outputs = json.loads(sys.stdin.readline())
    fmu.instantiate()
    if kind is FMU2Slave:
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
    else:
        fmu.enterInitializationMode(startTime=0.0)
    fmu.exitInitializationMode()
    answers.write("ready\n")
    answers.flush()
    now = 0
    for line in sys.stdin:
        length, values = json.loads(line)
        for reference, type_, numbers in values:
            getattr(fmu, f"set{accessed_as.get(type_, type_)}")([reference], numbers)
        fmu.doStep(currentCommunicationPoint=now / 1e9, communicationStepSize=length / 1e9)
        now += length
        json.dump(
            [_values(fmu, reference, accessed_as.get(type_, type_), count) for reference, type_, count in outputs],
            answers,
        )
        answers.write("\n")
        answers.flush()
    fmu.terminate()
    fmu.freeInstance()


def _limit(mebibytes: int) -> None:
    """Limit the memory that the code may allocate beside what the process has."""
    if sys.platform == "win32":
        return
    import resource

    statm = Path("/proc/self/statm")
    present = int(statm.read_text().split()[0]) * resource.getpagesize() if statm.exists() else 0
    most = present + mebibytes * 2**20
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _values(fmu: Any, reference: int, type_: str, count: int) -> list[Any]:
    many = {"nValues": count} if count > 1 else {}  # FMI 2.0 has no arrays
    return list(getattr(fmu, f"get{type_}")([reference], **many))


if __name__ == "__main__":
    sys.exit(main())
