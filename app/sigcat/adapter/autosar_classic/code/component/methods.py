"""Methods that the function offers: a server runnable for each."""

from sigcat.adapter.autosar_classic.code.component.rte_values import component_lines
from sigcat.adapter.autosar_classic.code.plan import MethodEnd, RteType, SwcPlan
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable


def argument(type_: RteType, name: str, *, is_out: bool) -> str:
    """An argument of an operation: numbers by value, what is large or filled by its address."""
    if type_.is_number and not is_out:
        return f"{type_.name} {name}"
    return f"{'' if is_out else 'const '}{type_.pointed} *{name}"


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
    return component_lines(
        "method.c.j2",
        swc,
        end=end,
        head=head(runnable, end),
        comment=runnable.description or end.method.named.comment,
        excluded=_error(end, "EXCLUDED"),
        bad_argument=_error(end, "BAD_ARGUMENT"),
    )


def _error(end: MethodEnd, what: str) -> str:
    """The application error for a reply; of an operation without its own error the standard one."""
    wanted = what.replace("_", "").lower()
    name = next((each for each in end.errors if each.replace("_", "").lower().endswith(wanted)), None)
    name = name or next(iter(end.errors), None)
    return f"RTE_E_{end.interface}_{name}" if name else "RTE_E_INVALID"
