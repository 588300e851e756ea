"""Changes of mappings to a network: formulas and values in the new unit of their signal."""

from collections.abc import Iterator
from fractions import Fraction

from yaml.nodes import MappingNode, Node, ScalarNode

from sigcat.catalogue.network.mapping_attributes import KUKSA_TARGET
from sigcat.function.function_json.conversion import Linear, as_text
from sigcat.function.importing.yaml_edits import Edit, entries_of, items_of, text_of, value_at
from sigcat.migration.changed_text import Replacement, end_of, line_of, number_replaced, replaced
from sigcat.migration.numbers import converted_value

_PHYSICAL = {KUKSA_TARGET: "from"}
"""Key of the signal's value in an item of a list of values; `to` and `value` of others."""


def mapping_changes(
    attribute: str, key: ScalarNode, node: Node, conversion: Linear, text: str
) -> Iterator[Replacement]:
    """Yield the changes of a mapping: its formula is converted, or one is added."""
    transform = value_at(node, "transform")
    formula = value_at(transform, "math")
    if isinstance(formula, ScalarNode):
        new = _formula(formula.value, attribute, conversion)
        yield replaced(text, formula, new, f"`math`: {formula.value} → {new}")
    elif isinstance(transform, MappingNode):
        yield from _values(attribute, node, conversion, text)
    elif isinstance(node, MappingNode) and node.value:
        yield _added(attribute, key, node, conversion, text)


def _formula(formula: str, attribute: str, conversion: Linear) -> str:
    """Return a formula in the new unit: of the result, or of `x` where the signal is sent."""
    if attribute != KUKSA_TARGET:
        return _linear(formula.strip(), conversion)
    import re

    inner = _linear("x", conversion.inverse)
    return re.sub(r"(?<![\w.])x(?![\w.(])", f"({inner})", formula)


def _linear(formula: str, conversion: Linear) -> str:
    base = formula if formula.isidentifier() else f"({formula})"
    factor, offset = conversion
    scaled = (
        base
        if factor == 1
        else f"{base} / {as_text(1 / factor)}"
        if _is_inverse(factor)
        else f"{base} * {_term(factor)}"
    )
    return scaled if not offset else f"{scaled} {'-' if offset < 0 else '+'} {_term(abs(offset))}"


def _is_inverse(factor: Fraction) -> bool:
    """Whether a division by a whole number says the same in fewer digits."""
    return factor.numerator == 1 and factor.denominator != 1


def _term(number: Fraction) -> str:
    text = as_text(number)
    return f"({text})" if "/" in text else text


def physical_values(attribute: str, node: Node) -> Iterator[Node]:
    """Yield the values of the signal in the lists of a mapping."""
    for _, items in entries_of(value_at(node, "transform")).values():
        for item in items_of(items):
            value = value_at(item, _PHYSICAL.get(attribute, "to"))
            if value is not None:
                yield value


def _values(attribute: str, node: Node, conversion: Linear, text: str) -> Iterator[Replacement]:
    for value in physical_values(attribute, node):
        number = converted_value(text_of(value) or "", conversion)
        if number is not None:
            yield number_replaced(text, value, number, f"`{attribute}`: {text_of(value)} → {number}")


def _added(attribute: str, key: ScalarNode, node: MappingNode, conversion: Linear, text: str) -> Replacement:
    """Add a formula to a mapping that passes values as they are."""
    formula = _formula("x", attribute, conversion)
    last = node.value[-1][1]
    at = end_of(text, last)
    if node.flow_style:
        added = f', transform: {{math: "{formula}"}}'
    else:
        column = int(node.value[0][0].start_mark.column)
        line_break = "\r\n" if "\r\n" in text else "\n"
        added = f'{line_break}{" " * column}transform: {{math: "{formula}"}}'
    return Replacement(Edit(at, at, added), line_of(key), f"`{attribute}`: formula {formula} added")
