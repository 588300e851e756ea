"""Parameters of nodes, in the unit of the catalogue, so that one file of parameters serves every function."""

from collections.abc import Mapping
from math import isfinite
from typing import Any

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.document.text import Text, json_of, optional
from sigcat.function.exchange import Part, contracts_of
from sigcat.function.function_json.conversion import Linear
from sigcat.function.function_json.datatypes.primitive_types import value_range
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.conversions import conversion, converted, physical, to_catalogue
from sigcat.integration.ros2.messages.field_types import FieldType, c_definition, field_type, sent, symbols_of
from sigcat.integration.ros2.messages.made_messages import unresolved
from sigcat.integration.ros2.model import RosParameter
from sigcat.integration.ros2.names import field_name, package_name, report_renamed

_LARGEST = 2**63 - 1
"""Largest integer of a parameter."""
OWN = frozenset(("lock_step", "scheduling_policy", "start_type_description_service", "storage_folder", "use_sim_time"))
"""Parameters that a node has whatever its function is."""
_LONGEST = 10_000
"""Most elements of a default that is written."""


def parameters_of(part: Part, context: Context) -> tuple[RosParameter, ...]:
    """The parameters of a component's calls, each once."""
    made: dict[str, RosParameter] = {}
    for parameter in (each for contract in contracts_of(part) for each in contract.parameters or ()):
        if parameter.name not in {known.parameter for known in made.values()}:
            resolved = _parameter(parameter, part, set(made), context)
            if resolved is not None:
                made[resolved.name] = resolved
    return tuple(made.values())


def _parameter(item: ParameterInterface, part: Part, taken: set[str], context: Context) -> RosParameter | None:
    table, findings = context.book.table, context.findings
    interface = Subject(item.vss_path or f"{part.function_name}.{item.name}", item)
    kind = field_type(item.datatype, item.vss_datatype, table)
    if kind is None:
        unresolved(findings, interface, item.datatype)
        return None
    if kind.element is None:
        message = f"{interface}: a node parameter must not be a struct. It is left out."
        findings.report(codes.NOT_A_NODE_PARAMETER, message, interface, "Declare a parameter for each member.")
        return None
    kind = sent(kind, item.vss_symbols)
    _unexpressed(item, kind, interface, findings)
    name = field_name(item.name, taken | OWN)
    report_renamed(name, item.name, interface, findings)
    return _resolved(item, kind, name.text, interface, part, context)


def _resolved(
    item: ParameterInterface, kind: FieldType, name: str, interface: Subject, part: Part, context: Context
) -> RosParameter:
    table, findings = context.book.table, context.findings
    way = physical(item, interface, findings)  # from the unit of the code, which the document's values have
    stored = to_catalogue(item, interface, findings)  # from the number in the code
    limits = _limits(item, kind, way)
    low, high = (None, None) if kind.suffix else limits
    names: dict[float, str] = {each.value: each.symbol for each in symbols_of(item.datatype, table)}
    api = package_name(f"{part.function_name}_{item.name}_from_parameter").text
    return RosParameter(
        name=name,
        parameter=item.name,
        type=_type(kind),
        description=item.description,
        default=_default(item, kind, way, names),
        low=low,
        high=high,
        constraints=optional(_constraints(kind, limits)),
        read_only=item.interface_type == "Measurement" or item.attribute == "LearningParameter",
        units=item.vss_unit or item.units or None,
        variable=item.variable or item.name,
        variable_type=c_definition(item.datatype, table),
        variable_units=item.units or None,
        conversion=conversion(api, name, item.datatype, kind, stored, table, _type(kind), is_outgoing=False),
        storage=item.interface_type,
        attribute=item.attribute,
        range_error_action=item.range_error_action,
        vss_path=item.vss_path,
    )


def _type(kind: FieldType) -> str:
    assert kind.element is not None
    vss = kind.element.vss
    name = {"boolean": "bool", "string": "string"}.get(vss) or ("integer" if vss in INTEGER_RANGES else "double")
    return f"{name}_array" if kind.suffix else name


def _limits(item: ParameterInterface, kind: FieldType, linear: Linear) -> tuple[float | None, float | None]:
    """The range, where it says more than the datatype of the parameter does: that of a byte is an integer of 64 bits."""
    assert kind.element is not None
    full = value_range(kind.element.vss)
    if full is None or kind.element.vss == "boolean":
        return None, None
    given = () if item.min == item.max else (converted(item.min, linear), converted(item.max, linear))
    ends = sorted(value for value in given if value is not None) or list(full)
    widest = INTEGER_RANGES["int64"] if kind.element.vss in INTEGER_RANGES else full
    low, high = max(ends[0], full[0]), min(ends[-1], full[1])
    return (low if low > widest[0] else None), (high if high < widest[1] else None)


def _default(item: ParameterInterface, kind: FieldType, linear: Linear, names: Mapping[float, str]) -> Any:
    """The start value. `names` are those of the numbers that an enumeration has in the code."""
    if not kind.suffix:
        given = item.default_text if kind.is_text and not kind.symbols else item.init_value
        return _one_default(given, kind, linear, names)
    elements = json_of(item.init_elements or item.default_elements)
    if not isinstance(elements, list):
        elements = [item.init_value] * min(int(kind.suffix[1:-1] or 0), _LONGEST)
    return [_one_default(each, kind, linear, names) for each in elements[:_LONGEST]]


def _one_default(given: Any, kind: FieldType, linear: Linear, names: Mapping[float, str]) -> Any:
    assert kind.element is not None
    if kind.symbols and isinstance(given, str | int | float):
        numbers = {symbol.symbol: symbol.value for symbol in kind.symbols}
        name = names.get(given, "") if isinstance(given, int | float) else given
        return (name if name in numbers else "") if kind.is_text else numbers.get(name, given)
    if kind.is_text:
        return given if isinstance(given, str | Text) else ""
    number = given if isinstance(given, int | float) and isfinite(given) else 0
    if kind.element.vss == "boolean":
        return bool(number)
    value = converted(number, linear) or 0
    return round(value) if kind.element.vss in INTEGER_RANGES else float(value)


def _constraints(kind: FieldType, limits: tuple[float | None, float | None]) -> str | None:
    """Return constraints that no range expresses: texts and numbers of an enumeration, and ranges of elements."""
    if not kind.symbols:
        return _of_elements(*limits) if kind.suffix else None
    if kind.is_text:
        return "one of " + ", ".join(symbol.symbol for symbol in kind.symbols)
    return "one of " + ", ".join(f"{symbol.value} ({symbol.symbol})" for symbol in kind.symbols)


def _of_elements(low: float | None, high: float | None) -> str | None:
    ends = (("from", low), ("to", high))
    words = [f"{word} {int(end) if end == int(end) else end}" for word, end in ends if end is not None]
    return " ".join(("each element", *words)) if words else None


def _unexpressed(item: ParameterInterface, kind: FieldType, interface: Subject, findings: FindingCollector) -> None:
    if item.interface_type == "Measurement":
        message = f"{interface} is a measurement; as a node parameter it can be read, but sends no updates."
        findings.report(codes.NOT_A_NODE_PARAMETER, message, interface, "Provide it as a signal.")
    if kind.element is not None and kind.element.vss == "uint64" and item.max > _LARGEST:
        message = f"{interface}: `max` must be at most {_LARGEST} in a node parameter, not {item.max}."
        findings.report(codes.NOT_A_NODE_PARAMETER, message, interface, "Narrow the range with `max`.", key="Max")
