"""The code of a function, as the declaration describes it: the catalogue has nothing of it."""

from collections.abc import Mapping

from sigcat.function.declaration.code_section import CheckpointItem, CodeSection, ObjectItem
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import Checkpoint, CodeInterface, CodeObject, Macro, Member
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.part import Part, listed, written


def code_interface(item: CodeSection, at: Pointer) -> Part[CodeInterface]:
    """Compilation and calls of the code."""
    made = CodeInterface(
        signature=word(item.signature) or "",
        sources=tuple(item.sources) or None,
        headers=tuple(item.headers) or None,
        include_folders=tuple(item.include_folders) or None,
        definitions=tuple(Macro(name=name, value=_text(value)) for name, value in item.definitions.items()) or None,
        class_name=item.class_name,
        storage=item.storage,
        accessors=tuple(item.accessors) or None,
        objects=tuple(map(_object, item.objects)) or None,
    )
    return Part(made, Origin(at, {**written(item, at), "Objects": listed(item.objects, (*at, "objects"))}))


def _object(item: ObjectItem) -> CodeObject:
    return CodeObject(
        name=item.name, type=item.type, length=item.length, member=item.member, defined_by=word(item.defined_by)
    )


def _text(value: str | int | None) -> str | None:
    return None if value is None else str(value)


def word(text: str | None) -> str | None:
    """A word of the declaration as Function JSON spells it: `adapter` → `Adapter`."""
    return text[:1].upper() + text[1:] if text else None


def members(given: Mapping[str, str] | None) -> tuple[Member, ...] | None:
    """Members of a struct with their names in C."""
    return tuple(Member(name=name, member=member) for name, member in (given or {}).items()) or None


def checkpoint(item: CheckpointItem | None, context: Context) -> Checkpoint | None:
    """Place of a call in the graph; whether the calls that follow exist is checked with the result."""
    if item is None:
        return None
    following = tuple(context.call_name(reference) for reference in item.next)
    return Checkpoint(initial=item.initial, final=item.final, next=following or None)
