"""Ids, times and ports of a service: what a vendor's platform takes of the manifests at run time."""

from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, METHOD_ERRORS
from sigcat.adapter.autosar_adaptive.bench.method_errors import errors_path
from sigcat.adapter.autosar_adaptive.bench.services import Service, constant
from sigcat.adapter.autosar_adaptive.bench.text import header, source, within
from sigcat.adapter.autosar_adaptive.cpp_names import instance_specifier
from sigcat.function.document.text_filters import c_string, comment
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, ServiceField
from sigcat.integration.autosar_adaptive.processes import Process, processes
from sigcat.integration.autosar_adaptive.someip_settings import ServiceDiscoverySettings, TransformationSettings
from sigcat.integration.autosar_names import short_name


def tables_header(service: Service) -> str:
    """The header that proxy and skeleton include."""
    events = [f"extern const bench::EventDescription {constant(item.name)};" for item in service.elements]
    body = ["extern const bench::ServiceDescription kService;", "\n".join(events)]
    about = f"SOME/IP ids of {service.whole.name}."
    return header(service.tables_header, about, ["bench/description.h"], within(service.tables, body))


def tables_source(service: Service, model: IntegrationModel) -> str:
    """The tables themselves."""
    body = [*_events(service), *_instances(service, model), *_errors(service), _service(service, model)]
    about = f"SOME/IP ids, times and ports of {service.whole.name}, as they stand in the ARXML."
    includes = [service.tables_header, *([errors_path(service.types)] if service.whole.methods else [])]
    return source(about, includes, within(service.tables, body))


def _events(service: Service) -> list[str]:
    groups = {group.name: group.id for group in service.whole.event_groups}
    rows = [
        f"    {{{c_string(event.name)}, {_hex(event.event_id)}, {_hex(groups.get(event.event_group or ''))}, false{_protection(event)}}},"
        for event in service.whole.events
    ]
    rows += [
        f"    {{{c_string(field.name)}, {_hex(field.notifier_id)}, {_hex(groups.get(field.event_group or ''))}, true{_protection(field)}}},"
        for field in service.whole.fields
    ]
    if not rows:
        return []
    about = "// name, id, event group, whether it is the notifier of a field; profile, data id and largest step of the counter"
    table = [about, f"static constexpr bench::EventDescription kEvents[{len(rows)}] = {{", *rows, "};"]
    constants = [
        f"const bench::EventDescription {constant(item.name)} = kEvents[{n}];"
        for n, item in enumerate(service.elements)
    ]
    return ["\n".join(table), "\n".join(constants)]


def _protection(event: Event | ServiceField) -> str:
    """Profile, data id and largest step of the counter."""
    found = event.protection
    return f", {{{found.profile}, {_hex(found.data_id)}, {found.max_delta_counter}}}" if found else ""


def _instances(service: Service, model: IntegrationModel) -> list[str]:
    rows = [
        f"    {{{c_string(instance_specifier(process.component, interface))}, {_hex(interface.instance_id)}{_of(process)}}},"
        for process in processes(model.components)
        for interface in process.services
        if interface.name == service.whole.name
    ]
    rows.append(f"    {{{c_string(player_port(service.whole.name, model))}, {_hex(service.whole.instance_id)}}},")
    head = f"static constexpr bench::InstanceDescription kInstances[{len(rows)}] = {{"
    return ["\n".join(["// port, instance; of which further process of the executable", head, *rows, "};"])]


def _errors(service: Service) -> list[str]:
    """Errors that its methods may return."""
    if not service.whole.methods:
        return []
    domain = "::".join(("", *service.errors, f"Get{DOMAIN}ErrorDomain"))
    table = [f"    {{&{domain}(), {each.code}}}," for each in METHOD_ERRORS]
    head = f"static constexpr bench::ErrorDescription kErrors[{len(table)}] = {{"
    return ["\n".join(["// domain, code", head, *table, "};"])]


def _of(process: Process) -> str:
    return f", {c_string(process.name)}" if process.is_further else ""


def player_port(service: str, model: IntegrationModel) -> str:
    """The port of the player, which offers what no component provides, and uses what one does."""
    roles = {interface.role for part in model.components for interface in part.services if interface.name == service}
    side = "R" if "Provider" in roles else "P"
    return f"Player/Player_Root/{short_name(f'{service}_{side}Port')}"


def _service(service: Service, model: IntegrationModel) -> str:
    assert model.deployment is not None
    chosen = service.whole.transformation or model.deployment.transformation
    events = "kEvents" if service.elements else "{}"
    rows = [
        f"    {c_string(service.whole.name)},",
        f"    {_hex(service.whole.service_id)},",
        f"    {service.whole.version.major},  // major version",
        f"    {service.whole.version.minor},  // minor version",
        f"    {_truth(chosen.session_handling)},  // whether sent events are counted",
        *_serialization(chosen),
        *_times(model.deployment.service_discovery),
        f"    {events},",
        "    kInstances,",
        *(["    kErrors,"] if service.whole.methods else []),
    ]
    return "\n".join(["const bench::ServiceDescription kService = {", *rows, "};"])


def _serialization(chosen: TransformationSettings) -> list[str]:
    return [
        "    {",
        f"        {_truth(chosen.byte_order == 'big-endian')},  // whether big endian",
        f"        {chosen.alignment // 8},  // alignment, in bytes",
        f"        {chosen.array_length},  // bytes of the length of an array",
        f"        {chosen.string_length},  // of a text",
        f"        {chosen.struct_length},  // of a struct",
        f"        {_truth(chosen.string_encoding == 'UTF-16')},  // whether texts are UTF-16",
        "    },",
    ]


def _times(chosen: ServiceDiscoverySettings) -> list[str]:
    rows = [
        (chosen.initial_delay_min, "initial delay, at least, in ms"),
        (chosen.initial_delay_max, "initial delay, at most, in ms"),
        (chosen.repetitions_max, "repetitions"),
        (chosen.repetitions_base_delay, "delay of the first repetition, in ms"),
        (chosen.offer_cyclic_delay, "from one offer to the next, in ms"),
        (chosen.offer_time_to_live, "an offer holds, in s"),
        (chosen.find_time_to_live, "a search holds, in s"),
        (chosen.subscribe_time_to_live, "a subscription holds, in s"),
        (chosen.response_delay_min, "delay of an answer, at least, in ms"),
        (chosen.response_delay_max, "delay of an answer, at most, in ms"),
    ]
    return ["    {", *(f"        {value:g},  // {comment(about)}" for value, about in rows), "    },"]


def _hex(number: int | None) -> str:
    return f"0x{number or 0:04X}"


def _truth(value: object) -> str:
    return "true" if value else "false"
