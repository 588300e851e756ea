"""Names and forms in the generated C++."""

from collections.abc import Iterable

from sigcat.adapter.autosar_adaptive.application.plan import (
    ApplicationPlan,
    ComponentPlan,
    Provided,
    Required,
    SentField,
)
from sigcat.adapter.core.c.lines import Line, Lines, indented, joined, lines, spaced
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.plan import GLOBALS, Call, Error
from sigcat.function.document.text_filters import AnyText, comment, comment_rows
from sigcat.names import screaming_snake_case

LOCK = "const std::lock_guard<std::mutex> lock{core_mutex_};"
"""For what calls the core, until the end of the scope."""
_COMMENT = 113
"""Columns of a comment."""


def include_guard(application: ApplicationPlan, component: ComponentPlan, header: str) -> str:
    """The include guard of a header, unlike that of the core."""
    return f"{screaming_snake_case('_'.join((*application.namespace, component.stem, header)))}_H"


def in_namespace(application: ApplicationPlan, parts: Iterable[Lines]) -> Lines:
    """Parts in the namespace of the application, as C++14 writes it."""
    opens = lines("\n".join(f"namespace {name} {{" for name in application.namespace))
    closes = lines("\n".join(f"}}  // namespace {comment(name)}" for name in reversed(application.namespace)))
    return spaced([opens, *parts, closes])


def services_of(component: ComponentPlan) -> tuple[Required | Provided, ...]:
    """Services that it uses and offers."""
    return (*component.required, *component.provided)


def core_holder(component: ComponentPlan) -> str:
    """The member that is the core, or refers to the one instance of it."""
    prefix = component.core.type_name
    if component.core.code.signature == GLOBALS:
        return f"{prefix}& core_{{{prefix}_Instance}}"
    return f"{prefix} core_{{}}"


def monitor_name(error: Error) -> str:
    """The member that tells the diagnosis of an error."""
    return f"monitor_{error.named.name}_"


def sent_name(field: SentField) -> str:
    """The member that has what was sent last of a field."""
    return f"sent_{field.place}_"


def repeating(component: ComponentPlan) -> set[str]:
    """Calls that send states again when they end."""
    return {field.repeated_by for service in component.provided for field in service.fields if field.repeated_by}


def watch_name(component: ComponentPlan, call: Call) -> str:
    """The member that watches the deadlines of a call: one call at a time."""
    return f"watch_{_thread(component, call)}_" if component.is_threaded else "watch_"


def _thread(component: ComponentPlan, call: Call) -> int:
    return next(number for number, thread in enumerate(component.threads) if call in thread.calls)


def call_mutex(component: ComponentPlan) -> str:
    """The type of the mutex that separates methods and calls."""
    return "application::CallMutex" if component.is_threaded else "std::mutex"


def alone(component: ComponentPlan) -> str:
    """The statement before what no call may run beside, until the end of the scope."""
    return f"const std::lock_guard<{call_mutex(component)}> call{{call_mutex_}};"


def watched(component: ComponentPlan) -> dict[str, Call]:
    """Watches of deadlines, each with one of its calls."""
    return {watch_name(component, step): step for step in component.core.steps if step.deadline}


def braces(parts: Iterable[Lines]) -> Lines:
    """Statements in a scope of their own."""
    return (Line("{"), *indented(joined(parts)), Line("}"))


def locked(text: str) -> Lines:
    """Statements under the lock of the core."""
    return braces([lines(f"{LOCK}\n{text}")])


def checkpoint(call: str) -> str:
    """The constant of a call among the checkpoints."""
    return f"k{identifier(call)}"


def cpp_type(name: str) -> str:
    """A type, from any namespace."""
    return f"::{name}" if "::" in name and not name.startswith("std::") else name


def commented(text: AnyText) -> Lines:
    """A comment, on as many lines as it needs."""
    return tuple(map(Line, comment_rows(text, "//", _COMMENT)))


def without_indent(part: Lines) -> Lines:
    """Lines of a class whose access specifiers stand where the class does."""
    return tuple(
        line._replace(text=line.text.strip()) if line.text.strip() in ("public:", "private:") else line for line in part
    )


def writes(component: ComponentPlan) -> bool:
    """Whether there is anything to write."""
    return bool(component.monitors) or any(each.learned is not None for each in component.core.parameters)
