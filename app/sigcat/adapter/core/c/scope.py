"""Common knowledge of every part of the source: the plan, prefixes of names, and the variables of the code."""

import re
from typing import NamedTuple

from sigcat.adapter.core.plan import GLOBALS, CorePlan
from sigcat.names import screaming_snake_case

MARK = "\x02"
"""Stands before a name of the code that functions of the adapter have for something else, until that is renamed."""


class Scope(NamedTuple):
    """The plan of a core, on its way to C."""

    plan: CorePlan
    shadowed: frozenset[str] = frozenset()
    """Such names."""

    @property
    def prefix(self) -> str:
        """Prefix of all functions and types: `CoreAcc_Adapter`."""
        return self.plan.type_name

    @property
    def macro(self) -> str:
        """Prefix of all constants and macros: `CORE_ACC_ADAPTER`."""
        return screaming_snake_case(self.prefix)

    @property
    def self_argument(self) -> str:
        """The argument that all functions have."""
        return f"{self.prefix} *self"

    def variable(self, expression: str) -> str:
        """Expression of a variable of the code in a function of the adapter."""
        code = self.plan.code
        if code.signature == GLOBALS:
            return self._marked(expression)
        names = "|".join(re.escape(each.name) for each in code.objects)
        if names:
            expression, count = re.subn(rf"(?<![\w.>])({names})\b", r"self->code.\1", expression)
            if count:
                return expression
        return f"self->object.{expression}" if code.is_cpp else expression

    def _marked(self, expression: str) -> str:
        if not self.shadowed:
            return expression
        return re.sub(rf"(?<![\w.>])({'|'.join(sorted(self.shadowed))})\b", rf"{MARK}\1", expression)

    @property
    def is_cpp(self) -> bool:
        """Whether the core is C++, where an enumeration is not a number."""
        return self.plan.code.is_cpp

    @property
    def put(self) -> str:
        """Function that puts a number into a variable that may be an enumeration; empty where `=` does."""
        return f"{self.prefix}_Put" if self.is_cpp else ""

    def assigned(self, expression: str, number: str) -> str:
        """A number assigned to a variable of the code that may be an enumeration."""
        target = self.variable(expression)
        return f"{self.put}({target}, {number});" if self.is_cpp else f"{target} = {number};"

    def is_set(self, expression: str) -> str:
        """The condition that a variable of the code is not 0."""
        variable = self.variable(expression)
        return f"{self.prefix}_IsSet({variable})" if self.is_cpp else f"({variable} != 0)"

    def constant(self, name: str) -> str:
        """A constant of the adapter: `PRESENT` → `CORE_ACC_ADAPTER_PRESENT`."""
        return f"{self.macro}_{name}"

    @property
    def present(self) -> str:
        """The verdict that a cause is present."""
        return self.constant("PRESENT")

    @property
    def absent(self) -> str:
        """The verdict that a cause is absent."""
        return self.constant("ABSENT")

    def call(self, name: str) -> str:
        """The constant of a call: `Step` → `CORE_ACC_ADAPTER_STEP`."""
        return self.constant(f"CALL_{screaming_snake_case(name)}")
