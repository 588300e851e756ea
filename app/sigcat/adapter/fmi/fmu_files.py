"""From Integration JSON to the sources of FMUs, and a CMake project that builds and packs them.

A build finds the code of functions by the settings of CMake that other platforms have, such as `CORE_ACC_CODE`.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat import codes
from sigcat.adapter.core.core_files import RUNTIME_SOURCE, all_files
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.files import GeneratedFile, shipped, within
from sigcat.adapter.fmi.bus.formula import OPERATIONS, in_c
from sigcat.adapter.fmi.bus.plan import bus_plan, double
from sigcat.adapter.fmi.clocks import clocks_of, is_inside
from sigcat.adapter.fmi.dependencies import dependencies
from sigcat.adapter.fmi.fmi_integration import LONGEST_NAME, Unit, units_of
from sigcat.adapter.fmi.units import FmiUnit, fmi_units
from sigcat.adapter.fmi.variables import Variable
from sigcat.adapter.host.glue import HOST_HEADER, glue_file
from sigcat.adapter.host.numbering import numbers_of
from sigcat.adapter.host.shapes import packing
from sigcat.adapter.placed_findings import placed_in
from sigcat.adapter.source_functions import source_functions
from sigcat.adapter.templates import rendered
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.function.document.text import Text
from sigcat.integration.fmi.document import read_integration
from sigcat.integration.fmi.model import FmiIntegration, Fmu, FmuVariable
from sigcat.integration.report import Entry, FieldTarget, entries
from sigcat.limits import Limits

_C = Path(__file__).with_name("c")
_C2 = Path(__file__).with_name("c2")
_ICON = Path(__file__).with_name("icon.png")
_C_BUS = Path(__file__).parent / "bus" / "c"
_BUS_VARIABLES = ("Rx_Clock", "Rx_Data", "Tx_Clock", "Tx_Data")
_CPP = frozenset((".cc", ".cpp", ".cxx", ".c++", ".C"))
_FREE = {"name": "", "description": ""}
_AGAIN = "Integrate the functions again."


class _Source(NamedTuple):
    """A function in an FMU: its code, and the files around it."""

    name: str
    origin: Text
    """File that declares it, for readers."""
    setting: str
    """Setting of CMake that names the folder of its code."""
    code: tuple[tuple[str, str, str], ...]
    """Sources, from the folder of the code, and their paths and folders in the FMU."""
    folders: tuple[tuple[str, str], ...]
    """Folders of headers, likewise."""
    definitions: tuple[str, ...]
    generated: tuple[str, ...]
    """Sources of the core and of its caller."""


class _FmuPlan(NamedTuple):
    """Plan of the files of an FMU."""

    model: FmiIntegration
    fmu: Fmu
    functions: tuple[_Source, ...]
    variables: tuple[tuple[FmuVariable, Variable], ...]
    inputs: tuple[tuple[int, int, int, int], ...]
    """Function, receiver, offset, and the first input of the same variable."""
    outputs: tuple[tuple[int, int, tuple[int, ...]], ...]
    """Offset, size and the inputs that get it."""
    calls: tuple[tuple[str, bool], ...]
    """Calls with a clock, and whether a signal that the function itself sends triggers them."""
    parameters: tuple[int, ...]
    values: bytes
    is_single: bool
    is_copied: bool
    is_cpp: bool
    bus_variables: tuple[str, ...]
    """Names of the variables of its bus, in the order of their value references."""
    hidden: frozenset[int]
    """Value references of variables that are only on the bus."""
    units: tuple[FmiUnit, ...]
    measured: tuple[tuple[str, FmiUnit], ...]
    """Datatypes with units of its variables, each once."""
    enumerations: tuple[FmuVariable, ...]
    depends: Mapping[int, tuple[int, ...]]
    """Value references on which each output depends."""
    languages: tuple[tuple[str, tuple[str, ...]], ...]
    """Languages, as FMI names them, and the sources in each."""


class _Outside(NamedTuple):
    """A variable that the system gets from outside or sends there, and the FMUs that have it."""

    variable: FmuVariable
    fmus: tuple[str, ...]


@collector_paused()
def generate(data: bytes, name: str, limits: Limits) -> tuple[GeneratedFile, ...]:
    """A folder for each FMU, the system of all of them, and a CMake project. The same document gives the same bytes.

    Raises InputRefused if the document cannot be used, or a core cannot be generated.
    """
    model = read_integration(data, name, limits)
    functions = source_functions(model.functions, data, name, limits, codes.NOT_WRITABLE_AS_FMU, "fmi")
    with placed_in(data, name, limits):
        name_of_set = model.fmus[0].name if len(model.fmus) == 1 else None
        units = units_of(functions, name_of_set, has_arrays=model.version is None)
        _check(model, units)
    fmus = tuple(_plan(fmu, unit, model) for fmu, unit in zip(model.fmus, units, strict=True))
    project = {
        "model": model,
        "fmus": fmus,
        "languages": "C CXX" if any(each.is_cpp for each in fmus) else "C",
        "units": fmi_units(each.name for plan in fmus for each in plan.units),
        # Name of the package of the system, without its ending, and its connectors.
        "system_name": identifier(model.info.function_name)[:LONGEST_NAME],
        "outside": _outside(model, fmus),
    }
    return (
        *(_file(name, project) for name in ("CMakeLists.txt", "README.md", "SystemStructure.ssd")),
        *(file for plan, unit in zip(fmus, units, strict=True) for file in within(plan.fmu.name, _files(plan, unit))),
    )


def report(data: bytes, name: str, limits: Limits) -> tuple[Entry, ...]:
    """The place of each field of the document. Raises InputRefused if the document cannot be used."""
    model = read_integration(data, name, limits)
    return tuple(entry for part in _parts(model) for entry in _entries(*part))


def _parts(model: FmiIntegration) -> Iterator[tuple[str, str, str, BaseModel, str]]:
    """Each part of the document: its owner, its name and kind, and the file that has its fields."""
    for fmu in model.fmus:
        description = f"{fmu.name}/modelDescription.xml"
        yield fmu.name, fmu.name, "FMU", fmu, description
        yield from ((fmu.name, clock.name, "clock", clock, description) for clock in fmu.clocks or ())
        yield from ((fmu.name, each.name, "variable", each, description) for each in fmu.variables)
        tables = f"{fmu.name}/sources/sigcat_bus_model.c"
        yield from ((fmu.name, name, "bus", part, tables) for name, part in _bus_parts(fmu))
    for one in model.connections:
        yield one.end_fmu, one.end_variable, "connection", one, "SystemStructure.ssd"


def _entries(owner: str, name: str, kind: str, part: BaseModel, file: str) -> list[Entry]:
    fields = [str(field.alias or key) for key, field in type(part).model_fields.items()]
    return entries(owner, name, kind, part, dict.fromkeys(fields, FieldTarget(file)))


def _outside(model: FmiIntegration, fmus: Sequence[_FmuPlan]) -> tuple[_Outside, ...]:
    """Return outputs, and inputs that no FMU of the system sends; those of one name and datatype are one."""
    inside = {(each.end_fmu, each.end_variable) for each in model.connections}
    found: dict[str, _Outside] = {}
    for causality in ("output", "input"):
        for plan in fmus:
            for each in plan.fmu.variables:
                name = plan.fmu.name
                if each.causality != causality or each.reference in plan.hidden or (name, each.name) in inside:
                    continue
                known = found.setdefault(each.name, _Outside(each, ()))
                is_alike = (known.variable.type, known.variable.length) == (each.type, each.length)
                if not known.fmus or (causality == known.variable.causality == "input" and is_alike):
                    found[each.name] = known._replace(fmus=(*known.fmus, name))
    return tuple(found.values())


def _bus_parts(fmu: Fmu) -> Iterator[tuple[str, BaseModel]]:
    """The bus of an FMU; its messages by their identifiers, their signals by their first bits, and the variables of these."""
    if fmu.bus is None:
        return
    yield fmu.bus.name, fmu.bus
    for message in fmu.bus.messages:
        yield f"{message.identifier:X}", message
        for signal in message.signals:
            yield f"{message.identifier:X}:{signal.start}", signal
            for each in signal.mappings:
                yield fmu.variables[each.reference].name, each


def _check(model: FmiIntegration, units: Sequence[Unit]) -> None:
    """Raise InputRefused unless the document has the FMUs and variables of its functions; names and descriptions are free."""
    if [each.name for each in units] != [each.name for each in model.fmus]:
        raise _unlike("/FmuList", "The FMUs must be those of the functions of the document.")
    for index, (fmu, unit) in enumerate(zip(model.fmus, units, strict=True)):
        _check_clocks(fmu, unit, model, index)
        _check_bus(fmu, index)
        at = f"/FmuList/{index}/VariableList"
        if len(fmu.variables) != len(unit.layout.variables):
            message = f"{fmu.name} must have {len(unit.layout.variables)} variables, as its functions, not {len(fmu.variables)}."
            raise _unlike(at, message)
        for number, (each, known) in enumerate(zip(fmu.variables, unit.layout.variables, strict=True)):
            wanted = (known.type, known.length, known.causality, known.start)
            if (each.type, each.length, each.causality, each.start) != wanted:
                message = (
                    f"{each.name} must have the type, dimension, causality and start value that its function gives it."
                )
                raise _unlike(f"{at}/{number}", message)


def _check_clocks(fmu: Fmu, unit: Unit, model: FmiIntegration, index: int) -> None:
    at = f"/FmuList/{index}/ClockList"
    if (fmu.clocks is None) != (model.interface is None):
        raise _unlike(at, f"{fmu.name} must have clocks if and only if its interface is scheduledExecution.")
    if fmu.clocks is None:
        return
    if model.version is not None or len(unit.connections.members) != 1:
        raise _unlike(at, f"{fmu.name} must be an FMU of FMI 3.0 with one function, as its calls have clocks.")
    known = [each.model_copy(update=_FREE) for each in clocks_of(unit.connections, unit.layout)]
    if [each.model_copy(update=_FREE) for each in fmu.clocks] != known:
        raise _unlike(
            at, f"{fmu.name} must have the clocks of its calls: value reference, interval, shift and priority."
        )


def _check_bus(fmu: Fmu, index: int) -> None:
    """Raise InputRefused if C cannot compute a formula of the bus."""
    for each in fmu.bus.mappings if fmu.bus else ():
        if each.formula is not None and in_c(each.formula) is None:
            at = f"/FmuList/{index}/CanBus"
            raise _unlike(at, f"The formula {each.formula} must have only {OPERATIONS}.")


def _unlike(pointer: str, message: str) -> InputRefused:
    finding = codes.NOT_WRITABLE_AS_FMU.finding(message, pointer=pointer, fix=_AGAIN)
    return InputRefused("The document cannot be used.", (finding,))


def _plan(fmu: Fmu, unit: Unit, model: FmiIntegration) -> _FmuPlan:
    layout, connections = unit.layout, unit.connections
    plans = [member.plan for member in connections.members]
    seen = [0] * len(plans)
    inputs: list[tuple[int, int, int, int]] = []
    for entry, place in zip(connections.entries, layout.inputs, strict=True):
        inputs.append((entry.member, seen[entry.member], *place))
        seen[entry.member] += 1
    shown = [each for each in fmu.variables if fmu.bus is None or each.reference not in fmu.bus.hidden]
    units = {each.name: each for each in fmi_units(each.unit for each in fmu.variables if each.unit)}
    measured = dict.fromkeys((each.type, each.unit) for each in shown if each.unit and each.type.startswith("Float"))
    has_globals = any(each.has_globals for each in plans)
    is_cpp = any(each.code.is_cpp for each in plans)
    sizes = [packing(each.shape).struct.size for each in connections.exits]
    sources = tuple(_source(each, is_alone=len(plans) == 1) for each in plans)
    return _FmuPlan(
        model=model, fmu=fmu,
        functions=sources,
        variables=tuple(zip(fmu.variables, layout.variables, strict=True)),
        inputs=tuple(inputs),
        outputs=tuple(zip(layout.outputs, sizes, connections.routes, strict=True)),
        calls=tuple((each.name, is_inside(each, connections)) for each in plans[0].steps if fmu.clocks is not None),
        parameters=layout.parameters, values=layout.values,
        is_single=has_globals, is_copied=not has_globals and not is_cpp, is_cpp=is_cpp,
        languages=tuple(_languages(sources, model, has_bus=fmu.bus is not None)),
        bus_variables=_BUS_VARIABLES if fmu.bus is not None else (),
        hidden=fmu.bus.hidden if fmu.bus is not None else frozenset(),
        units=tuple(units.values()),
        measured=tuple((name, units[unit]) for name, unit in measured if unit),
        enumerations=tuple(each for each in shown if each.items),
        depends=dependencies(connections, layout),
    )  # fmt: skip


def _languages(
    sources: Sequence[_Source], model: FmiIntegration, *, has_bus: bool
) -> Iterator[tuple[str, tuple[str, ...]]]:
    of_version = ("sigcat_fmi2.c",) if model.version else ()
    of_bus = ("sigcat_bus.c", "sigcat_bus_model.c") if has_bus else ()
    of_fmi = ("sigcat_fmu.c", *of_version, *of_bus, "sigcat_model.c", RUNTIME_SOURCE)
    own = [name for each in sources for name in (*each.generated, *(inside for _, inside, _ in each.code))]
    cpp = tuple(each for each in own if Path(each).suffix in _CPP)
    yield "C99", (*of_fmi, *(each for each in own if each not in cpp))
    if cpp:
        yield "C++17", cpp


def _source(plan: CorePlan, *, is_alone: bool) -> _Source:
    root = () if is_alone else ("code", plan.function)
    code = [(each, _inside(each, root)) for each in plan.code.sources]
    around = (str(PurePosixPath(each).parent) for each in (*plan.code.sources, *plan.code.headers))
    return _Source(
        name=plan.function,
        origin=plan.provenance.text,
        setting=plan.code_setting,
        code=tuple((each, inside, str(PurePosixPath(inside).parent)) for each, inside in code),
        folders=tuple(
            (each, _inside(each, root)) for each in dict.fromkeys((".", *plan.code.include_folders, *around))
        ),
        definitions=plan.code.definitions,
        generated=(plan.source_file, f"{plan.function}_driver.{plan.code.ending}"),
    )


def _inside(path: str, root: tuple[str, ...]) -> str:
    """A path of the code in the sources of an FMU: nothing is above the folder of the function."""
    steps = ["up" if step == ".." else step for step in re.split(r"[/\\]", path) if step not in ("", ".")]
    return "/".join((*root, *steps)) or "."


def _files(plan: _FmuPlan, unit: Unit) -> Iterator[GeneratedFile]:
    template = "modelDescription2.xml" if plan.model.version else "modelDescription.xml"
    names = plan._asdict()
    yield _file(template, names)._replace(name="modelDescription.xml")
    yield _file("documentation/index.html", names)
    yield _file("documentation/licenses/license.html", names)
    icon = _ICON.read_bytes()
    if plan.model.version:
        yield GeneratedFile("model.png", icon)
    else:
        yield GeneratedFile("terminalsAndIcons/icon.png", icon)
        yield _file("terminalsAndIcons/terminalsAndIcons.xml", names)
    if plan.fmu.bus is not None:
        yield _file("extra/org.fmi-standard.fmi-ls-bus/fmi-ls-manifest.xml", names)
    numbers = numbers_of(unit.connections)
    sources: list[GeneratedFile] = [
        *(() if plan.model.version else (_file("buildDescription.xml", names),)),
        _file("sigcat_model.c", names),
        *all_files(member.plan for member in unit.connections.members),
        *(glue_file(unit.connections, numbers, index) for index in range(len(unit.connections.members))),
        *shipped(_C),
        *(shipped(_C2) if plan.model.version else ()),
        *_bus_sources(plan, unit),
        GeneratedFile(HOST_HEADER.name, HOST_HEADER.read_bytes()),
    ]
    yield from within("sources", sources)


def _bus_sources(plan: _FmuPlan, unit: Unit) -> Iterator[GeneratedFile]:
    if plan.fmu.bus is None:
        return
    tables = bus_plan(plan.fmu.bus, unit.layout)._asdict()
    yield from shipped(_C_BUS)
    for name in ("sigcat_bus_sizes.h", "sigcat_bus_model.c"):
        yield GeneratedFile(name, rendered(f"adapter/fmi/bus/{name}.j2", double=double, **tables).encode())


def _file(name: str, names: Mapping[str, Any]) -> GeneratedFile:
    return GeneratedFile(name, rendered(f"adapter/fmi/{name.rpartition('/')[2]}.j2", **names).encode())
