"""Errors and safety reactions (sections 6 and 7)."""

from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Error, Reaction


def error_functions(scope: Scope) -> list[Lines]:
    """The table of states, and what makes each error present."""
    if not scope.plan.errors:
        return []
    return [
        _next(scope), _update(scope), *(_evaluate(error, scope) for error in scope.plan.errors if error.call)
    ]  # fmt: skip


def _next(scope: Scope) -> Lines:
    p, c = scope.prefix, scope.constant
    return lines(f"""
        /* The table of states. may_heal: the reset condition holds. */
        static {p}_ErrorState {p}_Next(const {p}_Error *error, {p}_Verdict verdict, bool may_heal)
        {{
            const bool has_failed = {p}_HasFailed(error);
            {p}_ErrorState next = error->state;

            if (verdict == {c("PRESENT")}) {{
                next = has_failed ? {c("FAILED")} : {c("PREFAILED")};
            }} else if ((verdict == {c("ABSENT")}) && !has_failed) {{
                next = {c("PASSED")};
            }} else if (verdict == {c("ABSENT")}) {{
                next = may_heal ? {c("HEALING")} : {c("FAILED")};
            }} else {{
                /* not evaluated */
            }}
            return next;
        }}
    """)


def _update(scope: Scope) -> Lines:
    p, c = scope.prefix, scope.constant
    return lines(f"""
        /* The next state; PREFAILED and HEALING end when their time has passed. */
        static void {p}_Update({p}_Error *error, {p}_Counts *counts, {p}_ErrorState next, uint64_t maturation,
            uint64_t reset, uint64_t t)
        {{
            const bool had_failed = {p}_HasFailed(error);

            if (next != error->state) {{
                error->before = error->state;
                error->state = next;
                error->since = t;
            }}
            if ((error->state == {c("PREFAILED")}) && ((t - error->since) >= maturation)) {{
                error->state = {c("FAILED")};
            }}
            if ((error->state == {c("HEALING")}) && ((t - error->since) >= reset)) {{
                error->state = {c("PASSED")};
            }}
            if ({p}_HasFailed(error) && !had_failed && (counts->occurrences < UINT16_MAX)) {{
                counts->occurrences++;
            }}
            counts->is_tested = counts->is_tested || (error->state != {c("NOT_TESTED")});
            counts->has_failed = counts->has_failed || {p}_HasFailed(error);
        }}
    """)


def _evaluate(error: Error, scope: Scope) -> Lines:
    p, name = scope.prefix, error.named.name
    place, counts = f"self->error.{name}", f"self->stored.{name}"
    heals = "false" if error.waits_for_restart else f"self->{error.reset_input}" if error.reset_input else "true"
    verdicts = [f"self->{cause.place}" for cause in error.causes] + _tested(error, scope)
    next_state = f"{p}_Next(&{place}, verdict, {heals})"
    if dependencies := _any_failed(error.dependencies, error.foreign, scope):
        next_state = f"({dependencies}) ? {scope.constant('FAILED')} : {next_state}"
    windows = [cause.place.split(".")[0] for cause in error.causes if cause.place.endswith(".alive.verdict")]
    update = (
        f"const {p}_ErrorState next = {next_state};\n\n"
        f"{p}_Update(&{place}, &{counts}, next, {time(error.maturation)}, {time(error.reset)}, t);"
    )
    body = [
        *(lines(f"{p}_JudgeWindows_{call}(self);") for call in windows),
        _worst(verdicts or [scope.constant("NOT_JUDGED")], error, scope),
        lines(update),
        _sent(error, scope),
    ]
    head = f"static void {p}_Evaluate_{name}({scope.self_argument}, uint64_t t)"
    return function(head, body, error.named.comment)


def _worst(verdicts: list[str], error: Error, scope: Scope) -> Lines:
    """The worst of some verdicts."""
    first, *others = verdicts
    worse = (lines(f"verdict = {scope.prefix}_Worse(verdict, {each});", error.named.pointer) for each in others)
    constant = "" if others else "const "
    return joined([lines(f"{constant}{scope.prefix}_Verdict verdict = {first};", error.named.pointer), *worse])


def _tested(error: Error, scope: Scope) -> list[str]:
    """Dependencies that have been tested: the error has been judged with them."""
    own = (f"self->error.{name}.state != {scope.constant('NOT_TESTED')}" for name in error.dependencies)
    foreign = (f"self->received.{name}.reception.is_there" for name in error.foreign)
    return [f"({test}) ? {scope.absent} : {scope.constant('NOT_JUDGED')}" for test in (*own, *foreign)]


def _any_failed(own: tuple[str, ...], foreign: tuple[str, ...], scope: Scope) -> str:
    """The condition that any of some errors has failed."""
    conditions = [
        *(f"{scope.prefix}_HasFailed(&self->error.{name})" for name in own),
        *(f"(self->received.{name}.value != 0U)" for name in foreign),
    ]
    return " || ".join(conditions)


def _sent(error: Error, scope: Scope) -> Lines:
    """What is sent: with the first verdict and on change."""
    p, c, name = scope.prefix, scope.constant, error.named.name
    place, out = f"self->error.{name}", f"self->out.{name}"
    send = lines(f"""
        if (!{place}.is_sent || ({out} != status)) {{
            {out} = status;
            {place}.is_sent = true;
            self->publish.{name} = true;
        }}
    """)
    status = f"const {error.wire.c} status = {p}_HasFailed(&{place}) ? {error.failed}U : {error.passed}U;"
    is_known = f"({place}.state != {c('NOT_TESTED')}) && ({place}.state != {c('PREFAILED')})"
    return joined([confirmed(error), block(f"if ({is_known})", [lines(status), send])])


def confirmed(error: Error) -> Lines:
    """Whether an error has failed as often, and in as many ignition cycles, as it takes."""
    name = error.named.name
    least = f">= {error.occurrence_limit}U" if error.occurrence_limit else "> 0U"
    limits = [f"(self->stored.{name}.occurrences {least})"]
    if error.ignition_limit:
        limits.append(f"(self->stored.{name}.ignition_cycles >= {error.ignition_limit}U)")
    return lines(f"self->error.{name}.is_confirmed = {' && '.join(limits)};")


def evaluated(errors: tuple[Error, ...], scope: Scope) -> Lines:
    """Errors evaluated, each after those that it depends on."""
    return joined(lines(f"{scope.prefix}_Evaluate_{error.named.name}(self, t);") for error in errors)


# -- safety reactions ---------------------------------------------------------------------------------------------


def reaction_functions(scope: Scope) -> list[Lines]:
    """What each reaction hears from outside, and what makes it active."""
    found = []
    for reaction in scope.plan.reactions:
        found.append(_receive(reaction, scope))
        found += [_react(reaction, call, scope) for call in reaction.calls] if reaction.time_out is not None else []
        found += [_react(reaction, "", scope)] if reaction.time_out is None and reaction.calls else []
    return found


def reaction_head(reaction: Reaction, scope: Scope) -> str:
    """The head of the function that hears the outside."""
    return (
        f"void {scope.prefix}_Receive_{reaction.named.name}({scope.self_argument}, {reaction.wire.c} value, uint64_t t)"
    )


def _receive(reaction: Reaction, scope: Scope) -> Lines:
    place = f"self->reaction.{reaction.named.name}"
    now = f"{scope.prefix}_Now(self, t)"
    timed = f"{place}.reception.time = {now};\n{place}.reception.count++;\n{place}.reception.is_there = true;"
    said = choice([
        (f"value == {reaction.active}U", lines(f"{place}.outside = {scope.present};")),
        (f"value == {reaction.inactive}U", lines(f"{place}.outside = {scope.absent};")),
        ("", lines("/* a number without a name says nothing */")),
    ])  # fmt: skip
    body = [said, lines(timed if reaction.time_out is not None else f"(void){now};")]
    return function(reaction_head(reaction, scope), body, reaction.named.comment)


def _react(reaction: Reaction, call: str, scope: Scope) -> Lines:
    """With a time-out each call judges by itself, as its clocks start by themselves."""
    name = reaction.named.name
    place, out = f"self->reaction.{name}", f"self->out.{name}"
    conditions = [
        _any_failed(reaction.errors, reaction.foreign, scope),
        f"({place}.outside == {scope.present})",
        f"self->{call}.reaction.{name}.is_late" if call else "",
        f"({place}.outside == {scope.constant('NOT_JUDGED')})" if _is_active_first(reaction) else "",
    ]
    body = [
        _judged(reaction, call, scope),
        lines(f"status = ({' || '.join(filter(None, conditions))}) ? {reaction.active}U : {reaction.inactive}U;"),
        lines(f"""
            if ({out} != status) {{
                {out} = status;
                self->publish.{name} = true;
            }}
        """),
    ]
    time_argument = ", uint64_t t" if call else ""
    head = f"static void {scope.prefix}_React_{name}{f'_{call}' if call else ''}({scope.self_argument}{time_argument})"
    return function(head, [lines(f"{reaction.wire.c} status;"), *body], reaction.named.comment)


def _is_active_first(reaction: Reaction) -> bool:
    """Whether it is active until the outside has said something: nothing else decides it."""
    return reaction.initial == reaction.active and not reaction.errors and not reaction.foreign


def _judged(reaction: Reaction, call: str, scope: Scope) -> Lines:
    if not call or reaction.time_out is None:
        return ()
    name = reaction.named.name
    clock, reception = f"&self->{call}.reaction.{name}", f"&self->reaction.{name}.reception"
    limits = f"self->{call}.entered, {time(reaction.time_out)}, 1U, false, t"
    return lines(f"{scope.prefix}_Judge({clock}, {reception}, {limits});")


def reacted(call: str, scope: Scope) -> Lines:
    """Reactions that a call lists, evaluated and written to their variables."""
    found = []
    for reaction in scope.plan.reactions:
        if call in reaction.calls:
            name = reaction.named.name
            timed = f"_{call}(self, t)" if reaction.time_out is not None else "(self)"
            found.append(lines(f"{scope.prefix}_React_{name}{timed};"))
            found.append(reaction_written(reaction, scope))
    return joined(found)


def reaction_written(reaction: Reaction, scope: Scope) -> Lines:
    """A reaction in its variable, if it has one."""
    if reaction.variable is None:
        return ()
    return lines(scope.assigned(reaction.variable, f"self->out.{reaction.named.name}"), reaction.named.pointer)


def status_written(error: Error, scope: Scope) -> Lines:
    """What is sent of an error, in its variable, if it has one."""
    if error.status_variable is None:
        return ()
    return lines(scope.assigned(error.status_variable, f"self->out.{error.named.name}"), error.named.pointer)
