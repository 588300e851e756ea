"""Errors and safety reactions (sections 6 and 7)."""

from sigcat.adapter.core.c.lines import Lines, block, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Error, Reaction


def error_functions(scope: Scope) -> list[Lines]:
    """The table of states, and what makes each error present."""
    if not scope.plan.errors:
        return []
    return [
        _fail(scope), _update(scope), _suspend(scope), *(_evaluate(error, scope) for error in scope.plan.errors)
    ]  # fmt: skip


def _fail(scope: Scope) -> Lines:
    p, failed = scope.prefix, scope.constant("FAILED")
    return lines(f"""
        /* The error has failed: one more occurrence. */
        static void {p}_Fail({p}_Error *error, {p}_Counts *counts)
        {{
            error->state = {failed};
            if (counts->occurrences < UINT16_MAX) {{
                counts->occurrences++;
            }}
        }}
    """)


def _update(scope: Scope) -> Lines:
    p, c = scope.prefix, scope.constant
    return lines(f"""
        /* The table of states. may_heal: the reset condition holds. */
        static void {p}_Update({p}_Error *error, {p}_Counts *counts, {p}_Verdict verdict, bool is_dependency_failed,
            bool may_heal, uint64_t maturation, uint64_t reset, uint64_t t)
        {{
            if (is_dependency_failed) {{
                if ((error->state != {c("FAILED")}) && (error->state != {c("HEALING")})) {{
                    {p}_Fail(error, counts);
                }}
                error->state = {c("FAILED")};
            }} else if (verdict == {c("PRESENT")}) {{
                if ((error->state == {c("NOT_TESTED")}) || (error->state == {c("PASSED")})) {{
                    error->before = error->state;
                    error->state = {c("PREFAILED")};
                    error->since = t;
                }}
                if (error->state == {c("HEALING")}) {{
                    error->state = {c("FAILED")};
                }}
                if ((error->state == {c("PREFAILED")}) && ((t - error->since) >= maturation)) {{
                    {p}_Fail(error, counts);
                }}
            }} else if (verdict == {c("ABSENT")}) {{
                if ((error->state == {c("NOT_TESTED")}) || (error->state == {c("PREFAILED")})) {{
                    error->state = {c("PASSED")};
                }}
                if ((error->state == {c("FAILED")}) && may_heal) {{
                    error->state = {c("HEALING")};
                    error->since = t;
                }}
                if ((error->state == {c("HEALING")}) && !may_heal) {{
                    error->state = {c("FAILED")};
                }}
                if ((error->state == {c("HEALING")}) && ((t - error->since) >= reset)) {{
                    error->state = {c("PASSED")};
                }}
            }} else {{
                /* not evaluated */
            }}
            counts->is_tested = counts->is_tested || (error->state == {c("PASSED")});
            counts->has_failed = counts->has_failed || (error->state == {c("FAILED")});
        }}
    """)


def _suspend(scope: Scope) -> Lines:
    p, c = scope.prefix, scope.constant
    if scope.plan.mode_in is None:
        return ()
    return lines(f"""
        /* The mode excludes the call of the error: what was under way ends. */
        static void {p}_Suspend({p}_Error *error)
        {{
            if (error->state == {c("PREFAILED")}) {{
                error->state = error->before;
            }} else if (error->state == {c("HEALING")}) {{
                error->state = {c("FAILED")};
            }} else {{
                /* as it is */
            }}
        }}
    """)


def _evaluate(error: Error, scope: Scope) -> Lines:
    p, name = scope.prefix, error.named.name
    place, counts = f"self->error.{name}", f"self->stored.{name}"
    heals = "false" if error.waits_for_restart else f"self->{error.reset_input}" if error.reset_input else "true"
    verdicts = [f"verdict = {p}_Worse(verdict, self->{cause.place});" for cause in error.causes]
    update = (
        f"{p}_Update(&{place}, &{counts}, verdict, {_dependencies(error, scope)}, {heals},\n"
        f"    {time(error.maturation)}, {time(error.reset)}, t);"
    )
    body = [
        lines(f"{p}_Verdict verdict = {scope.constant('NOT_JUDGED')};"),
        *(lines(verdict, error.named.pointer) for verdict in verdicts),
        lines(update),
        _sent(error, scope),
    ]
    head = f"static void {p}_Evaluate_{name}({scope.self_argument}, uint64_t t)"
    return function(head, body, error.named.comment)


def _dependencies(error: Error, scope: Scope) -> str:
    return _any_failed(error.dependencies, error.foreign, scope) or "false"


def _any_failed(own: tuple[str, ...], foreign: tuple[str, ...], scope: Scope) -> str:
    """The condition that any of some errors has failed."""
    known = {each.name: each for each in scope.plan.foreign_errors}
    conditions = [
        *(f"{scope.prefix}_HasFailed(&self->error.{name})" for name in own),
        *(f"(self->received.{name}.value == {known[name].failed}U)" for name in foreign),
    ]
    return " || ".join(conditions) if len(conditions) != 1 else conditions[0]


def _sent(error: Error, scope: Scope) -> Lines:
    """What is sent: with the first verdict and on change."""
    p, c, name = scope.prefix, scope.constant, error.named.name
    place, out = f"self->error.{name}", f"self->out.{name}"
    limits = [f"(self->stored.{name}.occurrences > 0U)"]
    if error.occurrence_limit:
        limits.append(f"(self->stored.{name}.occurrences >= {error.occurrence_limit}U)")
    if error.ignition_limit:
        limits.append(f"(self->stored.{name}.ignition_cycles >= {error.ignition_limit}U)")
    send = lines(f"""
        if (!{place}.is_sent || ({out} != status)) {{
            {out} = status;
            {place}.is_sent = true;
            self->publish.{name} = true;
        }}
    """)
    status = f"const {error.wire.c} status = {p}_HasFailed(&{place}) ? {error.failed}U : {error.passed}U;"
    is_known = f"({place}.state != {c('NOT_TESTED')}) && ({place}.state != {c('PREFAILED')})"
    confirmed = f"{place}.is_confirmed = {' && '.join(limits)};"
    return joined([lines(confirmed), block(f"if ({is_known})", [lines(status), send])])


def evaluated(errors: tuple[Error, ...], scope: Scope) -> Lines:
    """Errors evaluated, each after those that it depends on."""
    return joined(lines(f"{scope.prefix}_Evaluate_{error.named.name}(self, t);") for error in errors)


# -- safety reactions ---------------------------------------------------------------------------------------------


def reaction_functions(scope: Scope) -> list[Lines]:
    """What makes each reaction active."""
    return [_reaction(reaction, scope) for reaction in scope.plan.reactions]


def _reaction(reaction: Reaction, scope: Scope) -> Lines:
    p, name = scope.prefix, reaction.named.name
    received = f"self->received.{name}"
    outside = f"({received}.reception.is_there && ({received}.value == {reaction.active}U))"
    conditions = filter(None, (_any_failed(reaction.errors, reaction.foreign, scope), outside))
    late = _silent(reaction, scope)
    body = [
        lines(f"{'' if late else 'const '}bool is_active = {' || '.join(conditions)};"),
        late,
        lines(f"const {reaction.wire.c} status = is_active ? {reaction.active}U : {reaction.inactive}U;")
        if not late
        else lines(f"status = is_active ? {reaction.active}U : {reaction.inactive}U;"),
        lines(f"""
            if (self->out.{name} != status) {{
                self->out.{name} = status;
                self->publish.{name} = true;
            }}
        """),
    ]
    if late:
        body.insert(1, lines(f"{reaction.wire.c} status;"))
    time_argument = ", uint64_t t" if reaction.time_out is not None else ""
    head = f"static void {p}_Evaluate_{name}({scope.self_argument}{time_argument})"
    return function(head, body, reaction.named.comment)


def _silent(reaction: Reaction, scope: Scope) -> Lines:
    if reaction.time_out is None:
        return ()
    name = reaction.named.name
    late = f"{scope.prefix}_IsLate(&self->reaction.{name}, &self->received.{name}.reception, self->started, "
    return lines(f"""
        if ({late}{time(reaction.time_out)}, 1U, false, t)) {{
            is_active = true;
        }}
    """)


def reacted(call: str, scope: Scope) -> Lines:
    """Reactions that a call lists, evaluated and written to their variables."""
    found = []
    for reaction in scope.plan.reactions:
        if call in reaction.calls:
            time_argument = ", t" if reaction.time_out is not None else ""
            found.append(lines(f"{scope.prefix}_Evaluate_{reaction.named.name}(self{time_argument});"))
            if reaction.variable:
                target = scope.variable(reaction.variable)
                found.append(lines(f"{target} = self->out.{reaction.named.name};", reaction.named.pointer))
    return joined(found)
