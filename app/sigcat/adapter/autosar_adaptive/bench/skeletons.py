"""The skeleton of a service: what its provider fills."""

from sigcat.adapter.autosar_adaptive.bench.common import arguments
from sigcat.adapter.autosar_adaptive.bench.elements import about_event, about_field, about_method
from sigcat.adapter.autosar_adaptive.bench.services import Service, connected, members, output_name
from sigcat.adapter.autosar_adaptive.bench.text import comment, header, source, within
from sigcat.adapter.autosar_adaptive.cpp_names import member_name
from sigcat.function.document.text import Text
from sigcat.integration.autosar_adaptive.model import Event, Method, ServiceField

_MODE = "ara::com::MethodCallProcessingMode mode"


def skeleton_header(service: Service) -> str:
    """The header that an application includes."""
    whole = service.whole
    events = within(["events"], [_event(event, service) for event in whole.events]) if whole.events else []
    fields = within(["fields"], [_field(field, service) for field in whole.fields]) if whole.fields else []
    used = {"skeleton_event.h": whole.events, "skeleton_field.h": whole.fields}
    bases = [f"bench/{name}" for name, elements in used.items() if elements]
    includes = [service.names.common_header, service.tables_header, "bench/skeleton_base.h", *bases]
    body = within((*service.names.namespace, "skeleton"), [*events, *fields, _class(service)])
    return header(service.names.skeleton_header, f"Skeleton of {whole.name}.", includes, body)


def skeleton_source(service: Service) -> str:
    """Constructors, and what hands requests to methods."""
    parts = [
        _constructor(service, "ara::core::InstanceSpecifier"),
        _constructor(service, "ara::com::InstanceIdentifier"),
    ]
    if service.whole.methods:
        parts += [_move(service), _set_methods(service)]
    includes = [service.names.skeleton_header, *(["<utility>"] if service.whole.methods else [])]
    namespace = (*service.names.namespace, "skeleton")
    return source(f"Skeleton of {service.whole.name}.", includes, within(namespace, parts))


def _event(event: Event, service: Service) -> str:
    base = f"SkeletonEvent<{service.types.type(event.datatype)}>"
    return _element(about_event(event), member_name(event.name), base)


def _field(field: ServiceField, service: Service) -> str:
    base = f"SkeletonField<{service.types.type(field.word)}>"
    return _element(about_field(field), member_name(field.name), base)


def _element(about: Text, name: str, base: str) -> str:
    own = base.partition("<")[0]
    return f"{comment(about)}\nclass {name} final : public bench::{base} {{\npublic:\n    using {own}::{own};\n}};"


def _members(service: Service) -> list[str]:
    return [member_name(each.name) for each in service.elements]


def _class(service: Service) -> str:
    name, whole = service.names.skeleton_class, service.whole
    held = members({"events": whole.events, "fields": whole.fields})
    default = f"{_MODE} = ara::com::MethodCallProcessingMode::kEvent"
    rows = [
        f"class {name} : public bench::SkeletonBase<{service.tables[-1]}::kService> {{",
        "public:",
        f"    explicit {name}(const ara::core::InstanceSpecifier& instance,",
        f"        {default});",
        f"    explicit {name}(const ara::com::InstanceIdentifier& instance,",
        f"        {default});",
        *(_life_with_methods(name) if whole.methods else []),
        *_methods(service),
        *(["", *held] if held else []),
        *(["", "private:", "    void SetMethods();"] if whole.methods else []),
        "};",
    ]
    return "\n".join(rows)


def _life_with_methods(name: str) -> list[str]:
    return [
        f"    {name}({name}&& other) noexcept;",
        f"    virtual ~{name}() = default;",
    ]


def _methods(service: Service) -> list[str]:
    rows: list[str] = []
    for method in service.whole.methods:
        result = "void"
        rows += [""]
        if method.outputs:
            result = output_name(method)
            rows += [f"    using {result} = {service.result(method)};"]
        rows += [comment(about_method(method), 1)]
        rows += [
            f"    virtual ara::core::Future<{result}> {member_name(method.name)}({arguments(method, service)}) = 0;"
        ]
    return rows


def _constructor(service: Service, instance: str) -> str:
    name = service.names.skeleton_class
    made = "".join(f",\n      {member}" for member in connected(service))
    body = "{\n    SetMethods();\n}" if service.whole.methods else "{}"
    return f"{name}::{name}(const {instance}& instance, {_MODE})\n    : SkeletonBase{{instance, mode}}{made} {body}"


def _move(service: Service) -> str:
    """Requests are handed to the skeleton that it has become."""
    name = service.names.skeleton_class
    held = "".join(f",\n      {each}{{std::move(other.{each})}}" for each in _members(service))
    head = f"{name}::{name}({name}&& other) noexcept\n    : SkeletonBase{{std::move(other)}}{held}"
    return f"{head} {{\n    SetMethods();\n}}"


def _set_methods(service: Service) -> str:
    rows = [row for method in service.whole.methods for row in _set_method(method, service)]
    return "\n".join([f"void {service.names.skeleton_class}::SetMethods() {{", *rows, "}"])


def _set_method(method: Method, service: Service) -> list[str]:
    name, number = member_name(method.name), f"0x{method.method_id or 0:04X}"
    kinds = [service.types.type(each.datatype) for each in method.inputs or ()]
    passed = ", ".join(each.name for each in method.inputs or ())
    result = service.result(method)
    return [
        f"    connection_->SetMethod<{', '.join([result, *kinds])}>(",
        f"        {number}, [this]({arguments(method, service)}) {{ return this->{name}({passed}); }});",
    ]
