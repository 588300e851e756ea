"""A function to be driven twice: as its adapter in Python, and as its generated core. What of it can be given and seen."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.numbers import DOUBLE, NumberType
from sigcat.adapter.core.plan import CLASS, NANOSECONDS, Clock, CorePlan, WireType
from sigcat.adapter.core.plan import Argument as PlannedArgument
from sigcat.adapter.core.planned_core import derive
from sigcat.function.function_json import walk
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.model import FunctionJson
from tests.adapter.reference.function import Function
from tests.adapter.reference.parts.methods import Argument
from tests.adapter.reference.reading.data import port_key
from tests.adapter.reference.reading.read import read
from tests.adapter.reference.reading.shape import shape_of
from tests.adapter.reference.values.number_format import NumberFormat
from tests.adapter.reference.values.transfer import Transfer
from tests.adapter.written import enumeration
from tests.function.shipped import resolved

C_NAMES = {
    "boolean": "bool", "uint8": "uint8_t", "int8": "int8_t", "uint16": "uint16_t", "int16": "int16_t",
    "uint32": "uint32_t", "int32": "int32_t", "uint64": "uint64_t", "int64": "int64_t", "float": "float",
    "double": "double",
}  # fmt: skip
STATUS8, STATUS32 = "DT_Status8", "DT_Status32"
"""Datatypes of variables that hold states and modes: enumerations, where the code has types for them."""
COUNT, FLAG = "DT_OwnCount", "DT_OwnFlag"
"""Datatypes of variables that count values, and of those that request."""
OWN_TYPES = (
    *(
        Datatype.model_validate(enumeration(name, c, NONE=0))
        for name, c in ((STATUS8, "uint8_t"), (STATUS32, "int32_t"))
    ),
    *(
        Datatype(reference=name, category="primitive", c_definition=c)
        for name, c in ((COUNT, "uint32_t"), (FLAG, "bool"))
    ),
)
_AGREED = {each.reference for each in OWN_TYPES}
VSS_NAMES = {c: vss for vss, c in C_NAMES.items()}
DECLARED = {
    c: Datatype(reference=f"DT_Declared{vss}", category="primitive", c_definition=c) for c, vss in VSS_NAMES.items()
}
"""Datatypes of variables that the core declares, by their types in C: it agrees with the code on those of states and modes."""


@dataclass(frozen=True)
class Leaf:
    """A number within a value: where it is in C, and its format."""

    place: str
    format: NumberFormat


@dataclass(frozen=True)
class Item:
    """A value that is given or seen."""

    name: str
    """In the model."""
    c: str
    """In C: a variable, or the last part of a name."""
    leaves: tuple[Leaf, ...]
    declared: str = ""
    """Declaration in C, of `value` or of the variable."""
    is_single: bool = True
    transfer: Transfer | None = None
    length: int = 0
    """Largest number of values sent, for a queue."""


@dataclass(frozen=True)
class Method:
    """A method, with its arguments and results."""

    name: str
    c: str
    arguments: tuple[Item, ...]
    results: tuple[Item, ...]
    symbol: str


@dataclass(frozen=True)
class Subject:
    """A function and all that can be given to it and seen of it."""

    document: FunctionJson
    function: Function
    plan: CorePlan
    structs: tuple[str, ...]
    """Their definitions in C."""
    variables: tuple[Item, ...]
    ports: tuple[Item, ...]
    outs: tuple[Item, ...]
    parameters: tuple[Item, ...]
    offered: tuple[Method, ...]
    used: tuple[Method, ...]

    @property
    def signature(self) -> str:
        """Access of calls to their data: Globals, Pointers or Class."""
        return self.plan.code.signature

    def place(self, item: Item) -> str:
        """Expression for a variable, in the driver."""
        return Scope(self.plan).variable(item.c)

    @property
    def headers(self) -> tuple[str, ...]:
        """Names of the headers that declare the code."""
        code = self.document.code
        return tuple(code.headers or ()) if code else ()

    @property
    def own_variables(self) -> tuple[Item, ...]:
        """Variables that the code defines."""
        others = {each.name for each in self.plan.code.externs if each.is_defined_here}
        return tuple(each for each in self.variables if each.name not in others)

    @property
    def calls(self) -> tuple[tuple[str, str], ...]:
        """Names of the steps, in the model and in C."""
        return tuple((step.interface, step.name) for step in self.plan.steps)

    @property
    def errors(self) -> tuple[tuple[str, str], ...]:
        """Names of the errors, in the model and in C."""
        return tuple((error.named.comment, error.named.name) for error in self.plan.errors)

    @property
    def symbols(self) -> tuple[str, ...]:
        """C functions that the code has to have."""
        calls = [call.symbol for call in self.function.calls]
        return tuple(dict.fromkeys([*calls, *(method.symbol for method in self.offered)]))

    @property
    def hooks(self) -> tuple[str, ...]:
        """C functions of the project, which run before and after calls."""
        return tuple(dict.fromkeys(name for call in self.function.calls for name in (*call.before, *call.after)))

    @property
    def settable(self) -> tuple[str, ...]:
        """Parameters that can be set while the function runs."""
        return tuple(each.name for each in self.function.parameters if not each.is_learned)


def _own(reference: str) -> str:
    """Name of a type of the code: platforms have types of the datatype's name."""
    return f"Own_{reference}"


# -- from a document ----------------------------------------------------------------------------------------------


class _Reading:
    """A document, with what its adapters in Python and in C make of it."""

    def __init__(self, document: FunctionJson, arithmetic: NumberType, clock: Clock) -> None:
        self.function = read(document)
        self.plan = derive(resolved(document), arithmetic).plan._replace(clock=clock)
        self.table = {each.reference: each for each in (*document.datatypes, *OWN_TYPES, *DECLARED.values())}
        self.externs = {each.name: each for each in self.plan.code.externs}
        self.document = document
        self.has_enumerations = self.plan.code.signature == CLASS
        """Whether the code has types for enumerations, as C++ does: scoped ones, which no number turns into by itself."""
        self.data = [item for _, _, item in walk.data(document)]
        self.parameters = [item for _, _, item in walk.parameters(document)]
        self.methods = [item for _, _, item in walk.methods(document)]

    def places(self, reference: str) -> list[str]:
        """Accesses to the numbers of a datatype, after the name of a value: `[0].x`."""
        paths = [leaf.path for leaf in shape_of(reference, self.table).leaves]
        return ["".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in path) for path in paths]

    def declared(self, reference: str, name: str) -> str:
        """Declaration of a variable of a datatype: `DT_Point name[2]`."""
        datatype = self.table[reference]
        if datatype.kind == "array":
            return self.declared(datatype.element or "", f"{name}[{datatype.length}]")
        is_named = datatype.kind == "struct" or (self.has_enumerations and datatype.symbols)
        return f"{_own(reference) if is_named else datatype.c_definition} {name}"

    @property
    def structs(self) -> tuple[str, ...]:
        """Definitions of the structs of the code; members of a struct are defined before it."""
        enumerations = tuple(
            f"enum class {_own(name)} : {each.c_definition} {{}};"
            for name, each in self.table.items()
            if self.has_enumerations and each.symbols
        )
        return enumerations + tuple(
            f"typedef struct {{ {' '.join(f'{self.declared(f.datatype, f.name)};' for f in each.fields or ())} }} {_own(name)};"
            for name, each in self.table.items()
            if each.kind == "struct"
        )

    def wire(self, name: str, c: str, wire: WireType, transfer: Transfer, reference: str, *, is_source: bool) -> Item:
        """A value as it is received or sent."""
        formats = [each.source if is_source else each.target for each in transfer.elements]
        leaves = tuple(Leaf(place, each) for place, each in zip(self.places(reference), formats, strict=True))
        declared = f"{wire.c} value" + (f"[{wire.length}]" if wire.length is not None else "")
        return Item(name, c, leaves, declared, transfer.is_single, transfer)


def subject(document: FunctionJson, arithmetic: NumberType = DOUBLE, clock: Clock = NANOSECONDS) -> Subject:
    """Inputs and observable values of a function."""
    reading = _Reading(document, arithmetic, clock)
    return Subject(
        document,
        reading.function,
        reading.plan,
        structs=reading.structs,
        variables=_variables(reading),
        ports=_ports(reading),
        outs=_outs(reading),
        parameters=_parameters(reading),
        offered=tuple(_methods(reading, is_offered=True)),
        used=tuple(_methods(reading, is_offered=False)),
    )


def _variables(reading: _Reading) -> tuple[Item, ...]:
    """Variables of the code."""
    found: dict[str, Item] = {}
    for variable, reference, count in _named_variables(reading):
        if variable is not None and variable not in found:
            found[variable] = _variable(reading, variable, reference, count)
    return tuple(found.values())


def _variable(reading: _Reading, variable: str, reference: str, count: int) -> Item:
    extern = reading.externs.get(variable)
    if extern and extern.c in DECLARED and reference in _AGREED:
        reference = DECLARED[extern.c].reference
    own = reading.places(reference)
    places = [f"[{index}]{place}" for index in range(count) for place in own] if count else own
    formats = [leaf.format for leaf in shape_of(reference, reading.table).leaves] * (count or 1)
    leaves = tuple(Leaf(place, each) for place, each in zip(places, formats, strict=True))
    name = variable.rpartition(".")[2]
    declared = reading.declared(reference, f"{name}[{count}]" if count else name)
    return Item(variable, variable, leaves, declared, is_single=places == [""])


def _named_variables(reading: _Reading) -> Iterator[tuple[str | None, str, int]]:
    """Expressions, datatypes, and the number of values that they have room for; 0 if they are not arrays."""
    for item in (*reading.data, *(item for _, _, item in walk.absent(reading.document))):
        yield item.variable, item.datatype, _places(item)
        if isinstance(item, DataQueue):
            yield item.count_variable, COUNT, 0
    yield from ((item.variable, item.datatype, 0) for item in reading.parameters)
    for _, _, error in walk.errors(reading.document):
        yield error.variable, STATUS32, 0
        yield error.status_variable, STATUS8, 0
    yield from ((each.variable, STATUS8, 0) for _, _, each in walk.safety_reactions(reading.document))
    for method in reading.methods:
        yield method.request_variable, FLAG, 0
        yield method.status_variable, STATUS8, 0
        yield from ((each.variable, each.datatype, 0) for each in (*method.inputs, *method.outputs))
    yield from ((mode.variable, STATUS32, 0) for mode in reading.document.mode_interfaces or ())


def _places(item: Signal | DataQueue) -> int:
    if not isinstance(item, DataQueue):
        return 0
    if item.role == PROVIDER:
        return item.queue_length if item.count_variable is not None else 0
    return item.values_per_step if item.values_per_step and item.values_per_step > 1 else 0


# -- what is received and sent ------------------------------------------------------------------------------------


def _ports(reading: _Reading) -> tuple[Item, ...]:
    """Received values."""
    function, plan = reading.function, reading.plan
    transfers = {each.port: each.transfer for call in function.calls for each in call.inputs}
    references = {port_key(item): item.datatype for item in reversed(reading.data) if item.role == CONSUMER}
    found = [
        reading.wire(name, port.name, port.wire, transfers[name], references[key], is_source=True)
        for (key, name), port in zip(function.ports.items(), plan.ports, strict=True)
    ]
    others = [(error.name, error.name, error.wire) for error in plan.foreign_errors]
    others += [(each.named.comment, each.named.name, each.wire) for each in plan.reactions]
    others += [(each.named.comment, each.named.name, each.wire) for each in (plan.mode_in,) if each]
    return (*found, *(_status(*each) for each in others))


def _provided(reading: _Reading) -> list[str]:
    """Datatypes of the outputs of steps, in the order of the file."""
    steps = {step.name for step in reading.function.steps}
    return [
        item.datatype
        for _, located, item in walk.data(reading.document)
        if item.role == PROVIDER and located.runnable.name in steps
    ]


def _status(name: str, c: str, wire: WireType) -> Item:
    return Item(name, c, (Leaf("", NumberFormat(VSS_NAMES[wire.c])),), f"{wire.c} value")


def _outs(reading: _Reading) -> tuple[Item, ...]:
    """Sent values."""
    function, plan = reading.function, reading.plan
    pairs = [
        (output, planned)
        for step, planned_step in zip(function.steps, plan.steps, strict=True)
        for output, planned in zip(step.outputs, planned_step.outputs, strict=True)
    ]
    found = [
        replace(
            reading.wire(each.name, c.named.name, c.value.wire, each.transfer, reference, is_source=False),
            length=each.queue.length if each.queue else 0,
        )
        for (each, c), reference in zip(pairs, _provided(reading), strict=True)
    ]
    others = [(each.named.comment, each.named.name, each.wire) for each in plan.errors]
    others += [(each.named.comment, each.named.name, each.wire) for each in plan.reactions]
    others += [(each.named.comment, each.named.name, each.wire) for each in (plan.mode_out,) if each]
    return (*found, *(_status(*each) for each in others))


def _parameters(reading: _Reading) -> tuple[Item, ...]:
    """Parameters, as they are stored and set."""
    references = {item.name: item.datatype for item in reading.parameters}
    return tuple(
        reading.wire(each.name, c.named.name, c.value.wire, each.incoming, references[each.name], is_source=True)
        for each, c in zip(reading.function.parameters, reading.plan.parameters, strict=True)
    )


def _methods(reading: _Reading, *, is_offered: bool) -> Iterator[Method]:
    planned = {each.named.comment: each for each in reading.plan.methods}
    for each in reading.function.methods:
        if each.is_offered == is_offered:
            c = planned[each.name]
            arguments = _arguments(reading, each.name, each.inputs, c.arguments)
            results = _arguments(reading, each.name, each.outputs, c.results)
            yield Method(each.name, c.named.name, arguments, results, each.symbol or each.name)


def _arguments(
    reading: _Reading, method: str, own: Iterable[Argument], planned: Iterable[PlannedArgument]
) -> tuple[Item, ...]:
    items = [item for each in reading.methods if each.name == method for item in (*each.inputs, *each.outputs)]
    references = {item.name: item.datatype for item in items}
    return tuple(
        reading.wire(each.name, c.name, c.value.wire, each.transfer, references[each.name], is_source=True)
        for each, c in zip(own, planned, strict=True)
    )
