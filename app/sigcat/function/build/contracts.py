"""What a call reads and writes: signals, queues, parameters, errors, safety reactions and methods, resolved."""

import json
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.catalogue.model.interfaces import function_of, interface_name
from sigcat.function.build.references import interface_node, number_of, text_of, texts_of
from sigcat.function.build.values import Value, resolve
from sigcat.function.build.work import Work
from sigcat.function.declaration.declaration import (
    ArgumentItem,
    DataItem,
    ErrorItem,
    MethodItem,
    ParameterItem,
    ReactionItem,
    RunnableItem,
)
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_number, as_text
from sigcat.function.function_json.datatypes import BY_REFERENCE, value_range
from sigcat.function.function_json.model import (
    CONSUMER,
    PROVIDER,
    Argument,
    Contract,
    DataQueue,
    Error,
    Method,
    Parameter,
    SafetyReaction,
    Signal,
)
from sigcat.function.function_json.types import symbols_of

ROLES = {"consumed": CONSUMER, "provided": PROVIDER}


def contract(runnable: RunnableItem, at: Pointer, target: Pointer, work: Work) -> Contract | None:
    """The contract of a call, or None if it reads and writes nothing. `target` is its place in the Function JSON."""
    signals: list[Signal] = []
    queues: list[DataQueue] = []
    for index, item in enumerate(runnable.data):
        _add_data(item, (*at, "data", index), target, signals, queues, work)
    parameters = _each(runnable.parameters, "parameters", "ParameterList", at, target, work, _parameter)
    errors = _each(runnable.errors, "errors", "ErrorList", at, target, work, _error)
    reactions = _each(runnable.safety_reactions, "safetyReactions", "SafetyReactionList", at, target, work, _reaction)
    methods = _each(runnable.methods, "methods", "MethodList", at, target, work, _method)
    if not (signals or queues or parameters or errors or reactions or methods):
        return None
    return Contract(
        type=runnable.contract,
        signals=tuple(signals) or None,
        queues=tuple(queues) or None,
        methods=methods,
        parameters=parameters,
        errors=errors,
        safety_reactions=reactions,
    )


def _each(
    items: Iterable[Any], key: str, list_name: str, at: Pointer, target: Pointer, work: Work, make: Any
) -> tuple[Any, ...] | None:
    """Make every item of a list; what could not be made is left out, and has findings."""
    made: list[Any] = []
    for index, item in enumerate(items):
        result = make(item, (*at, key, index), work)
        if result is not None:
            work.trace[(*target, list_name, len(made))] = (*at, key, index)
            made.append(result)
    return tuple(made) or None


# -- data ---------------------------------------------------------------------------------------------------------


def _add_data(
    item: DataItem, at: Pointer, target: Pointer, signals: list[Signal], queues: list[DataQueue], work: Work
) -> None:
    value = resolve(item, at, work)
    if value is None:
        return
    if value.node.type == "attribute" and item.role == "provided":
        work.report(
            "F028", (*at, "role"), f"{item.path!r} is an attribute; functions do not provide it.", path=item.path
        )
    if item.queue_length is None:
        work.trace[(*target, "SignalList", len(signals))] = at
        signals.append(_signal(item, value, at, work))
    else:
        work.trace[(*target, "DataQList", len(queues))] = at
        queues.append(_queue(item, value, at, work))


def _common(item: DataItem | ParameterItem, value: Value) -> dict[str, Any]:
    node = value.node
    return {
        "name": item.name or node.name,
        "description": str(node.values.get("description") or ""),
        "datatype": value.reference,
        "min": value.min,
        "max": value.max,
        "vss_path": node.path,
        "vss_datatype": node.values["datatype"],
        "vss_unit": node.values.get("unit"),
        "conversion_factor": _text(value.conversion, 0),
        "conversion_offset": _text(value.conversion, 1),
        "variable": item.variable,
    }


def _text(conversion: Linear | None, part: int) -> str | None:
    return as_text(conversion[part]) if conversion else None


def _asil(item: DataItem | ParameterItem, node: Node) -> str | None:
    return item.asil or text_of(node, "ASILlevel")


def _time_out(item: DataItem, at: Pointer, work: Work) -> dict[str, Any]:
    error = None
    if item.timeout_error is not None:
        node = interface_node(item.timeout_error, "error", (*at, "timeoutError"), work)
        error = interface_name(node.path) if node else None
    return {"timeout": _plain(item.timeout), "timeout_error": error, "range_error_action": item.range_error_action}


def _plain(number: float | None) -> str | None:
    """A number as a text of the wire format: 200.0 → `200`."""
    return None if number is None else str(int(number) if number == int(number) else number)


def _signal(item: DataItem, value: Value, at: Pointer, work: Work) -> Signal:
    resolution = value.node.values.get("resolution")
    return Signal(
        role=ROLES[item.role],
        asil_level=_asil(item, value.node),
        access=item.access,
        factor=_plain(item.factor),
        offset=_plain(item.offset),
        default=value.default,
        init_value=value.init,
        units=value.unit,
        type=value.node.type,
        external_provider=item.provider,
        resolution=resolution if isinstance(resolution, int | float) else None,
        **_common(item, value),
        **_time_out(item, at, work),
    )


def _queue(item: DataItem, value: Value, at: Pointer, work: Work) -> DataQueue:
    assert item.queue_length is not None
    return DataQueue(
        role=ROLES[item.role],
        asil_level=_asil(item, value.node) or "QM",
        queue_length=item.queue_length,
        factor=1 if item.factor is None else item.factor,
        offset=item.offset or 0,
        init_value=value.init or 0,
        units=value.unit or "",
        type=value.node.type,
        external_provider=item.provider,
        **_common(item, value),
        **_time_out(item, at, work),
    )


def _parameter(item: ParameterItem, at: Pointer, work: Work) -> Parameter | None:
    value = resolve(item, at, work)
    if value is None:
        return None
    if value.node.type != "attribute":
        message = f"{item.path!r} is of type {value.node.type}, not an attribute: its value changes while driving."
        work.report("F028", (*at, "path"), message, "List it under `data`.", item.path)
    text = _default_text(value)
    start = value.init if value.default is None else value.default
    if start is None and text is None:
        fix = "Give `init`, or a default in the catalogue."
        work.report("F027", at, f"{item.path!r} has no default.", fix, item.path)
    low, high = _limits(value)
    return Parameter(
        asil_level=_asil(item, value.node) or "QM",
        default=start or 0,
        init_value=value.init or 0,
        range_error_action=item.range_error_action,
        interface_type=item.kind,
        attribute=item.attribute,
        units=value.unit or "",
        default_text=text,
        **{**_common(item, value), "min": low, "max": high},
    )


def _default_text(value: Value) -> str | None:
    """The catalogue's default of a parameter that is a text; of an array its elements as JSON, in the code's unit."""
    default = value.node.values.get("default")
    if isinstance(default, list) and is_array(str(value.node.values["datatype"])):
        to_code = value.conversion.inverse if value.conversion else IDENTITY
        return json.dumps([_element(each, to_code) for each in default], ensure_ascii=False)
    is_text = element_of(str(value.node.values["datatype"])) == "string" and symbols_of(value.node) is None
    return default if is_text and isinstance(default, str) else None


def _element(value: Any, to_code: Linear) -> Any:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return as_number(to_code(Fraction(str(value)))) if is_number and to_code != IDENTITY else value


def _limits(value: Value) -> tuple[float, float]:
    """The wire format requires limits: those of the datatype where the catalogue has none, 0 where there are none."""
    row = BY_REFERENCE.get(value.reference)
    low, high = (value_range(row.vss) if row else None) or (0, 0)
    return (low if value.min is None else value.min), (high if value.max is None else value.max)


# -- errors and safety reactions ----------------------------------------------------------------------------------


def _error(item: ErrorItem, at: Pointer, work: Work) -> Error | None:
    node = interface_node(item.interface, "error", at, work, own=True)
    if node is None:
        return None
    return Error(
        name=interface_name(node.path),
        description=str(node.values.get("description") or ""),
        datatype=_type_of(node, work),
        dependencies=texts_of(node, "dependency", at, work),
        occurrence_count_limit=item.occurrence_count_limit,
        ignition_count_limit=item.ignition_count_limit,
        maturation_time=int(number_of(node, "maturationTime", at, work) or 0),
        severity=text_of(node, "severity") or "",
        reset_time=number_of(node, "resetTime", at, work),
        reset_condition=text_of(node, "resetCondition"),
        asil_level=text_of(node, "ASILlevel"),
        vss_path=node.path,
    )


def _reaction(item: ReactionItem, at: Pointer, work: Work) -> SafetyReaction | None:
    node = interface_node(item.interface, "safety_reaction", at, work)
    if node is None:
        return None
    return SafetyReaction(
        name=interface_name(node.path),
        description=str(node.values.get("description") or ""),
        datatype=_type_of(node, work),
        errors=texts_of(node, "errorList", at, work),
        asil_level=text_of(node, "ASILlevel"),
        vss_path=node.path,
    )


def _type_of(node: Node, work: Work) -> str:
    """Reference to the datatype of an error or a safety reaction; all of a function share one enumeration."""
    suffix = interface_name(node.path).rpartition("_")[2]
    name = f"{node.template.partition('.')[0]}.{function_of(node.path)}.{suffix}"
    return work.types.reference(str(node.values.get("datatype")), name, symbols_of(node))


# -- methods ------------------------------------------------------------------------------------------------------


def _method(item: MethodItem, at: Pointer, work: Work) -> Method:
    return Method(
        name=item.name,
        description=item.description,
        role=ROLES[item.role],
        inputs=_arguments(item.inputs, (*at, "inputs"), work),
        outputs=_arguments(item.outputs, (*at, "outputs"), work),
    )


def _arguments(items: list[ArgumentItem], at: Pointer, work: Work) -> tuple[Argument, ...]:
    made = []
    for index, item in enumerate(items):
        place = (*at, index)
        if element_of(item.datatype) not in work.datatypes:
            fix = work.hint(item.datatype, work.datatypes)
            work.report("F029", (*place, "datatype"), f"{item.datatype!r} is no datatype.", fix)
            continue
        if item.unit is not None and work.catalogue.vocabulary.unit(item.unit) is None:
            keys = [unit.key for unit in work.catalogue.vocabulary.distinct_units]
            work.report("F021", (*place, "unit"), f"{item.unit!r} is no unit.", work.hint(item.unit, keys))
        made.append(Argument(name=item.name, datatype=work.types.reference(item.datatype), units=item.unit or ""))
    return tuple(made)
