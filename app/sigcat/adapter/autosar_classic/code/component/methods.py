"""Methods that the function offers: a server runnable for each."""

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component.rte_values import Copy
from sigcat.adapter.autosar_classic.code.names import core_object
from sigcat.adapter.autosar_classic.code.plan import MethodEnd, RteType, SwcPlan
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable


def argument(type_: RteType, name: str, *, is_out: bool) -> str:
    """An argument of an operation: numbers by value, what is large or filled by its address."""
    if type_.element is not None:
        return f"{'' if is_out else 'const '}{type_.element.name} *{name}"
    if type_.members or is_out:
        return f"{'' if is_out else 'const '}{type_.name} *{name}"
    return f"{type_.name} {name}"


def head(runnable: Runnable, end: MethodEnd) -> str:
    """Signature of a server runnable."""
    given = [argument(each.type, f"given_{each.name}", is_out=False) for each in end.arguments]
    taken = [argument(each.type, f"taken_{each.name}", is_out=True) for each in end.results]
    return f"Std_ReturnType {runnable.symbol}({', '.join((*given, *taken)) or 'void'})"


def end_of(runnable: Runnable, swc: SwcPlan) -> MethodEnd:
    """The method of a runnable."""
    return next(each for each in swc.methods if runnable.method in each.columns)


def offered(runnable: Runnable, swc: SwcPlan) -> Lines:
    """The answer to a request: what the core says, as an application error."""
    end = end_of(runnable, swc)
    to_core, from_core = Copy(swc.core, to_core=True), Copy(swc.core, to_core=False)
    arguments = [
        row for each in end.arguments
        for row in to_core.of(f"arguments.{each.place}", _read(each.type, f"given_{each.name}"), each.type, each.wire.c)
    ]  # fmt: skip
    results = [
        row for each in end.results
        for row in from_core.of(_written(each.type, f"taken_{each.name}"), f"results.{each.place}", each.type, each.wire.c)
    ]  # fmt: skip
    return c_lines(
        "code/component/method.c.j2",
        swc=swc,
        core=core_object(swc),
        macro=Scope(swc.core).macro,
        end=end,
        head=head(runnable, end),
        comment=runnable.description or end.method.named.comment,
        arguments=arguments,
        results=results,
        excluded=_error(end, "EXCLUDED"),
        bad_argument=_error(end, "BAD_ARGUMENT"),
    )


def _error(end: MethodEnd, what: str) -> str:
    """The application error for a reply; of an operation without its own error the standard one."""
    wanted = what.replace("_", "").lower()
    name = next((each for each in end.errors if each.replace("_", "").lower().endswith(wanted)), None)
    name = name or next(iter(end.errors), None)
    return f"RTE_E_{end.interface}_{name}" if name else "RTE_E_INVALID"


def _read(type_: RteType, name: str) -> str:
    return f"(*{name})" if type_.is_struct else name


def _written(type_: RteType, name: str) -> str:
    return name if type_.is_array else f"(*{name})"
