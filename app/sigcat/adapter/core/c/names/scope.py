"""Names in a core: prefixes of functions and constants, and the variables of the code as functions of the adapter reach them."""

import re
from typing import NamedTuple

from sigcat.adapter.core.plan import GLOBALS, CorePlan
from sigcat.adapter.core.variables import with_variables
from sigcat.names import screaming_snake_case

MARK = "\x02"
"""Stands before each name of the code, until variables of the adapter with such a name are renamed."""
NAME = re.compile(r"(?<![\w.>])[A-Za-z_]\w*")
"""A name in an expression that is not one of a member."""


class Scope(NamedTuple):
    """The plan of a core, on its way to C."""

    plan: CorePlan

    @property
    def prefix(self) -> str:
        """Prefix of all functions and types: `CoreAcc_Adapter`."""
        return self.plan.type_name

    @property
    def macro(self) -> str:
        """Prefix of all constants and macros: `CORE_ACC_ADAPTER`."""
        return screaming_snake_case(self.prefix)

    @property
    def is_cpp(self) -> bool:
        """Whether the core is C++, where an enumeration is not a number."""
        return self.plan.code.is_cpp

    @property
    def put(self) -> str:
        """Function that puts a number into a variable that may be an enumeration; empty where `=` does."""
        return "Sigcat_Put" if self.is_cpp else ""

    def constant(self, name: str) -> str:
        """A constant of the adapter: `PRESENT` → `CORE_ACC_ADAPTER_PRESENT`."""
        return f"{self.macro}_{name}"

    def call(self, name: str) -> str:
        """The constant of a call: `Step` → `CORE_ACC_ADAPTER_CALL_STEP`."""
        return self.constant(f"CALL_{screaming_snake_case(name)}")

    def variable(self, expression: str) -> str:
        """Expression of a variable of the code in a function of the adapter."""
        code = self.plan.code
        names = "|".join(re.escape(each.name) for each in code.objects)
        if code.signature == GLOBALS:
            return expression
        if names:
            expression, count = re.subn(rf"(?<![\w.>])({names})\b", r"self->code.\1", expression)
            if count:
                return expression
        return f"self->object.{expression}" if code.is_cpp else expression


def in_adapter(plan: CorePlan) -> Scope:
    """A plan whose variables are expressions in functions of the adapter; the global ones are marked."""
    inside = _marked if plan.code.signature == GLOBALS else Scope(plan).variable
    return Scope(with_variables(plan, lambda expression: inside(_as_operand(expression))))


def _as_operand(expression: str) -> str:
    """The expression as one that an index or a member may follow: `*v[i]` is not an element of `*v`."""
    return f"({expression})" if expression.startswith(("*", "&", "(")) and not _is_grouped(expression) else expression


def _is_grouped(expression: str) -> bool:
    """Whether parentheses are around the whole of it."""
    depth = 0
    for place, sign in enumerate(expression):
        depth += (sign == "(") - (sign == ")")
        if depth == 0:
            return place == len(expression) - 1
    return False


def _marked(expression: str) -> str:
    return NAME.sub(rf"{MARK}\g<0>", expression)
