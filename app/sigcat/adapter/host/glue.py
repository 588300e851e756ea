"""A function, bound to its host: a file in its own language that calls its adapter by name."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import GLOBALS, CorePlan, WireStruct, WireType
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.connections import Connections, Entry, Server, answer_struct, request_struct
from sigcat.adapter.host.kept import Kept
from sigcat.adapter.host.numbering import Numbers, bytes_of_largest
from sigcat.adapter.templates import rendered

HOST_HEADER = Path(__file__).with_name("sigcat_host.h")
"""Header of every host, and of the files that bind functions to one."""


class _Kept(NamedTuple):
    """Values that are kept together, by their places."""

    number: int
    """In the messages of the driver."""
    values: Sequence[tuple[str, WireType]]
    flag: str
    """Member that tells whether they are there, if there is one."""
    is_optional: bool
    """Whether they are stored only if they are there."""


class _Answer(NamedTuple):
    """A method that the function uses, and the function of the set that answers it; without one the trace does."""

    name: str
    wire: WireType
    request: WireStruct
    answer: WireStruct
    server: Server | None


class _Served(NamedTuple):
    """A method that the function offers."""

    number: int
    name: str
    request: WireStruct
    answer: WireStruct


def glue_file(connections: Connections, numbers: Numbers, index: int) -> GeneratedFile:
    """The file of one function."""
    member = connections.members[index]
    plan = member.plan
    is_global = plan.code.signature == GLOBALS
    end = numbers.first_call(index) + len(plan.steps)
    servers = {connections.entries[entry].receiver: server for entry, server in connections.servers.items()
               if connections.entries[entry].member == index}  # fmt: skip
    entries = [each for each in connections.entries if each.member == index]
    text = rendered(
        "adapter/host/glue.c.j2",
        header=plan.header_file,
        p=plan.type_name,  # prefix of the names of the adapter
        d=f"{plan.function}_Driver",  # prefix of the names of this file
        instance=f"{plan.type_name}_Instance" if is_global else "state->adapter",
        is_global=is_global,  # whether the adapter has the instance
        is_cpp=plan.code.is_cpp,
        # Whether its bytes are its whole state: not with global variables, and not with objects of C++.
        is_copied=not is_global and not plan.code.is_cpp,
        ok="SIGCAT_OK",
        # Bytes of the largest value that is sent or kept, or handed over with a request.
        largest=bytes_of_largest(connections, numbers),
        structs=dict(_structs(plan)),  # their fields, each by its name
        entries=entries,
        exits=[(number, each) for number, each in enumerate(connections.exits) if each.member == index],
        kept=[_kept(number, each, plan) for number, each in enumerate(numbers.kept) if each.member == index],
        m=Scope(plan).macro,  # prefix of the constants of the adapter
        calls=plan.steps,
        answers=[_answer(each, plan, servers) for each in entries if each.is_answer],
        served=[
            _Served(number, each.named.name, request_struct(each, plan), answer_struct(each, plan))
            for number, each in enumerate(plan.methods)
            if each.is_offered
        ],
        parameters=plan.settable,  # those that are set from outside
        first_call=numbers.first_call(index),
        init=f"{end}U" if plan.inits else "SIGCAT_NONE",
        terminate=f"{end + 1}U" if plan.terminates else "SIGCAT_NONE",
    )
    return GeneratedFile(f"{member.name}_driver.{plan.code.ending}", text.encode())


def _structs(plan: CorePlan) -> Iterator[tuple[str, Sequence[tuple[str, WireType]]]]:
    """Structs of the function, and arguments and results of its methods."""
    handed_over = [struct(each, plan) for each in plan.methods for struct in (request_struct, answer_struct)]
    structs = [*plan.structs, *(each for each in handed_over if each.fields)]
    known = {each.name for each in structs}
    for struct in structs:
        fields = [(each.name, WireType(each.c, each.length, is_struct=each.c in known)) for each in struct.fields]
        yield struct.name, fields


def _answer(entry: Entry, plan: CorePlan, servers: Mapping[str, Server]) -> _Answer:
    method = next(each for each in plan.methods if each.named.name == entry.receiver)
    request, answer = request_struct(method, plan), answer_struct(method, plan)
    return _Answer(entry.receiver, entry.wire, request, answer, servers.get(entry.receiver))


_COUNTS = ("occurrences", "ignition_cycles", "has_failed", "is_tested")
_NUMBER = WireType("")
"""A value whose type in C does not matter: it is moved as it is."""


def _kept(number: int, kept: Kept, plan: CorePlan) -> _Kept:
    if kept.section == "parameters":
        wire = next(each.value.wire for each in plan.parameters if each.named.name == kept.field)
        return _Kept(number, [(f"{kept.field}.value", wire)], f"{kept.field}.is_there", is_optional=True)
    if kept.section == "errors":
        return _Kept(number, [(f"{kept.field}.{each}", _NUMBER) for each in _COUNTS], "", is_optional=False)
    return _Kept(number, [(kept.field, _NUMBER)], "has_cycle", is_optional=False)
