"""Signals, queues and parameters: what the catalogue knows of them, and what the declaration adds."""

import json
from typing import Any

from sigcat import codes
from sigcat.asil import Level
from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.function.declaration.declaration import DataItem, ParameterItem
from sigcat.function.declaration.form import key_of
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.document.text import Text, optional
from sigcat.function.function_json.conversion import IDENTITY, as_number, as_text, is_finite_number
from sigcat.function.function_json.datatypes.primitive_types import BY_REFERENCE, value_range
from sigcat.function.function_json.datatypes.type_list import listed, symbols_of
from sigcat.function.function_json.error_fields import error_fields
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.function_json.wire import WireModel
from sigcat.function.resolving.code import members, word
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.interfaces import Attributes, error_name
from sigcat.function.resolving.part import Part, written
from sigcat.function.resolving.values.elements import converted
from sigcat.function.resolving.values.numbers import fraction, plain_text
from sigcat.function.resolving.values.resolved_values import Value, value_of
from sigcat.names import with_article

ROLES = {"consumed": CONSUMER, "provided": PROVIDER}


def data_interface(item: DataItem, at: Pointer, context: Context) -> Part[Signal | DataQueue]:
    """A signal, or a queue where the declaration gives it a length."""
    value = value_of(item, at, context)
    if value is None:
        return Part(None, Origin(at))
    if value.node.type == "attribute" and item.role == "provided":
        message = f"The role of {item.path!r} must be consumed: functions do not provide attributes."
        subject = Subject("data", item.path)
        context.report(codes.ROLE_UNFIT_FOR_NODE_TYPE, (*at, "role"), message, subject=subject)
    is_signal = item.queue_length is None
    context.problems.extend(_of_no_queue(item, at))
    made = _signal(item, value, at, context) if is_signal else _queue(item, value, at, context)
    return Part(made, _origin(item, at, "AsilLevel" if is_signal else "AsilInfo"))


def _of_no_queue(item: DataItem, at: Pointer) -> Problems:
    """Fields that only a queue has."""
    for field in ("overflow", "overflow_error", "values_per_step", "count_variable"):
        if item.queue_length is None and getattr(item, field) is not None:
            key = key_of(field)
            message = f"{item.path!r} must be a queue to have `{key}`."
            fix, subject = "Give `queueLength`, or remove it.", Subject("data", item.path)
            yield Problem(codes.QUEUE_UNFIT, (*at, key), message, fix, subject)


def _origin(item: DataItem | ParameterItem, at: Pointer, asil_key: str) -> Origin:
    parts = dict(written(item, at))
    if "Asil" in parts:
        parts[asil_key] = parts.pop("Asil")
    if "InitValue" in parts:
        parts["InitElements"] = _elements(item.init, (*at, "init"))
    return Origin(at, parts)


def _elements(value: Any, at: Pointer) -> Origin:
    """Origin of the start value of an array or struct, with its elements or members."""
    keys = range(len(value)) if isinstance(value, list) else value if isinstance(value, dict) else ()
    return Origin(at, {key: _elements(value[key], (*at, key)) for key in keys})


def _common(item: DataItem | ParameterItem, value: Value) -> dict[str, Any]:
    node = value.node
    return {
        "name": item.name or node.name,
        "description": Text(str(node.values.get("description") or "")),
        "datatype": value.reference,
        "min": value.min,
        "max": value.max,
        "vss_path": node.path,
        "vss_datatype": node.values["datatype"],
        "vss_unit": node.values.get("unit"),
        "vss_symbols": listed(value.own_symbols) if value.own_symbols else None,
        "conversion_factor": as_text(value.conversion.factor) if value.conversion else None,
        "conversion_offset": as_text(value.conversion.offset) if value.conversion else None,
        "variable": item.variable,
        "defined_by": word(item.defined_by),
        "c_type": item.c_type,
        "members": members(item.members),
        "init_elements": value.init_elements,
    }


def _catalogue_range(value: Value) -> dict[str, Any]:
    """The catalogue's own range, in its unit: what is sent, whatever the code of one side takes."""
    limits = {key: value.node.values.get(name) for key, name in (("vss_min", "min"), ("vss_max", "max"))}
    return {key: as_number(fraction(limit)) for key, limit in limits.items() if isinstance(limit, int | float)}


def _also_known(item: DataItem, value: Value) -> dict[str, Any]:
    """Fields of a signal and a queue that a parameter does not have."""
    resolution = value.node.values.get("resolution")
    scale = abs(value.conversion.factor) if value.conversion else 1
    return {
        "role": ROLES[item.role],
        "type": value.node.type,
        "external_provider": optional(item.provider),
        "access": item.access,
        "default": value.default,
        "default_elements": value.default_elements,
        "resolution": as_number(fraction(resolution) / scale) if is_finite_number(resolution) else None,
        "timeout": plain_text(item.timeout),
        "timeout_start": item.timeout_start,
        "timeout_value": item.timeout_value,
        "timeout_recovery": item.timeout_recovery,
        "range_error_action": item.range_error_action,
        "is_optional": item.optional or None,
        **_catalogue_range(value),
    }


def _asil(item: DataItem | ParameterItem, value: Value, at: Pointer, context: Context) -> Level | None:
    return item.asil or Attributes(value.node, at, context).asil


def _errors(kind: type[WireModel], item: DataItem | ParameterItem, at: Pointer, context: Context) -> dict[str, Any]:
    """Errors that an interface of a kind names."""
    return {field: error_name(getattr(item, field), (*at, key_of(field)), context) for field in error_fields(kind)}


def _signal(item: DataItem, value: Value, at: Pointer, context: Context) -> Signal:
    return Signal(
        asil_level=_asil(item, value, at, context),
        factor=plain_text(item.factor),
        offset=plain_text(item.offset),
        init_value=value.init,
        units=value.unit,
        **_common(item, value),
        **_also_known(item, value),
        **_errors(Signal, item, at, context),
    )


def _queue(item: DataItem, value: Value, at: Pointer, context: Context) -> DataQueue:
    assert item.queue_length is not None
    return DataQueue(
        asil_level=_asil(item, value, at, context) or "QM",
        queue_length=item.queue_length,
        factor=1 if item.factor is None else item.factor,
        offset=item.offset or 0,
        init_value=value.init or 0,
        units=value.unit or "",
        overflow=item.overflow,
        values_per_step=item.values_per_step,
        count_variable=item.count_variable,
        **_common(item, value),
        **_also_known(item, value),
        **_errors(DataQueue, item, at, context),
    )


# -- parameters ---------------------------------------------------------------------------------------------------


def parameter(item: ParameterItem, at: Pointer, context: Context) -> Part[ParameterInterface]:
    """A parameter; Function JSON requires limits and a start value."""
    value = value_of(item, at, context)
    if value is None:
        return Part(None, Origin(at))
    subject = Subject("data", item.path)
    if value.node.type != "attribute":
        message = f"The parameter {item.path!r} must be an attribute, not {with_article(value.node.type)}."
        fix = "List it under `data`."
        context.report(codes.ROLE_UNFIT_FOR_NODE_TYPE, (*at, "path"), message, fix, subject)
    text = _default_text(value)
    start = value.init if value.default is None else value.default
    has_start = start is not None or text is not None or value.init_elements is not None
    if not has_start:
        fix = "Give `init`, or a default in the catalogue."
        context.report(codes.PARAMETER_WITHOUT_START_VALUE, at, f"{item.path!r} has no default.", fix, subject)
    low, high = _limits(value)
    made = ParameterInterface(
        asil_level=_asil(item, value, at, context) or "QM",
        default=start or 0,
        init_value=value.init or 0,
        range_error_action=item.range_error_action,
        interface_type=item.kind,
        attribute=item.attribute,
        units=value.unit or "",
        default_text=optional(text),
        factor=plain_text(item.factor),
        offset=plain_text(item.offset),
        key=item.key,
        storage=item.storage,
        **{**_common(item, value), "min": low, "max": high},
        **_errors(ParameterInterface, item, at, context),
    )
    missing = () if has_start else (Subject("data", value.node.path, ("default",)),)
    return Part(made, _origin(item, at, "Asillevel"), missing)


def _default_text(value: Value) -> str | None:
    """The catalogue's default of a parameter that is a text; of an array its elements as JSON, in the code's unit."""
    default = value.node.values.get("default")
    if isinstance(default, list) and is_array(str(value.node.values["datatype"])):
        to_code = value.conversion.inverse if value.conversion else IDENTITY
        return json.dumps(converted(default, to_code), ensure_ascii=False)
    is_text = element_of(str(value.node.values["datatype"])) == "string" and symbols_of(value.node) is None
    return default if is_text and isinstance(default, str) else value.default_elements


def _limits(value: Value) -> tuple[float, float]:
    """The wire format requires limits: those of the datatype where the catalogue has none, 0 where there are none."""
    row = BY_REFERENCE.get(value.reference)
    low, high = (value_range(row.vss) if row else None) or (0, 0)
    return (low if value.min is None else value.min), (high if value.max is None else value.max)
