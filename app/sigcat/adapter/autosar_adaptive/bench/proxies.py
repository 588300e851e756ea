"""The proxy of a service: what a consumer uses."""

from sigcat.adapter.autosar_adaptive.bench.common import signature
from sigcat.adapter.autosar_adaptive.bench.elements import about_event, about_field, about_method
from sigcat.adapter.autosar_adaptive.bench.services import Service, connected, members
from sigcat.adapter.autosar_adaptive.bench.text import comment, header, source, within
from sigcat.adapter.autosar_adaptive.cpp_names import member_name
from sigcat.function.document.text import Text
from sigcat.integration.autosar_adaptive.model import Event, Method, ServiceField


def proxy_header(service: Service) -> str:
    """The header that an application includes."""
    whole = service.whole
    events = within(["events"], [_event(event, service) for event in whole.events]) if whole.events else []
    fields = within(["fields"], [_field(field, service) for field in whole.fields]) if whole.fields else []
    methods = within(["methods"], [_method(method, service) for method in whole.methods]) if whole.methods else []
    used = {"proxy_event.h": whole.events, "proxy_field.h": whole.fields, "proxy_method.h": whole.methods}
    bases = [f"bench/{name}" for name, elements in used.items() if elements]
    includes = [service.names.common_header, service.tables_header, "bench/proxy_base.h", *bases]
    body = within((*service.names.namespace, "proxy"), [*events, *fields, *methods, _class(service)])
    return header(service.names.proxy_header, f"Proxy of {whole.name}.", includes, body)


def proxy_source(service: Service) -> str:
    """The constructor, which connects the elements: apart, so that including the header costs little."""
    name = service.names.proxy_class
    parts = [
        *connected(service),
        *(f"{member_name(each.name)}{{connection_, 0x{each.method_id or 0:04X}}}" for each in service.whole.methods),
    ]
    made = "".join(f",\n      {member}" for member in parts)
    body = f"{name}::{name}(const HandleType& handle)\n    : ProxyBase{{handle}}{made} {{}}"
    namespace = (*service.names.namespace, "proxy")
    return source(f"Proxy of {service.whole.name}.", [service.names.proxy_header], within(namespace, [body]))


def _event(event: Event, service: Service) -> str:
    base = f"bench::ProxyEvent<{service.types.type(event.datatype)}>"
    return _element(about_event(event), member_name(event.name), base)


def _field(field: ServiceField, service: Service) -> str:
    base = f"bench::{_field_class(field)}<{service.types.type(field.word)}>"
    return _element(about_field(field), member_name(field.name), base)


def _field_class(field: ServiceField) -> str:
    return "ProxyField" if field.getter_id else "NotifiedProxyField"


def _method(method: Method, service: Service) -> str:
    base = f"bench::ProxyMethod<{signature(method, service)}>"
    output = f"    using Output = {service.result(method)};\n" if method.outputs else ""
    return _element(about_method(method), member_name(method.name), base, output)


def _element(about: Text, name: str, base: str, more: str = "") -> str:
    own = base.removeprefix("bench::").partition("<")[0]
    return f"{comment(about)}\nclass {name} final : public {base} {{\npublic:\n{more}    using {own}::{own};\n}};"


def _class(service: Service) -> str:
    name, whole = service.names.proxy_class, service.whole
    held = members({"events": whole.events, "fields": whole.fields, "methods": whole.methods})
    rows = [
        f"class {name} final : public bench::ProxyBase<{service.tables[-1]}::kService> {{",
        "public:",
        f"    explicit {name}(const HandleType& handle);",
        "",
        f"    static ara::core::Result<{name}> Create(const HandleType& handle) {{",
        f"        return {name}{{handle}};",
        "    }",
        *(["", *held] if held else []),
        "};",
    ]
    return "\n".join(rows)
