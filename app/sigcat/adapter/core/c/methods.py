"""Methods that a function offers or uses (section 12)."""

from sigcat.adapter.core.c import modes
from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import (
    Ends,
    assigned,
    check,
    flag,
    index,
    index_of_check,
    known_values,
    names_functions,
    needs_index,
)
from sigcat.adapter.core.plan import CLASS, Argument, Call, Method

STATUS = {"IDLE": 0, "PENDING": 1, "DONE": 2, "FAILED": 3, "TIMED_OUT": 4}
"""Result of a request, as its status variable has it."""


def arguments_type(method: Method, scope: Scope) -> str:
    """Struct of the arguments."""
    return f"{scope.prefix}_{method.named.name}_Arguments"


def results_type(method: Method, scope: Scope) -> str:
    """Struct of the results."""
    return f"{scope.prefix}_{method.named.name}_Results"


def offered_head(method: Method, scope: Scope) -> str:
    """The head of the function that answers a request."""
    known = []
    if method.arguments:
        known.append(f"const {arguments_type(method, scope)} *arguments")
    if method.results:
        known.append(f"{results_type(method, scope)} *results")
    return f"{scope.prefix}_Reply {scope.prefix}_Method_{method.named.name}({', '.join((scope.self_argument, *known))})"


def answer_head(method: Method, scope: Scope) -> str:
    """The head of the function that takes an answer."""
    results = f", const {results_type(method, scope)} *results" if method.results else ""
    name = f"{scope.prefix}_Answer_{method.named.name}"
    return f"void {name}({scope.self_argument}, uint32_t number, bool is_ok{results}, uint64_t t)"


def method_functions(scope: Scope) -> list[Lines]:
    """Functions that the platform calls for each method."""
    found: list[Lines] = []
    for method in scope.plan.methods:
        for each in (*method.arguments, *method.results):
            found += names_functions(each.value, _ends(each, method, scope))
        found += _checked_functions(method, scope)
        found += [_offered(method, scope)] if method.is_offered else [_answer(method, scope)]
    return found


def _ends(argument: Argument, method: Method, scope: Scope, source: str = "", target: str = "") -> Ends:
    names, own = f"{scope.prefix}_{method.named.name}_{argument.name}", scope.variable(argument.variable)
    put, is_read = scope.put if target == own else "", scope.is_cpp and source == own
    return Ends(source, target, names, method.named.pointer, put, is_read)


def _offered(method: Method, scope: Scope) -> Lines:
    c = scope.constant
    call = next((step for step in scope.plan.steps if step.name == method.call), None)
    runs = modes.condition(call, scope) if call else "true"
    at = "self->object." if scope.plan.code.signature == CLASS else ""
    objects = ", ".join(f"&self->code.{name}" for name in call.arguments) if call else ""
    done = joined([
        *(_taken_argument(each, method, scope) for each in method.arguments),
        lines(f"{at}{method.symbol}({objects});", method.named.pointer),
        *(_result(each, method, scope) for each in method.results),
    ])  # fmt: skip
    unknown = [f"!{_known_name(each, method, scope)}(arguments)" for each in method.arguments if each.value.is_checked]
    ready = "!self->is_ready || self->is_terminated" + ("" if runs == "true" else f" || !{runs}")
    ways = [(ready, lines(f"reply = {c('EXCLUDED')};"))]
    ways += [(" || ".join(unknown), lines(f"reply = {c('BAD_ARGUMENT')};"))] if unknown else []
    has_arrays = any(
        needs_index(each.value) for each in (*method.arguments, *method.results) if not each.value.is_checked
    )
    body = [
        lines(f"{scope.prefix}_Reply reply = {c('OK')};"),
        lines("uint32_t i;") if has_arrays else (),
        choice([*ways, ("", done)]),
        lines("return reply;"),
    ]
    return function(offered_head(method, scope), body, method.named.comment)


def _known_name(argument: Argument, method: Method, scope: Scope) -> str:
    return f"{scope.prefix}_IsKnown_{method.named.name}_{argument.name}"


def _checked_functions(method: Method, scope: Scope) -> list[Lines]:
    """Arguments and results with an enumeration: whether the numbers have names, and how each is received."""
    found = []
    items = method.arguments if method.is_offered else method.results
    struct = arguments_type(method, scope) if method.is_offered else results_type(method, scope)
    for each in items:
        if each.value.is_checked:
            ends = _ends(each, method, scope, f"given->{each.name}", scope.variable(each.variable))
            known = known_values(each.value)
            found.append(function(f"static bool {_known_name(each, method, scope)}(const {struct} *given)", [
                index_of_check(each.value), known, flag(each.value), check(each.value, ends), lines("return is_within;"),
            ]))  # fmt: skip
            name = f"{scope.prefix}_Take_{method.named.name}_{each.name}"
            head = f"static void {name}({scope.self_argument}, const {struct} *given)"
            found.append(
                function(head, [index(each.value), known, assigned(each.value, ends, scope.prefix, is_new=True)])
            )
    return found


def _taken_argument(argument: Argument, method: Method, scope: Scope) -> Lines:
    if argument.value.is_checked:
        return lines(f"{scope.prefix}_Take_{method.named.name}_{argument.name}(self, arguments);")
    source, target = f"arguments->{argument.name}", scope.variable(argument.variable)
    return assigned(argument.value, _ends(argument, method, scope, source, target), scope.prefix)


def _result(result: Argument, method: Method, scope: Scope) -> Lines:
    source = scope.variable(result.variable)
    return assigned(
        result.value, _ends(result, method, scope, source, f"results->{result.name}"), scope.prefix, quiet=True
    )


# -- used methods -------------------------------------------------------------------------------------------------


def _answer(method: Method, scope: Scope) -> Lines:
    place = f"self->method.{method.named.name}"
    keep = lines(f"{place}.answer = *results;") if method.results else ()
    taken = joined([lines(f"{place}.is_answered = true;\n{place}.is_ok = is_ok;"), keep])
    body = [
        lines(f"(void){scope.prefix}_Now(self, t);"),
        block(
            f"if ((number == {place}.number) && ({place}.status == {STATUS['PENDING']}U) && !{place}.is_answered)",
            [taken],
        ),
    ]
    return function(answer_head(method, scope), body, method.named.comment)


def _of_call(call: Call, scope: Scope) -> list[Method]:
    return [method for method in scope.plan.requests if method.call == call.name]


def takes_arrays(call: Call, scope: Scope) -> bool:
    """Whether answers are taken element by element."""
    results = [each.value for method in _of_call(call, scope) for each in method.results]
    return any(needs_index(value) for value in results if not value.is_checked)


def requests_arrays(call: Call, scope: Scope) -> bool:
    """Whether arguments are taken element by element."""
    return any(needs_index(each.value) for method in _of_call(call, scope) for each in method.arguments)


def taken(call: Call, scope: Scope) -> Lines:
    """Answers, taken with the snapshot of a call."""
    return joined(_taken(method, scope) for method in _of_call(call, scope))


def _taken(method: Method, scope: Scope) -> Lines:
    place = f"self->method.{method.named.name}"
    known = [f"{_known_name(each, method, scope)}(&{place}.answer)" for each in method.results if each.value.is_checked]
    good = " && ".join([f"{place}.is_ok", *known])
    done = joined([
        lines(f"{place}.is_answered = false;"),
        choice([
            (good, joined([lines(f"{place}.status = {STATUS['DONE']}U;"),
                           *(_answered(each, method, scope) for each in method.results)])),
            ("", lines(f"{place}.status = {STATUS['FAILED']}U;")),
        ]),
    ])  # fmt: skip
    ways = [(f"{place}.is_answered", done)]
    if method.time_out is not None:
        late = f"({place}.status == {STATUS['PENDING']}U) && ((t - {place}.since) > {time(method.time_out)})"
        ways.append((late, lines(f"{place}.status = {STATUS['TIMED_OUT']}U;")))
        ways.append(("", lines("/* nothing new */")))
    return joined([choice(ways), status_written(method, scope)])


def status_written(method: Method, scope: Scope) -> Lines:
    """Write the result of a request to its variable, if it has one."""
    if method.status_variable is None:
        return ()
    status = f"self->method.{method.named.name}.status"
    return lines(scope.assigned(method.status_variable, status), method.named.pointer)


def _answered(result: Argument, method: Method, scope: Scope) -> Lines:
    place = f"self->method.{method.named.name}.answer"
    if result.value.is_checked:
        return lines(f"{scope.prefix}_Take_{method.named.name}_{result.name}(self, &{place});")
    ends = _ends(result, method, scope, f"{place}.{result.name}", scope.variable(result.variable))
    return assigned(result.value, ends, scope.prefix)


def requested(call: Call, scope: Scope) -> Lines:
    """Requests that a call has made."""
    return joined(_requested(method, scope) for method in _of_call(call, scope))


def _requested(method: Method, scope: Scope) -> Lines:
    assert method.request_variable is not None
    name = method.named.name
    place, variable = f"self->method.{name}", method.request_variable
    arguments = [
        assigned(each.value, _ends(each, method, scope, scope.variable(each.variable), f"{place}.arguments.{each.name}"),
                 scope.prefix, quiet=True)
        for each in method.arguments
    ]  # fmt: skip
    asked = joined([
        *arguments,
        lines(scope.assigned(variable, "0"), method.named.pointer),
        lines(f"""
            {place}.status = {STATUS['PENDING']}U;
            {place}.since = t;
            {place}.number++;
            self->publish.{name} = true;
        """),
    ])  # fmt: skip
    return block(
        f"if ({scope.is_set(variable)} && ({place}.status != {STATUS['PENDING']}U))",
        [asked],
        source=method.named.pointer,
    )
