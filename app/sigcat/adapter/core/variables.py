"""The variables of the code that a core reads and writes."""

from collections.abc import Callable

from sigcat.adapter.core.plan import Argument, Call, CorePlan, Error, Method, Queue, Reaction

_Rewrite = Callable[[str], str]


def expressions(plan: CorePlan) -> tuple[str, ...]:
    """Each expression of a variable of the code."""
    found: list[str] = []

    def collect(expression: str) -> str:
        found.append(expression)
        return expression

    with_variables(plan, collect)
    return tuple(found)


def with_variables(plan: CorePlan, rewrite: _Rewrite) -> CorePlan:
    """The same plan, with each expression of a variable rewritten."""
    code = plan.code
    if plan.has_globals:  # otherwise they are members
        code = code._replace(
            objects=tuple(each._replace(name=rewrite(each.name)) for each in code.objects),
            externs=tuple(each._replace(name=rewrite(each.name)) for each in code.externs),
        )
    return plan._replace(
        code=code,
        parameters=tuple(each._replace(variable=rewrite(each.variable)) for each in plan.parameters),
        errors=tuple(_of_error(each, rewrite) for each in plan.errors),
        reactions=tuple(_of_reaction(each, rewrite) for each in plan.reactions),
        mode_in=plan.mode_in and plan.mode_in._replace(variable=_optional(plan.mode_in.variable, rewrite)),
        mode_out=plan.mode_out and plan.mode_out._replace(variable=rewrite(plan.mode_out.variable)),
        methods=tuple(_of_method(each, rewrite) for each in plan.methods),
        inits=_of_calls(plan.inits, rewrite),
        steps=_of_calls(plan.steps, rewrite),
        due=_of_calls(plan.due, rewrite),
        terminates=_of_calls(plan.terminates, rewrite),
    )


def _optional(expression: str | None, rewrite: _Rewrite) -> str | None:
    return None if expression is None else rewrite(expression)


def _of_error(error: Error, rewrite: _Rewrite) -> Error:
    status = _optional(error.status_variable, rewrite)
    return error._replace(variable=_optional(error.variable, rewrite), status_variable=status)


def _of_reaction(reaction: Reaction, rewrite: _Rewrite) -> Reaction:
    return reaction._replace(variable=_optional(reaction.variable, rewrite))


def _of_method(method: Method, rewrite: _Rewrite) -> Method:
    return method._replace(
        request_variable=_optional(method.request_variable, rewrite),
        status_variable=_optional(method.status_variable, rewrite),
        arguments=_of_arguments(method.arguments, rewrite),
        results=_of_arguments(method.results, rewrite),
    )


def _of_arguments(arguments: tuple[Argument, ...], rewrite: _Rewrite) -> tuple[Argument, ...]:
    return tuple(each._replace(variable=rewrite(each.variable)) for each in arguments)


def _of_calls(calls: tuple[Call, ...], rewrite: _Rewrite) -> tuple[Call, ...]:
    return tuple(_of_call(each, rewrite) for each in calls)


def _of_call(call: Call, rewrite: _Rewrite) -> Call:
    inputs = tuple(
        each._replace(variable=rewrite(each.variable), queue=_of_queue(each.queue, rewrite)) for each in call.inputs
    )
    outputs = tuple(
        each._replace(variable=rewrite(each.variable), queue=_of_queue(each.queue, rewrite)) for each in call.outputs
    )
    return call._replace(inputs=inputs, outputs=outputs)


def _of_queue(queue: Queue | None, rewrite: _Rewrite) -> Queue | None:
    return queue and queue._replace(count_variable=_optional(queue.count_variable, rewrite))
