"""The source of a component's adapter."""

from collections.abc import Iterable, Mapping

from sigcat.adapter.autosar_adaptive.application.adapter_header import has_deadline, has_offered
from sigcat.adapter.autosar_adaptive.application.calls import call_functions, thread_name
from sigcat.adapter.autosar_adaptive.application.methods import method_functions, offered_functions
from sigcat.adapter.autosar_adaptive.application.names import (
    LOCK,
    alone,
    braces,
    commented,
    cpp_type,
    in_namespace,
    monitor_name,
    sent_name,
    watched,
    writes,
)
from sigcat.adapter.autosar_adaptive.application.plan import (
    ApplicationPlan,
    ComponentPlan,
    Monitor,
    Provided,
    Receiver,
    Required,
    SentEvent,
    SentField,
)
from sigcat.adapter.autosar_adaptive.application.stored import storage_functions
from sigcat.adapter.core.c.lines import Line, Lines, block, indented, joined, lines, spaced
from sigcat.adapter.core.plan import Call, Port
from sigcat.function.document.text_filters import c_header, c_string


def adapter_source(component: ComponentPlan, application: ApplicationPlan) -> Lines:
    """The whole source."""
    return spaced([_includes(component), in_namespace(application, [
        _constructor(component),
        _destructor(component),
        _start(component),
        _stop(component),
        *storage_functions(component),
        _offer(component),
        *call_functions(component),
        _publish(component),
        *filter(None, (_repeat(call, component) for call in component.core.steps)),
        *method_functions(component),
        *(_connect(service, component) for service in component.required),
        *(part for service in component.provided for part in offered_functions(service, component)),
    ])])  # fmt: skip


def _includes(component: ComponentPlan) -> Lines:
    own = f"#include {c_header(f'{component.stem}_adapter.h')}"
    structs = [f"#include {c_header(f'{component.stem}_structs.h')}"] if component.structs else []
    standard = ["#include <chrono>"] if has_deadline(component) else []
    standard += ["#include <functional>"] if component.is_threaded else []
    standard += ["#include <shared_mutex>"] if component.is_threaded and has_offered(component) else []
    standard += ["#include <vector>"] if component.is_threaded else []
    platform = ['#include "ara/core/instance_specifier.h"'] if component.provided else []
    if has_offered(component):
        platform = [*platform, '#include "ara/core/promise.h"']
    groups = [[own, *structs], standard, platform]
    return lines("\n\n".join("\n".join(group) for group in groups if group))


def _constructor(component: ComponentPlan) -> Lines:
    context = component.name[:4].upper()
    initial = [f"logger_(ara::log::CreateLogger({c_string(context)}, {c_string(f'Adapter of {component.name}')}))"]
    initial += [f"{each.variable}{{{c_string(each.port)}, logger_}}" for each in component.storages]
    initial += [f"{monitor_name(each.error)}{{{c_string(each.port)}, logger_}}" for each in component.monitors]
    initial += [_supervision(component)] if component.checkpoints else []
    initial += [_constructed(each) for each in component.provided]
    initial += [
        f"{each.variable}{{{c_string(each.port)}, logger_, [this](auto& service) {{ Connect(service); }}}}"
        for each in component.required
    ]
    rows = [f"    : {initial[0]},", *(f"      {each}," for each in initial[1:])]
    rows[-1] = f"{rows[-1][:-1]} {{}}"
    return tuple(Line(text) for text in (f"{component.type}::{component.type}()", *rows))


def _supervision(component: ComponentPlan) -> str:
    return f"supervision_{{ara::core::InstanceSpecifier{{{c_string(component.supervision)}}}}}"


def _constructed(service: Provided) -> str:
    if service.methods:
        return f"{service.variable}{{*this}}"
    return f"{service.variable}{{ara::core::InstanceSpecifier{{{c_string(service.port)}}}}}"


def _destructor(component: ComponentPlan) -> Lines:
    return lines(f"{component.type}::~{component.type}() = default;")


def _start(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    stored = "&stored" if component.storages else "nullptr"
    loaded = f"const {core}_Stored stored = Load();\n" if component.storages else ""
    cycle = "stored.ignition_cycle + 1U" if component.storages else "1U"
    watch = "".join(
        f"{name} = std::make_unique<application::Watch>([this] {{ Supervise(); }});\n" for name in watched(component)
    )
    threads = "".join(_started(number, component) for number in range(len(component.threads)) if component.is_threaded)
    found = "\n".join(f"{each.variable}.Find();" for each in component.required)
    body = lines(
        f"""
{loaded}if (!{core}_Init(&core_, {stored}, {cycle})) {{
    logger_.LogFatal() << {c_string(f"The initialization of {component.core.function} has failed")};
    return false;
}}
Offer();
{found}
{{
    {LOCK}
    {core}_Start(&core_, clock_->Now());
}}
{watch}{threads}thread_ = std::thread{{[this] {{ Run(); }}}};
return true;
""".replace("\n\n", "\n")
    )
    return block(f"bool {component.type}::Start()", [body])


def _started(number: int, component: ComponentPlan) -> str:
    thread, most = component.threads[number], component.threads[0].priority
    calls = ", ".join(f"[this] {{ Run{call.name}(); }}" for call in thread.calls)
    made = f"std::make_unique<application::CallThread>(\n    logger_, {most - thread.priority}, std::vector<std::function<void()>>{{{calls}}});\n"
    return f"{thread_name(number)} = {made}"


def _stop(component: ComponentPlan) -> Lines:
    """No method may run while the function ends; services that have none tell what comes of its end before they go."""
    core = component.core.type_name
    answering = _withdrawn(each for each in component.provided if each.methods)
    others = _withdrawn(each for each in component.provided if not each.methods)
    call = alone(component) if has_offered(component) else ""
    threads = "\n".join(
        f"{thread_name(number)}.reset();" for number in range(len(component.threads)) if component.is_threaded
    )
    left = "\n".join(f"{each.variable}.Leave();" for each in component.required)
    monitors = "\n".join(f"{monitor_name(each.error)}.StopOffer();" for each in component.monitors)
    watch = "\n".join(f"{name}.reset();" for name in watched(component))
    stored = "Store();" if writes(component) else ""
    body = f"""
clock_->Stop();
thread_.join();
{threads}
{watch}
{left}
{answering}
{{
    {call}
    {LOCK}
    {core}_Terminate(&core_, clock_->Now());
}}
Publish();
{others}
{monitors}
{stored}
"""
    return block(f"void {component.type}::Stop()", [lines("\n".join(row for row in body.split("\n") if row.strip()))])


def _withdrawn(services: Iterable[Provided]) -> str:
    return "\n".join(f"{each.variable}.StopOfferService();" for each in services)


def _offer(component: ComponentPlan) -> Lines:
    """Fields have a value before they are offered: that of the core, or that of an error which was not tested."""
    initial = [
        lines(f"application::Update<::{field.type}>(logger_, {service.variable}.{field.member}, {_initial(field.place, field.initial)});{_kept(field)}")
        for service in component.provided for field in service.fields
    ]  # fmt: skip
    offers = [
        block(f"if (!{service.variable}.OfferService().HasValue())",
              [lines(f"logger_.LogError() << {c_string(f'{service.name} cannot be offered')};")])
        for service in component.provided
    ]  # fmt: skip
    monitors = [lines(f"{monitor_name(each.error)}.Offer();") for each in component.monitors]
    if initial:
        initial.insert(
            0, commented("A field has a value from the beginning: an error that was not tested yet is PASSED.")
        )
    return block(f"void {component.type}::Offer()", [*initial, *monitors, lines("Publish();"), *offers])


def _kept(field: SentField) -> str:
    return f"\n{sent_name(field)} = {_initial(field.place, field.initial)};" if field.repeated_by else ""


def _initial(place: str, number: int | None) -> str:
    return f"core_.out.{place}" if number is None else f"std::uint8_t{{{number}U}}"


# -- sending ------------------------------------------------------------------------------------------------------


def _publish(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    monitors = {each.error.named.name: each for each in component.monitors}
    sent = [part for service in component.provided for part in _sent(service, core, monitors)]
    reactions = [_logged(each.named.name, each.active) for each in component.core.reactions]
    asked = [
        block(f"if (publish.{each.method.named.name})", [lines(f"Request{each.member}();")])
        for service in component.required for each in service.methods
    ]  # fmt: skip
    uses_out = bool(sent or reactions)
    told = lines(f"{core}_Published(&core_);")
    if not (uses_out or asked):
        return block(f"void {component.type}::Publish()", [lines(LOCK), told])
    return block(f"void {component.type}::Publish()", [
        lines("const std::lock_guard<std::mutex> publishing{publishing_mutex_};"),
        lines("decltype(core_.out) out{};") if uses_out else (),
        lines("decltype(core_.publish) publish{};"),
        braces([
            lines(LOCK),
            lines("out = core_.out;") if uses_out else (),
            lines("publish = core_.publish;"),
            told,
        ]),
        *sent, *reactions, *asked,
    ])  # fmt: skip


def _sent(service: Provided, core: str, monitors: Mapping[str, Monitor]) -> list[Lines]:
    found = [_sent_event(event, service, core) for event in service.events]
    for field in service.fields:
        update = f"application::Update<::{field.type}>(logger_, {service.variable}.{field.member}, out.{field.place});"
        told = _told(monitors[field.place]) if field.error else ()
        kept = lines(f"{sent_name(field)} = out.{field.place};") if field.repeated_by else ()
        found.append(block(f"if (publish.{field.place})", [commented(field.comment), kept, lines(update), told]))
    return found


def _repeat(call: Call, component: ComponentPlan) -> Lines:
    """A state that is protected is sent again, so that a lost message is noticed and does not last."""
    updates = [
        lines(f"application::Update<::{field.type}>(logger_, {service.variable}.{field.member}, {sent_name(field)});")
        for service in component.provided for field in service.fields if field.repeated_by == call.name
    ]  # fmt: skip
    if not updates:
        return ()
    lock = lines("const std::lock_guard<std::mutex> publishing{publishing_mutex_};")
    return block(f"void {component.type}::Repeat{call.name}()", [lock, *updates])


def _sent_event(event: SentEvent, service: Provided, core: str) -> Lines:
    value = f"out.{event.place}.values[i]" if event.is_queue else f"out.{event.place}"
    send = lines(f"application::Send(logger_, {service.variable}.{event.member}, {value});")
    one = joined([send, *(_taken_back(port, value, core) for port in event.own_ports)])
    if event.is_queue:
        one = block(f"for (std::uint32_t i = 0; i < out.{event.place}.count; ++i)", [one])
    return block(f"if (publish.{event.place})", [commented(event.comment), one])


def _taken_back(port: Port, value: str, core: str) -> Lines:
    """Another call of the function takes what this one sends: no message is needed for that."""
    argument = f"&{value}" if port.wire.is_struct and port.wire.length is None else value
    take = lines(f"{core}_Receive_{port.name}(&core_, {argument}, clock_->Now());")
    wake = lines("clock_->Wake();") if port.triggers else ()
    return joined([braces([lines(LOCK), take]), wake])


def _told(monitor: Monitor) -> Lines:
    error = monitor.error
    return lines(f"{monitor_name(error)}.Tell(out.{error.named.name} == {error.failed}U);")


def _logged(place: str, active: int) -> Lines:
    """A safety reaction is decided by the function: there is no service over which it is sent."""
    body = f"""
        const bool is_active = out.{place} == {active}U;
        logger_.WithLevel(is_active ? ara::log::LogLevel::kWarn : ara::log::LogLevel::kInfo)
            << {c_string(f"{place} is ")} << (is_active ? "active" : "inactive");
    """
    return block(f"if (publish.{place})", [lines(body)])


# -- receiving ----------------------------------------------------------------------------------------------------


def _connect(service: Required, component: ComponentPlan) -> Lines:
    core = component.core.type_name
    parts = [_received(each, core, component) for each in service.receivers]
    if not parts:
        parts = [lines("static_cast<void>(service);  // only methods are used")]
    return block(f"void {component.type}::Connect(::{service.names.proxy}& service)", parts)


def _received(receiver: Receiver, core: str, component: ComponentPlan) -> Lines:
    wakes = any(receiver.function == port.name and port.triggers for port in component.core.ports)
    lambda_head = f"[this](const {cpp_type(receiver.type)}& value) {{"
    return joined([
        commented(receiver.comment),
        lines("application::Receive("),
        indented(lines(f"logger_, service.{receiver.member}, {_subscription(receiver)},")),
        indented(lines(lambda_head)),
        indented(_taken(receiver, core, wakes=wakes), 2),
        indented(_rejected(receiver, core)),
    ])  # fmt: skip


def _subscription(receiver: Receiver) -> str:
    is_protected = "true" if receiver.is_protected else "false"
    return f"{{{c_string(receiver.member)}, {receiver.capacity}U, {is_protected}}}"


def _rejected(receiver: Receiver, core: str) -> Lines:
    if not receiver.tells_of_rejection:
        return lines("});")
    return joined([
        lines("},"),
        block("[this]", [
            lines(LOCK),
            lines(f"{core}_Reject_{receiver.function}(&core_, clock_->Now());"),
        ], "});"),
    ])  # fmt: skip


def _taken(receiver: Receiver, core: str, *, wakes: bool) -> Lines:
    wire = receiver.wire
    declared: Lines = ()
    argument = "value"
    if wire.is_struct or wire.length is not None:
        array = f"[{wire.length}]" if wire.length is not None else ""
        declared = lines(f"{wire.c} taken{array};\napplication::Assign(value, taken);")
        argument = "taken" if wire.length is not None else "&taken"
    elif cpp_type(receiver.type).startswith("::"):
        argument = f"static_cast<{wire.c}>(value)"
    take = lines(f"{core}_Receive_{receiver.function}(&core_, {argument}, clock_->Now());")
    if not wakes:
        return joined([declared, lines(LOCK), take])
    lock = lines(LOCK)
    return joined([declared, braces([lock, take]), lines("clock_->Wake();")])
