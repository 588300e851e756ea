"""Methods that the function uses or offers."""

from sigcat.adapter.autosar_adaptive.application.adapter_header import method_parameters, output_type, parameter_name
from sigcat.adapter.autosar_adaptive.application.names import LOCK, alone, braces, cpp_type, locked
from sigcat.adapter.autosar_adaptive.application.plan import CalledMethod, ComponentPlan, Provided, Required
from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, METHOD_ERRORS
from sigcat.adapter.core.c.lines import Lines, block, choice, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.function.document.text_filters import c_string


def method_functions(component: ComponentPlan) -> list[Lines]:
    """Requests of the function, and what comes of them."""
    return [
        part
        for service in component.required
        for each in service.methods
        for part in (_request(each, service, component), _poll(each, component))
    ]


def _request(method: CalledMethod, service: Required, component: ComponentPlan) -> Lines:
    core, name = component.core.type_name, method.method.named.name
    pending = f"pending_{method.member}_"
    locals_ = [parameter_name(argument) for argument, _ in method.arguments]
    converted = [
        lines(f"{cpp_type(type_)} {local}{{}};\napplication::Assign(asked.arguments.{core_side.name}, {local});")
        for local, (_, type_), core_side in zip(locals_, method.arguments, method.method.arguments, strict=True)
    ]
    arguments = ", ".join(locals_)
    results = ", &results" if method.results else ""
    declared = f"const {core}_{name}_Results results{{}};\n" if method.results else ""
    return block(f"void {component.type}::Request{method.member}()", [
        lines(f"decltype(core_.method.{name}) asked{{}};"),
        locked(f"asked = core_.method.{name};"),
        lines(f"{pending}.number = asked.number;\nconst auto service = {service.variable}.Get();"),
        block("if (service == nullptr)", [lines(
            f"{declared}{LOCK}\n"
            f"{core}_Answer_{name}(&core_, asked.number, false{results}, clock_->Now());\nreturn;")]),
        *converted,
        lines(f"{pending}.answer = service->{method.member}({arguments});"),
    ])  # fmt: skip


def _poll(method: CalledMethod, component: ComponentPlan) -> Lines:
    core, name = component.core.type_name, method.method.named.name
    pending = f"pending_{method.member}_"
    taken = [
        lines(f"application::Assign(answer.Value().{result}, results.{core_side.name});")
        for (result, _), core_side in zip(method.results, method.method.results, strict=True)
    ]
    results = ", &results" if method.results else ""
    failed = lines(f"logger_.LogWarn() << {c_string(f'{method.member} has failed: ')} << answer.Error().Message();")
    return block(f"void {component.type}::Poll{method.member}()", [
        lines("const std::lock_guard<std::mutex> publishing{publishing_mutex_};"),
        block(f"if (!{pending}.answer.valid() || !{pending}.answer.is_ready())", [lines("return;")]),
        lines(f"const auto answer = {pending}.answer.GetResult();"),
        lines(f"{core}_{name}_Results results{{}};") if method.results else (),
        choice([("answer.HasValue()", joined(taken)), ("", failed)]) if method.results else block("if (!answer.HasValue())", [failed]),
        lines(LOCK),
        lines(f"{core}_Answer_{name}(&core_, {pending}.number, answer.HasValue(){results}, clock_->Now());"),
    ])  # fmt: skip


def _refused(component: ComponentPlan, scope: Scope) -> list[tuple[str, Lines]]:
    """Replies of the core that refuse a request, as errors of the domain of methods."""
    namespace = "::".join(("", *component.error_namespace))
    errors = [
        (scope.constant(each.reply), lines(f"promise.SetError({namespace}::MakeErrorCode({namespace}::{DOMAIN}Errc::{each.name}, 0));"))
        for each in METHOD_ERRORS
    ]  # fmt: skip
    return [*((f"reply == {reply}", body) for reply, body in errors[:-1]), ("", errors[-1][1])]


# -- offered ------------------------------------------------------------------------------------------------------


def offered_functions(service: Provided, component: ComponentPlan) -> list[Lines]:
    """The service whose methods the component answers, and the answers."""
    if not service.methods:
        return []
    made = lines(f"{service.type}::{service.type}({component.type}& adapter)\n"
                 f"    : {service.names.skeleton_class}{{ara::core::InstanceSpecifier{{{c_string(service.port)}}}}}, adapter_(adapter) {{}}")  # fmt: skip
    found = [made]
    for each in service.methods:
        head = f"{output_type(service, each)} {{}}({method_parameters(each)})"
        names = ", ".join(parameter_name(name) for name, _ in each.arguments)
        forwarded = lines(f"return adapter_.Answer{each.member}({names});")
        found.append(block(head.format(f"{service.type}::{each.member}"), [forwarded]))
        answer = f"{component.type}::Answer{each.member}"
        found.append(block(head.format(answer), [_answered(each, service, component)]))
    return found


def _answered(method: CalledMethod, service: Provided, component: ComponentPlan) -> Lines:
    core, name, scope = component.core.type_name, method.method.named.name, Scope(component.core)
    output = f"::{service.names.skeleton}::{method.member}Output" if method.results else "void"
    arguments = "".join(
        part for part, is_there in ((", &arguments", method.arguments), (", &results", method.results)) if is_there
    )
    given = [
        lines(f"application::Assign({parameter_name(argument)}, arguments.{core_side.name});")
        for (argument, _), core_side in zip(method.arguments, method.method.arguments, strict=True)
    ]
    results = [
        lines(f"application::Assign(results.{core_side.name}, output.{result});")
        for (result, _), core_side in zip(method.results, method.method.results, strict=True)
    ]
    return joined([
        lines(f"ara::core::Promise<{output}> promise;"),
        lines(f"{core}_{name}_Arguments arguments{{}};") if method.arguments else (),
        lines(f"{core}_{name}_Results results{{}};") if method.results else (),
        *given,
        lines(f"{core}_Reply reply = {scope.constant('EXCLUDED')};"),
        braces([lines(f"{alone(component)}\nreply = {core}_Method_{name}(&core_{arguments});")]),
        choice([
            (f"reply == {scope.constant('OK')}", joined([
                lines(f"{output} output{{}};") if method.results else (),
                *results,
                lines("promise.set_value(output);") if method.results else lines("promise.set_value();"),
            ])),
            *_refused(component, scope),
        ]),
        lines("return promise.get_future();"),
    ])  # fmt: skip
