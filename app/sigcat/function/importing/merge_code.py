"""Code that was generated again, merged into its function.yaml: what a person wrote stays."""

import re
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, SequenceNode

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Value
from sigcat.function.c_project.project import CodeProject, with_owners
from sigcat.function.c_project.read_project import read_project
from sigcat.function.declaration.declaration import Declaration, read_declaration
from sigcat.function.importing.added_entries import added, root_of
from sigcat.function.importing.function_text import Draft, said_of
from sigcat.function.importing.import_code import below, draft_of, shown
from sigcat.function.importing.object_names import with_object_names
from sigcat.function.importing.own_signals import checked_branch
from sigcat.function.importing.signals import Signal
from sigcat.function.importing.start_values import factor_of
from sigcat.function.importing.yaml_edits import (
    Edit,
    Text,
    edited,
    entries_of,
    items_of,
    runnables_of,
    text_of,
    value_at,
)
from sigcat.function.importing.yaml_text import comment, scalar
from sigcat.names import last_name, nearest

_PLAIN = re.compile(r"[A-Za-z_]\w*(?:\.\w+|\[\d+\])*", re.ASCII)
_MADE = re.compile(r"\s*# \S+\.(?:h|hh|hpp|hxx|c|cc|cpp|cxx):\d+\b")
"""A comment that the import wrote."""
_SIMILAR = 60.0
"""Least similarity of two names of a variable that was renamed, of 100."""
_BOM = "\ufeff"


class Merged(NamedTuple):
    """The text of a function.yaml after a merge, and a line for each change."""

    text: str
    report: tuple[str, ...]
    findings: tuple[Finding, ...]


class _Entry(NamedTuple):
    """An entry of `data` or `parameters` that names a variable."""

    runnable: Node
    """The call that has it."""
    kind: str
    listed: SequenceNode
    number: int
    node: MappingNode
    variable: str

    def text(self, key: str) -> str | None:
        """The text of one of its keys."""
        return text_of(value_at(self.node, key))

    @property
    def path(self) -> str:
        """Its path, or the last name of a parameter of the function."""
        return self.text("path") or ""


class _Known(NamedTuple):
    """The present code."""

    project: CodeProject
    values: Mapping[str, tuple[str, Value]]
    """Role and value, by the expression."""
    others: Mapping[str, Value]
    """Further values of the code, of which the calls do not tell the role."""

    def is_gone(self, variable: str) -> bool:
        """Whether the code has no such variable any more."""
        has_owner = not self.project.expressions.isdisjoint(with_owners(variable))
        return self._is_absent(variable) and (self.project.signature == "globals" or has_owner)

    def is_unknown(self, variable: str) -> bool:
        """Whether nothing of the code tells where a variable is or was, such as a member of an object that a person added."""
        return self._is_absent(variable) and not self.is_gone(variable)

    def _is_absent(self, variable: str) -> bool:
        """Whether the code names neither a variable nor an array, a union or a pointer that it is in."""
        is_part = not self.project.undivided.isdisjoint(with_owners(variable))
        return bool(_PLAIN.fullmatch(variable)) and not is_part and variable not in self.project.expressions


def merge_code(
    data: bytes,
    file: Path,
    folder: Path,
    catalogue: Catalogue,
    model: str = "",
    definitions: Sequence[str] = (),
    branch: str = "",
) -> Merged:
    """The function.yaml with the variables that the code in a folder has now. Raises UsageError, InputRefused."""
    if branch:
        checked_branch(branch, catalogue)
    declared = read_declaration(data, str(file))
    if declared.declaration is None:
        raise InputRefused(f"{file} cannot be updated: it has errors.", declared.findings)
    declaration = declared.declaration
    project = read_project(folder, declaration.function, model, definitions or _definitions(declaration))
    if project.is_broken:
        raise InputRefused(f"{file} cannot be updated: the code does not compile.", shown(project, folder))
    project = with_object_names(project, declaration.code.objects if declaration.code else ())
    known = _Known(project, _values(project), {each.expression: each for each in project.others if not each.problem})
    text = data.decode("utf-8").removeprefix(_BOM).replace("\r\n", "\n")
    text, renamed = _with_new_names(text, known, set(_variables(declared.document.value)))
    text, gone = _without_gone(text, known)
    text, changed = _with_changes(text, known, catalogue, below(folder, file.parent))
    new = _new(project, {*_variables(declared.document.value), *renamed.values()})
    draft = draft_of(declaration.function, new, folder, file.parent, catalogue, "", branch, *_taken(declaration))
    text = _in_place(added(text, draft), draft)
    if b"\r\n" in data:
        text = text.replace("\n", "\r\n")
    merged = read_declaration(text.encode(), str(file))
    if merged.declaration is None:
        raise InputRefused(f"{file} cannot be updated: what it would become has errors.", merged.findings)
    names = (f"renamed: {before} → {now}; check that it is the same signal" for before, now in renamed.items())
    report = (*names, *gone, *changed, *_new_entries(draft), *_calls_and_sources(declaration, project, draft))
    return Merged(text, report, shown(project, folder))


def _definitions(declaration: Declaration) -> list[str]:
    given = declaration.code.definitions if declaration.code else {}
    return [name if value is None else f"{name}={value}" for name, value in given.items()]


def _values(project: CodeProject) -> dict[str, tuple[str, Value]]:
    interface = project.interface
    roles = (("consumed", interface.inputs), ("provided", interface.outputs), ("parameter", interface.parameters))
    return {value.expression: (role, value) for role, values in roles for value in values if not value.problem}


def _new(project: CodeProject, variables: AbstractSet[str]) -> CodeProject:
    """The project with those values alone that the file does not name, by themselves, by their parts, or as members of a struct."""
    whole, named = project.interface, "\n".join(sorted(variables))

    def is_new(value: Value) -> bool:
        parts = rf"(?<![\w.>]){re.escape(value.expression)}(?!\w)"
        return variables.isdisjoint(with_owners(value.expression)) and not re.search(parts, named)

    inputs, outputs, parameters = (
        tuple(value for value in values if is_new(value)) for values in (whole.inputs, whole.outputs, whole.parameters)
    )
    return project._replace(interface=whole._replace(inputs=inputs, outputs=outputs, parameters=parameters))


def _variables(value: Any) -> Iterator[str]:
    """Every variable that a file names, whatever it holds."""
    if isinstance(value, dict):
        for key, each in value.items():
            if isinstance(each, str) and str(key).lower().endswith("variable"):
                yield each
            yield from _variables(each)
    elif isinstance(value, list):
        for each in value:
            yield from _variables(each)


def _taken(declaration: Declaration) -> tuple[frozenset[str], frozenset[str]]:
    """Paths of the file's signals and last names of its parameters."""
    runnables = [call for component in declaration.components for call in component.runnables]
    paths = {item.path for call in runnables for item in call.data}
    names = {last_name(item.path) for call in runnables for item in call.parameters}
    define = declaration.define
    return frozenset(paths), frozenset({*names, *(define.parameters if define else ())})


# -- entries ------------------------------------------------------------------------------------------------------


def _entries(root: Node | None) -> Iterator[_Entry]:
    for runnable in runnables_of(root):
        for kind in ("data", "parameters"):
            listed = value_at(runnable, kind)
            for index, node in enumerate(items_of(listed)):
                variable = text_of(value_at(node, "variable"))
                if variable and isinstance(node, MappingNode) and isinstance(listed, SequenceNode):
                    yield _Entry(runnable, kind, listed, index, node, variable)


def _with_new_names(text: str, known: _Known, variables: AbstractSet[str]) -> tuple[str, Mapping[str, str]]:
    """With the present names of variables that were renamed: one is gone, and one is new with a similar name, the same role, type and comment."""
    whole, edits, names = Text(text), list[Edit](), dict[str, str]()
    gone = [each for each in _entries(root_of(text)) if each.kind == "data" and known.is_gone(each.variable)]
    fresh = _new(known.project, variables).interface
    by_role = {"consumed": fresh.inputs, "provided": fresh.outputs}
    for entry in gone:
        role, told = entry.text("role") or "", _remark_above(entry, whole)
        alike = [value for value in by_role.get(role, ()) if told and _said(value) == told]
        rivals = [other for other in gone if _remark_above(other, whole) == told]
        if len(alike) == len(rivals) == 1 and nearest(entry.variable, [alike[0].expression], cutoff=_SIMILAR):
            edits += whole.set_value(entry.node, "variable", alike[0].expression, "variable")
            names[entry.variable] = alike[0].expression
    return edited(text, edits), names


def _remark_above(entry: _Entry, whole: Text) -> str:
    """Type and remark in the comment that the import wrote above an entry; empty if there is none."""
    made = (line for _, line in whole.comments_above(entry.node) if _MADE.match(line))
    return next((_MADE.sub("", line).strip() for line in made), "")


def _said(value: Value) -> str:
    """Type and remark of a value as the import writes them."""
    return next(said_of(Signal(value, "consumed", "", ""), "")).partition(" ")[2]


def _without_gone(text: str, known: _Known) -> tuple[str, tuple[str, ...]]:
    """Without the entries of variables that are gone, one after the other: each moves those behind it."""
    report: list[str] = []
    while found := next((each for each in _entries(root_of(text)) if known.is_gone(each.variable)), None):
        report.append(f"gone: {found.variable} ({found.path})")
        text = _without(text, found)
    return text, tuple(report)


def _without(text: str, entry: _Entry) -> str:
    whole, root, path = Text(text), root_of(text), entry.path
    if len(entry.listed.value) > 1 or entry.listed.flow_style:
        text = edited(text, [whole.without_item(entry.listed, entry.number)])
    else:  # the key goes with its only item
        text = edited(text, [whole.without_key(entry.runnable, entry.kind)])
    defined = value_at(root, "define", entry.kind)
    is_used = any(each.path == path for each in _entries(root_of(text)))
    return _without_definition(text, entry.kind, path) if path in entries_of(defined) and not is_used else text


def _without_definition(text: str, kind: str, name: str) -> str:
    """Remove a definition that nothing refers to any more."""
    root = root_of(text)
    define = value_at(root, "define")
    definitions = value_at(define, kind)
    assert root is not None
    assert define is not None
    assert definitions is not None
    whole = Text(text)
    if len(entries_of(definitions)) > 1:
        return edited(text, [whole.without_key(definitions, name)])
    if len(entries_of(define)) > 1:
        return edited(text, [whole.without_key(define, kind)])
    return edited(text, [whole.without_key(root, "define")])


# -- changes ------------------------------------------------------------------------------------------------------


def _with_changes(text: str, known: _Known, catalogue: Catalogue, folder: str) -> tuple[str, tuple[str, ...]]:
    root, whole = root_of(text), Text(text)
    edits: list[Edit] = []
    report: list[str] = []
    for entry in _entries(root):
        role, value = known.values.get(entry.variable, ("", known.others.get(entry.variable)))
        if value is None:
            if known.is_unknown(entry.variable):
                report.append(f"kept: {entry.variable} is not in the code; remove it by hand")
            continue
        if role and (role == "parameter") != (entry.kind == "parameters"):
            report.append(f"kept: {entry.variable} is {role} in the code; move it by hand")
            continue
        changes = _changes(entry, role, value, root, catalogue)
        for node, key, before, now in changes:
            edits += whole.set_value(node, key, now, "variable" if node is entry.node else "datatype")
            report.append(f"changed: {entry.variable}: {key} {_word(before)} → {_word(now)}")
        report += _kept(entry, value, root, catalogue)
        edits += _comment(entry, value, whole, folder)
    for name, node, key, before, now in _objects(root, known.project):
        edits += whole.set_value(node, key, now, "type")
        report.append(f"changed: {name}: {key} {_word(before)} → {_word(now)}")
    return edited(text, edits), tuple(dict.fromkeys(report))


def _objects(root: Node | None, project: CodeProject) -> Iterator[tuple[str, Node, str, Any, Any]]:
    """Differences in types and lengths of objects."""
    known = {each.name: each for each in project.interface.objects}
    for node in items_of(value_at(root, "code", "objects")):
        name = text_of(value_at(node, "name")) or ""
        if name in known:
            for key, now in (("type", known[name].type), ("length", known[name].length or None)):
                before = text_of(value_at(node, key))
                if before != (None if now is None else str(now)):
                    yield name, node, key, before, now


_Change = tuple[Node, str, Any, Any]
"""The mapping, its key, and the value before and now."""


def _changes(entry: _Entry, role: str, value: Value, root: Node | None, catalogue: Catalogue) -> Iterator[_Change]:
    """Differences in types and scales, where the code decides."""
    if role:
        yield from _role(entry, role, value)
    is_scaled = value.datatype not in ("float", "double", "boolean")
    for key, number in (("factor", value.remark.factor), ("offset", value.remark.offset)):
        given = entry.text(key)
        if is_scaled and number is not None and (given is None or float(given) != number):
            yield entry.node, key, given, number
    yield from _datatypes(entry, value, root, catalogue)
    yield from _numbers(entry, value, root)


def _role(entry: _Entry, role: str, value: Value) -> Iterator[_Change]:
    """Differences in what the calls and the linked files decide."""
    if entry.kind == "data" and entry.text("role") != role:
        yield entry.node, "role", entry.text("role"), role
    derived = {"definedBy": "adapter" if value.defined_by == "adapter" else None, "cType": value.c_type or None}
    for key, now in derived.items():
        before = entry.text(key)
        if before != now and not (key == "definedBy" and before == "function" and now is None):
            yield entry.node, key, before, now


def _datatypes(entry: _Entry, value: Value, root: Node | None, catalogue: Catalogue) -> Iterator[_Change]:
    """Differences in the datatype of the entry, or of the definition in the file."""
    now = f"{value.datatype}{'[]' if value.length else ''}"
    defined, before = value_at(root, "define", entry.kind, entry.path), entry.text("datatype")
    is_enumeration = value_at(defined, "allowed") is not None
    if before is not None and before != now:
        yield entry.node, "datatype", before, now
    elif before is None and defined is None and (known := _of_catalogue(entry.path, catalogue)) not in ("", now):
        yield entry.node, "datatype", known, now
    if defined is None or is_enumeration:
        return
    own = text_of(value_at(defined, "datatype"))
    if factor_of(value) is None and own == (before or own) and own != now:
        yield defined, "datatype", own, now
    length = text_of(value_at(defined, "arraysize"))
    if (length or "0") != str(value.length):
        yield defined, "arraysize", length, value.length or None


def _of_catalogue(path: str, catalogue: Catalogue) -> str:
    """The datatype of a signal; empty where there is none, or it is an enumeration."""
    node = catalogue.get(path)
    return str(node.values.get("datatype") or "") if node and not node.values.get("allowed") else ""


def _numbers(entry: _Entry, value: Value, root: Node | None) -> Iterator[_Change]:
    """Numbers of an enumeration, by its own names or those of the catalogue, which end its own."""
    node, own = entry.node, {each.name: each.value for each in value.constants}
    before = {key: text_of(each) for key, (_, each) in entries_of(value_at(node, "values")).items()}
    found = {key: _number(key, value) for key in before}
    renamed = {key: found[key] if found[key] is not None else int(number or 0) for key, number in before.items()}
    defined = value_at(root, "define", entry.kind, entry.path)
    allowed = [text_of(each) for each in items_of(value_at(defined, "allowed"))]
    has_own_names = own.keys() >= before.keys() and allowed == list(before)
    now = own if has_own_names else renamed
    if has_own_names and list(own) != allowed and defined is not None:
        yield defined, "allowed", allowed, list(own)
    if value.constants and {key: str(number) for key, number in now.items()} != before:
        yield node, "values", before, now


def _number(name: str, value: Value) -> int | None:
    plain = re.sub(r"[\W_]", "", name).lower()
    return next(
        (each.value for each in value.constants if re.sub(r"[\W_]", "", each.name).lower().endswith(plain)), None
    )


def _kept(entry: _Entry, value: Value, root: Node | None, catalogue: Catalogue) -> Iterator[str]:
    """Ranges that a person may have chosen, and the lengths of signals that the file does not define."""
    node = catalogue.get(entry.path)
    if node is not None and value_at(root, "define", entry.kind, entry.path) is None:
        length = node.values.get("arraysize")
        if length is not None and length != value.length:
            count = f"{length} elements; the code has {value.length or 'one value'}"
            yield f"kept: {entry.variable}: {entry.path} has {count}"
    for key, now in (("min", value.remark.min), ("max", value.remark.max)):
        given = entry.text(key)
        if now is not None and given is not None and float(given) != now:
            yield f"kept: {entry.variable}: {key} {given}; the code has {now:g}"


def _comment(entry: _Entry, value: Value, whole: Text, folder: str) -> Iterator[Edit]:
    """The line that the import wrote, with the line of the code where the variable is now."""
    made = [(at, line) for at, line in whole.comments_above(entry.node) if _MADE.match(line)]
    for at, line in made if entry.kind == "data" else ():
        now = comment(len(line) - len(line.lstrip()), next(said_of(Signal(value, "consumed", "", ""), folder)))
        if now != line:
            yield Edit(at, at + len(line), now)


def _word(value: Any) -> str:
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key}: {each}' for key, each in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(str, value))}]"
    return "none" if value is None else str(value)


# -- the report ---------------------------------------------------------------------------------------------------


def _in_place(text: str, draft: Draft) -> str:
    """Comments that name lines of calls and objects, with the lines where they are now."""
    project = draft.project
    for each in (*((call.symbol, call.place) for call in project.calls),
                 *((one.name, one.place) for one in project.interface.objects)):  # fmt: skip
        name, place = re.escape(scalar(each[0])), each[1]
        now = f"{Path(draft.folder, place.file).as_posix()}:{place.line}"
        text = re.sub(rf"^(.*\b(?:symbol|name): {name}\b.*  # )\S+:\d+$", rf"\g<1>{now}", text, flags=re.MULTILINE)
    return text


def _new_entries(draft: Draft) -> Iterator[str]:
    yield from (f"new: {each.value.expression} ({each.path})" for each in draft.signals)
    yield from (f"new: {each.value.expression} ({each.keys['path']})" for each in draft.parameters)


def _calls_and_sources(declaration: Declaration, project: CodeProject, draft: Draft) -> Iterator[str]:
    """Calls and sources that the file does not name: a person adds them."""
    known = {call.symbol or call.interface for each in declaration.components for call in each.runnables}
    for call in project.calls:
        if call.symbol not in known:
            yield f"kept: the call {call.symbol} is not in the file"
    objects = {each.name for each in (declaration.code.objects if declaration.code else ())}
    yield from (
        f"kept: the object {each.name} is not among `objects`; add it with type {each.type}"
        + (f" and length {each.length}" if each.length else "")
        for each in project.interface.objects
        if each.name not in objects
    )
    listed = {Path(each).as_posix() for each in (declaration.code.sources if declaration.code else ())}
    for source in project.sources:
        path = Path(draft.folder, source).as_posix()
        if path not in listed:
            yield f"kept: the source {path} is not among `sources`"
