"""Nothing in: frozen values out, which say what the core of an adapter has to do.

Every name, number and conversion is resolved. The writer of C asks nothing but this.
"""

from sigcat.adapter.core.plan.call import Alive, Call, Deadline, Logical
from sigcat.adapter.core.plan.clock import LONGEST, MICROSECONDS, MILLISECONDS, NANOSECONDS, Clock
from sigcat.adapter.core.plan.core_plan import Code, CodeObject, CorePlan, Extern, Provenance
from sigcat.adapter.core.plan.interface import (
    CONDITIONS,
    Argument,
    Input,
    Method,
    Named,
    Output,
    Parameter,
    Port,
    Queue,
    TimeOut,
)
from sigcat.adapter.core.plan.status import Cause, Error, ForeignError, ModeIn, ModeOut, ModeValue, Reaction
from sigcat.adapter.core.plan.value import Element, Leaf, Value, WireField, WireStruct, WireType
from sigcat.function.function_json.code import CLASS, GLOBALS, POINTERS

__all__ = [
    "CLASS",
    "CONDITIONS",
    "GLOBALS",
    "LONGEST",
    "MICROSECONDS",
    "MILLISECONDS",
    "NANOSECONDS",
    "POINTERS",
    "Alive",
    "Argument",
    "Call",
    "Cause",
    "Clock",
    "Code",
    "CodeObject",
    "CorePlan",
    "Deadline",
    "Element",
    "Error",
    "Extern",
    "ForeignError",
    "Input",
    "Leaf",
    "Logical",
    "Method",
    "ModeIn",
    "ModeOut",
    "ModeValue",
    "Named",
    "Output",
    "Parameter",
    "Port",
    "Provenance",
    "Queue",
    "Reaction",
    "TimeOut",
    "Value",
    "WireField",
    "WireStruct",
    "WireType",
]
