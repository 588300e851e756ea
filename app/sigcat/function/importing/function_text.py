"""The text of a function.yaml: every entry with the line of the code that it comes from."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.asil import Level, rank
from sigcat.catalogue.near_signals import PLACEHOLDER
from sigcat.function.c_project.declarations import Place
from sigcat.function.c_project.project import Call, CodeProject
from sigcat.function.function_json.duration import whole_nanoseconds
from sigcat.function.importing.parameters import ParameterEntry
from sigcat.function.importing.signals import Signal
from sigcat.function.importing.yaml_text import comment, entry, inline, scalar
from sigcat.names import camel_case

_MOST_NAMED = 5
ASSUMED_CYCLE = 10
"""Cycle time in ms of a step whose code tells none."""


class Draft(NamedTuple):
    """Content of a function.yaml."""

    function: str
    project: CodeProject
    signals: tuple[Signal, ...]
    parameters: tuple[ParameterEntry, ...]
    folder: str
    """The folder of the code, as seen from the file."""
    schema: str
    known: frozenset[str] = frozenset()
    """Last names of the scheduling interfaces that the catalogue has for the function already."""
    errors: tuple[str, ...] = ()
    """Interface names of the errors that the catalogue has for the function."""
    data: Mapping[str, Mapping[str, Any]] = {}
    """Signals that the function defines, and branches above them, by path."""


def function_text(draft: Draft) -> str:
    """The whole file."""
    parts = (_head(draft), _code(draft), _define(draft), _components(draft))
    texts = ("\n".join(part) for part in parts)
    return "\n\n".join(text for text in texts if text) + "\n"


# -- head and code ------------------------------------------------------------------------------------------------


def _head(draft: Draft) -> Iterator[str]:
    project = draft.project
    title = project.title
    made_by = f", version {title['version']}" if "version" in title else ""
    tool = f", Simulink Coder {title['tool']}" if "tool" in title else ""
    yield f"# yaml-language-server: $schema={draft.schema}"
    yield "#"
    name = title.get("model", project.model) or draft.function
    yield comment(0, f"Imported from the C code of {name}{made_by}{tool}.")
    yield comment(0, "Comments name the line of the code that an entry comes from.")
    for line in to_do(draft):
        yield comment(0, f"To do: {line}")
    yield ""
    yield entry(0, "function", draft.function)
    yield entry(0, "description", "Says in one sentence what the function does.")
    yield entry(0, "responsible", "Name of a team")
    yield entry(0, "version", "0.1.0")


def to_do(draft: Draft) -> Iterator[str]:
    """Yield what the author has to complete, because the code does not tell it."""
    unchosen = sum(not signal.is_chosen for signal in draft.signals)
    if unchosen:
        yield f"choose {unchosen} path{'s' if unchosen > 1 else ''} (those with {PLACEHOLDER})."
    for call in draft.project.calls:
        if call.kind == "step" and cycle_time(call) is None and _last_name(call, draft.project) not in draft.known:
            why = "is not whole nanoseconds" if call.cycle_time else "the code does not tell"
            yield f"give the cycle time of {call_name(call, draft)}, which {why}; {ASSUMED_CYCLE} ms is assumed."
    without_unit = sum(bool(signal.catalogue_unit and not signal.unit) for signal in draft.signals)
    if without_unit:
        yield f"check {without_unit} unit{'s' if without_unit > 1 else ''}: where the code tells none, that of the catalogue is assumed."
    unknown = dict.fromkeys(signal.unknown_unit for signal in draft.signals if signal.unknown_unit)
    if unknown:
        yield f"define units that the code names and the catalogue does not have, or convert the values: {', '.join(unknown)}."
    if any(call.returns and call.kind == "init" for call in draft.project.calls):
        yield "check that 0 is what init returns for success."
    if draft.project.left_out:
        named = ", ".join(
            f"{each.name} ({_in(draft.folder, each.place)})" for each in draft.project.left_out[:_MOST_NAMED]
        )
        more = len(draft.project.left_out) - _MOST_NAMED
        yield f"add other functions that must be called, as calls or methods: {named}{f' and {more} more' if more > 0 else ''}."
    without_value = sum(bool(each.definition) and each.value.start is None for each in draft.parameters)
    if without_value:
        yield f"give the defaults of {without_value} parameter{'s' if without_value > 1 else ''}, which the code does not tell."
    yield "describe the function, and give each entry its ASIL: QM is assumed."


def cycle_time(call: Call) -> float | int | None:
    """Time in ms from one call to the next; None if the code tells no time of whole nanoseconds."""
    time = call.cycle_time
    if not time or whole_nanoseconds(time) is None:
        return None
    return int(time) if time == int(time) else time


def _code(draft: Draft) -> Iterator[str]:
    project = draft.project
    yield "code:"
    of_headers = (Path(path).parent.as_posix() for path in project.headers)
    folders = [_below(draft.folder, path) for path in dict.fromkeys((*of_headers, *project.include_folders))]
    entries = {
        "signature": project.signature,
        "class": project.class_name,
        "sources": [_below(draft.folder, path) for path in project.sources],
        "headers": [Path(path).name for path in project.headers],
        "includeFolders": folders if folders != ["."] else [],  # there headers are found without
        "definitions": dict(map(_definition, project.definitions)),
    }
    yield from (entry(2, key, value) for key, value in entries.items() if value)
    if project.machine:
        way = f"compile it for a machine of {project.machine}, such as by -m32."
        yield comment(2, f"The code checks the sizes of words: {way}")
    if project.interface.objects:
        yield "  objects:"
    for each in project.interface.objects:
        by_adapter = "adapter" if project.signature == "globals" else None  # with pointers the adapter always does
        keys = {"name": each.name, "type": each.type, "length": each.length or None, "member": each.member or None,
                "definedBy": by_adapter}  # fmt: skip
        yield f"    - {inline({key: text for key, text in keys.items() if text})}{_from(each.place, draft)}"


def _definition(text: str) -> tuple[str, str | None]:
    name, sign, value = text.partition("=")
    return name, value if sign else None


def _below(folder: str, path: str) -> str:
    return Path(folder, path).as_posix()


def _from(place: Place, draft: Draft) -> str:
    return f"  # {_in(draft.folder, place)}" if place.file else ""


def _in(folder: str, place: Place) -> str:
    return f"{_below(folder, place.file)}:{place.line}"


# -- what the function defines ------------------------------------------------------------------------------------


def _define(draft: Draft) -> Iterator[str]:
    """Yield definitions that the catalogue does not have yet."""
    parameters = [each for each in draft.parameters if each.definition]
    named = [(_last_name(call, draft.project), call) for call in draft.project.calls]
    calls = [each for each in named if each[0] not in draft.known]
    if parameters or calls or draft.data:
        yield "define:"
    if draft.data:
        yield "  data:"
    for path, definition in draft.data.items():
        yield from data_definition(path, definition)
    if parameters:
        yield "  parameters:"
    for parameter in parameters:
        yield from parameter_definition(parameter, draft)
    if calls:
        yield "  scheduling:"
    for name, call in calls:
        yield f"    {name}:"
        yield from (entry(6, key, value) for key, value in _schedule(call, draft).items())


def data_definition(path: str, definition: Mapping[str, Any]) -> Iterator[str]:
    """A signal, or a branch above it."""
    yield f"    {path}:"
    yield from (entry(6, key, value) for key, value in definition.items())


def parameter_definition(parameter: ParameterEntry, draft: Draft) -> Iterator[str]:
    """A parameter with its default."""
    place = _from(parameter.value.place, draft)
    yield f"    {scalar(parameter.name)}:{place} {parameter.value.type_name}"
    yield from (comment(6, note) for note in parameter.notes)
    yield from (entry(6, key, value) for key, value in parameter.definition.items())


def _schedule(call: Call, draft: Draft) -> dict[str, Any]:
    texts = {"init": "Initializes the function.", "step": "Computes the outputs.", "terminate": "Ends the function."}
    is_step = call.kind == "step"
    schedule = {
        "cycleTime": (cycle_time(call) or ASSUMED_CYCLE) if is_step else None,
        "priority": {"init": 20, "step": 10, "terminate": 30}[call.kind],
        "scheduling": "Preemptive" if is_step else "NonPreemptive",
        "asil": _asil(draft) if is_step else "QM",
        "description": texts[call.kind],
    }
    return {key: value for key, value in schedule.items() if value is not None}


def _asil(draft: Draft) -> Level:
    """The highest one that the catalogue has for what the function provides."""
    provided = (each.catalogue_asil for each in draft.signals if each.role == "provided")
    return max((level for level in provided if level), key=rank, default="QM")


def _last_name(call: Call, project: CodeProject) -> str:
    """Init, Step, Terminate; of several steps, what tells them apart before `Step`."""
    if call.kind != "step" or len(project.steps) == 1:
        return call.kind.capitalize()
    own = camel_case(call.symbol.removeprefix(project.model))
    rest = own[len("step") :] if own.lower().startswith("step") else own
    first = "Task" if rest[:1].isdigit() else "" if rest else "Base"
    return f"{first}{rest}Step"


def call_name(call: Call, draft: Draft) -> str:
    """Name of the interface of a call."""
    return f"{draft.function}_{_last_name(call, draft.project)}"


# -- calls --------------------------------------------------------------------------------------------------------


def _components(draft: Draft) -> Iterator[str]:
    yield "components:"
    yield f"  - name: {draft.function}"
    yield "    runnables:"
    steps = draft.project.steps
    for call in draft.project.calls:
        yield f"      - interface: {call_name(call, draft)}"
        yield f"        symbol: {scalar(call.symbol)}{_from(call.place, draft)}"
        if call.arguments:
            yield entry(8, "arguments", list(call.arguments))
        if call.returns and call.kind == "init":
            yield f"{entry(8, 'success', 0)}  # assumed"
        if call.kind == "step":
            yield from data_lines([each for each in draft.signals if is_of(each.value.key, call, steps)], draft)
            if call is steps[0] and draft.errors:
                yield entry(8, "errors", draft.errors)
            yield from parameter_lines([each for each in draft.parameters if is_of(each.value.key, call, steps)])


def is_of(key: str, call: Call, steps: Sequence[Call]) -> bool:
    """Whether a step uses a value; the first one has what none of several is known to use."""
    using = [step for step in steps if key in step.use.used or key in step.use.written]
    return call in using[:1] if using else call is steps[0]


def data_lines(signals: Sequence[Signal], draft: Draft) -> Iterator[str]:
    """The entries of a call's data."""
    if signals:
        yield "        data:"
    for signal in signals:
        yield from (comment(10, line) for line in said_of(signal, draft.folder))
        yield f"          - path: {scalar(signal.path)}"
        yield from (entry(12, key, value) for key, value in signal.keys.items())


def said_of(signal: Signal, folder: str) -> Iterator[str]:
    """Comments on a signal: first its line in the code."""
    value, remark = signal.value, signal.value.remark
    count = f"[{value.length}]" if value.length else ""
    said = f" {remark.text}" if remark.text else ""
    yield f"{_in(folder, value.place)} {value.type_name}{count}{said}"
    if signal.near:
        yield f"Near: {', '.join(signal.near)}"
    if signal.why:
        yield f"Not chosen: {signal.why}"
    if signal.catalogue_unit and not signal.unit:
        yield f"The code tells no unit: {signal.catalogue_unit}, as in the catalogue."
    if signal.unknown_unit:
        yield f"TODO: the code says {signal.unknown_unit}, which is not a unit of the catalogue."


def parameter_lines(parameters: Iterable[ParameterEntry]) -> Iterator[str]:
    """The entries of a call's parameters."""
    listed = list(parameters)
    if listed:
        yield "        parameters:"
    for parameter in listed:
        first, *others = parameter.keys.items()
        yield f"          - {first[0]}: {scalar(first[1])}"
        yield from (entry(12, key, value) for key, value in others)
