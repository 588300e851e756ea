"""The player: what the functions receive from outside is sent by it, what they send comes to it."""

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.names import cpp_type
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole, wholes
from sigcat.adapter.autosar_adaptive.bench.services.tables import player_port
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, member_name, service_names, type_names
from sigcat.adapter.templates import rendered
from sigcat.integration.autosar_adaptive.model import IntegrationModel, Method, ServiceField, TypeEntry

CPP = Path(__file__).parent / "cpp"
"""Files that are the same in every player."""
_TEMPLATE = "adapter/autosar_adaptive/application/player/ports.cpp.j2"


class _Element(NamedTuple):
    """An event or a field, under the name that it has in traces."""

    name: str
    member: str
    type: str
    initial: str = ""
    """Value of a field before the trace has one; an event has none."""
    is_repeated: bool = False
    """Whether it is a state that is sent again and again."""


class _Method(NamedTuple):
    """A method that the player answers with zeros."""

    member: str
    arguments: str
    output: str
    value: str


class _Port(NamedTuple):
    """A service that the player offers or uses."""

    service: str
    names: ServiceNames
    path: str
    elements: Sequence[_Element]
    methods: Sequence[_Method]
    key: str
    """Its ids, for the runtime."""
    listeners: int
    """Processes that subscribe to it."""

    @property
    def variable(self) -> str:
        """Like no keyword, and not like the logger beside it."""
        return f"{self.names.variable}_"

    @property
    def type(self) -> str:
        return f"Answering{self.names.stem}" if self.methods else f"::{self.names.skeleton}"


class _Struct(NamedTuple):
    """A struct, with its members, and the text before the value of each in a trace."""

    type: str
    members: Sequence[str]
    keys: Sequence[str]


def ports_source(model: IntegrationModel) -> str:
    """The source of its services."""
    types = type_names(model)
    provided = {each.name for part in model.components for each in part.services if each.role == "Provider"}
    services = [_port(whole, model, types) for whole in wholes(model)]
    offered = [port for port in services if port.service not in provided]
    used = [port for port in services if port.service in provided]
    entries = list(model.datatypes or ())
    return rendered(
        _TEMPLATE,
        headers=_headers(offered, used, entries, types),
        enumerations={cpp_type(types.type(each.name)): each.symbols for each in entries if each.symbols},
        structs=[_struct(each, types) for each in entries if each.kind == "structure"],
        offered=offered,
        used=used,
        records=any(port.elements for port in used),
        components=[component.name for component in model.components],
    )


def _port(whole: Whole, model: IntegrationModel, types: TypeNames) -> _Port:
    events = [
        _Element(each.vss_path or each.name, member_name(each.name), cpp_type(types.type(each.datatype)))
        for each in whole.events
    ]
    fields = [_field(each, model, types) for each in whole.fields]
    methods = [_method(each, types) for each in whole.methods]
    listeners = {
        part.executable
        for part in model.components
        for each in part.services
        if (each.name, each.role) == (whole.name, "Consumer")
        and any(used.events or used.fields for used in each.services)
    }
    key = f"{whole.interface.service_id:#06x}, {whole.interface.instance_id:#06x}"
    path = player_port(whole.name, model)
    return _Port(whole.name, service_names(whole, model), path, [*events, *fields], methods, key, len(listeners))


def _method(method: Method, types: TypeNames) -> _Method:
    member = member_name(method.name)
    arguments = ", ".join(f"const {cpp_type(types.type(each.datatype))}&" for each in method.inputs or ())
    output = f"{member}Output" if method.outputs else "void"
    return _Method(member, arguments, output, f"{output}{{}}" if method.outputs else "")


def _field(field: ServiceField, model: IntegrationModel, types: TypeNames) -> _Element:
    type_ = cpp_type(types.type(field.word))
    initial = _initial(field, model, type_)
    return _Element(field.name, member_name(field.name), type_, initial, field.protection is not None)


def _initial(field: ServiceField, model: IntegrationModel, type_: str) -> str:
    """Start value of the function, so that it behaves as if no application sends the field."""
    entries = (entry for entry in model.datatypes or () if entry.name == field.word)
    symbols = (each.symbol for entry in entries for each in entry.symbols or ())
    found = next((symbol for symbol in symbols if symbol.upper() == _beginning(field).upper()), None)
    return f"{type_}::{found}" if found else f"{type_}{{}}"


def _beginning(field: ServiceField) -> str:
    if field.mode is not None:
        return field.mode.initial or next(iter(field.mode.modes or ()), "")
    if field.safety_reaction is not None:
        return field.safety_reaction.initial or "INACTIVE"
    return "PASSED"


def _headers(
    offered: Iterable[_Port], used: Iterable[_Port], entries: Iterable[TypeEntry], types: TypeNames
) -> Sequence[str]:
    headers = [port.names.skeleton_header for port in offered] + [port.names.proxy_header for port in used]
    headers += types.headers(entry.name for entry in entries)
    headers += ["application/required_service.h", "ara/core/instance_specifier.h", "player/hear.h"]
    headers += ["bench/counters.h"] if any(port.listeners for port in offered) else []
    headers += ["ara/core/promise.h"] if any(port.methods for port in offered) else []
    return sorted(set(headers))


def _struct(entry: TypeEntry, types: TypeNames) -> _Struct:
    names = [field.name for field in entry.fields or ()]
    keys = [f"{',' if number else ''}{json.dumps(name)}:" for number, name in enumerate(names)]
    return _Struct(cpp_type(types.type(entry.name)), names, keys)
