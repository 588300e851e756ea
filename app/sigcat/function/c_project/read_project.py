"""Read a folder of C or C++ code to the description of one model."""

import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sigcat import codes
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding, in_order
from sigcat.function.c_project.classes import class_interface
from sigcat.function.c_project.code_values import Code, values_of
from sigcat.function.c_project.comments import Comments
from sigcat.function.c_project.declarations import CFunction, CompilerError, Declarations, Variable
from sigcat.function.c_project.files import CodeFiles, is_header, read_folder
from sigcat.function.c_project.found_calls import CallKind, Group, find_calls, main_files, reachable, use_of
from sigcat.function.c_project.globals import global_interface
from sigcat.function.c_project.parsing import missing_includes, parse, syntax_error
from sigcat.function.c_project.pointers import pointer_interface, takes_pointers
from sigcat.function.c_project.project import Call, CodeProject, Interface, Signature, with_owners
from sigcat.function.c_project.remarks import cycle_time_of
from sigcat.function.c_project.usable import usable

_STEP_SIZE = re.compile(r"\bTiming\s*\.\s*stepSize0?\s*=\s*(?P<time>[0-9.]+(?:[eE][-+]?[0-9]+)?)")
_DEFINITION = re.compile(r"[A-Za-z_]\w*(?:=[^\0\n]*)?", re.ASCII)
_TITLE: Mapping[str, str] = {
    "model": r"Code generat(?:ed for Simulink|ion for) model\s*[\"']?(?P<text>[^\"'\n.]+)",
    "version": r"Model version\s*:\s*(?P<text>[^\n]+)",
    "tool": r"Simulink Coder version\s*:\s*(?P<text>[^\n]+)",
}


def read_project(folder: Path, function: str, model: str = "", definitions: Sequence[str] = ()) -> CodeProject:
    """The description of the model in a folder; of several, the one that is named. Raises UsageError, InputRefused.

    `definitions` are for the preprocessor, `NAME` or `NAME=VALUE`.
    """
    for definition in definitions:
        if not _DEFINITION.fullmatch(definition):
            raise UsageError(f"A definition of the preprocessor must be NAME or NAME=VALUE, not {definition!r}")
    if not folder.is_dir():
        raise UsageError(_no_folder(folder))
    files = read_folder(folder)._replace(definitions=tuple(definitions))
    if not any(map(is_header, files.texts)):
        message = "The folder must have headers of C or C++ (.h, .hpp)."
        fix = "Name the folder that the code was generated into."
        finding = codes.CODE_MISSING.finding(message, str(folder), fix=fix)
        raise InputRefused("the code cannot be imported", (*files.findings, finding))
    parsed = parse(files)
    code = Code(parsed.declarations, {path: Comments(text) for path, text in files.texts.items()})
    group = find_calls(parsed.declarations, model, function, str(folder), code.heading)
    return _project(files, code, group, parsed.machine)._replace(folder=folder)


def _no_folder(folder: Path) -> str:
    if not folder.exists():
        return f"{folder}: there is no such folder"
    return f"{folder} must be the folder with the headers of the code, not a file: use --from-c {shlex.quote(str(folder.parent))}"


def _project(files: CodeFiles, code: Code, group: Group, machine: str) -> CodeProject:
    declarations = code.declarations
    linked = _linked(group, declarations, files)
    signature, whole = _interface(group, code, frozenset(linked))
    interface, left_out = usable(whole, declarations)
    variables = declarations.variables if signature == "globals" else ()
    values = (value for each in variables for value in values_of(each.name, each.type, each.place, code))
    others = (*interface.others, *values)
    header = group.steps[0].place.file
    needed = {header, *linked, *(path for each in (header, *linked) for path in declarations.all_included(each))}
    missing = [each for each in missing_includes(declarations) if each.file in needed]
    findings = [*files.findings, *missing, *interface.findings, *left_out, *_empty(interface, group)]
    findings += _undefined(whole, group, declarations, frozenset(linked))
    broken = syntax_error(declarations.errors, needed)
    return CodeProject(
        model=group.name,
        signature=signature,
        calls=tuple(_calls(group, interface, code, files)),
        interface=interface,
        class_name=group.owner.name if group.owner else "",
        sources=tuple(linked),
        headers=tuple(_headers(group, interface, declarations)),
        include_folders=tuple(_include_folders(linked, header, declarations)),
        definitions=files.definitions,
        machine=machine,
        title=_title(files.texts.get(header, "")),
        expressions=frozenset(owner for value in (*whole.values, *others) for owner in with_owners(value.expression)),
        undivided=frozenset(each.expression for each in (*whole.values, *others) if each.length or each.problem),
        others=others,
        left_out=tuple(_left_out(group, code.declarations)),
        findings=in_order([*findings, *_word_size(machine, declarations), *((_broken(broken),) if broken else ())]),
        is_broken=broken is not None,
    )


def _interface(group: Group, code: Code, linked: frozenset[str]) -> tuple[Signature, Interface]:
    if group.owner:
        return "class", class_interface(group, code)
    if takes_pointers(group):
        found = pointer_interface(group, code)
        return ("pointers" if found.objects else "globals"), found
    return "globals", global_interface(group, code, linked)


def _left_out(group: Group, declarations: Declarations) -> Iterator[CFunction]:
    """Public functions that are neither calls nor called by them, without those that give or take members."""
    known = reachable(group.full_names, declarations)
    header = group.steps[0].place.file
    found = group.owner.methods if group.owner else declarations.functions
    beside = [each for each in found if each.place.file == header and each.public and not each.is_static]
    for each in {one.name: one for one in beside}.values():
        is_new = each not in group.functions and group.full_name(each) not in known
        if is_new and is_header(header) and not _ACCESSOR.match(each.name):
            yield each


_ACCESSOR = re.compile(r"(?:get|set)[A-Z_]|operator\b|~|main$")


# -- calls --------------------------------------------------------------------------------------------------------


def _calls(group: Group, interface: Interface, code: Code, files: CodeFiles) -> Iterator[Call]:
    is_only = len(group.steps) == 1
    for function in group.functions:
        kind: CallKind = "init" if function is group.init else "terminate" if function is group.terminate else "step"
        time = _cycle_time(function, code, files, is_only=is_only) if kind == "step" else None
        arguments = interface.arguments.get(function.name, ())
        returns = function.result.kind in ("number", "enumeration")
        use = use_of([group.full_name(function)], code.declarations)
        yield Call(kind, function.name, function.place, arguments, time, returns, use)


def _cycle_time(function: CFunction, code: Code, files: CodeFiles, *, is_only: bool) -> float | int | None:
    """As comments at the function say it, its name, or the code that initializes the model."""
    same = (each.place for each in code.declarations.functions if each.name == function.name and each.place.file)
    for place in dict.fromkeys((function.place, *same)):
        comments = code.comments[place.file]
        for comment in (comments.beside(place.line), comments.above(place.line)):
            if (found := cycle_time_of(comment)) is not None:
                return found
    if (found := _named_time(function.name)) is not None:
        return found
    return (_step_size(files) or _told_by_examples(code)) if is_only else None


def _named_time(name: str) -> float | int | None:
    """Return the time in a name: 10 for `X_step_10ms`, 1 for `Trigger_1kHz`."""
    named = re.search(r"(?:_|[a-z])(\d+)(ms|us|s)$", name)
    rate = re.search(r"(?:_|[a-z])(\d+)(k?)hz$", name, re.IGNORECASE)
    if rate and int(rate[1]):
        return cycle_time_of(f"Sample time: {1 / int(rate[1]) / (1000 if rate[2] else 1):.12f}")
    return cycle_time_of(f"every {named[1]} {named[2]}") if named else None


def _told_by_examples(code: Code) -> float | int | None:
    """The one time that the comments of the example program tell."""
    comments = (each for file in main_files(code.declarations) for each in code.comments[file].all())
    found = {cycle_time_of(each.text) for each in comments} - {None}
    return found.pop() if len(found) == 1 else None


def _step_size(files: CodeFiles) -> float | int | None:
    found = {match["time"] for text in files.texts.values() for match in _STEP_SIZE.finditer(text)}
    return cycle_time_of(f"Sample time: {found.pop()}") if len(found) == 1 else None


# -- files --------------------------------------------------------------------------------------------------------


def _linked(group: Group, declarations: Declarations, files: CodeFiles) -> list[str]:
    """The sources that the calls need: those that define what they use. Of copies, that beside the header."""
    names = reachable(group.full_names, declarations)
    home = Path(group.steps[0].place.file).parent.as_posix()
    examples = main_files(declarations)
    defining: dict[str, str] = {}
    for each in declarations.named:
        file = each.place.file
        if each.is_defined and not each.is_static and each.name in names and file not in examples:
            defining[each.name] = min(file, defining.get(each.name, file), key=lambda path: _distance(path, home))
    return [path for path in files.sources if path in defining.values()]


def _distance(path: str, home: str) -> tuple[bool, int, str]:
    folder = Path(path).parent.as_posix()
    return (folder != home, path.count("/"), path)


def _headers(group: Group, interface: Interface, declarations: Declarations) -> Iterator[str]:
    """Headers that declare the calls and the values, without those that these include."""
    places = [each.place.file for each in group.functions]
    if not group.owner and not interface.arguments:
        places += [each.place.file for each in _declared_values(interface, declarations)]
    wanted = [path for path in dict.fromkeys(places) if is_header(path)]
    within = {each for path in wanted for each in declarations.all_included(path) if each != path}
    yield from (path for path in wanted if path not in within)


def _declared_values(interface: Interface, declarations: Declarations) -> list[Variable]:
    names = {re.split(r"[.\[]", each.expression)[0] for each in interface.values}
    return [each for each in declarations.variables if each.name in names and not each.is_defined]


def _include_folders(linked: list[str], header: str, declarations: Declarations) -> Iterator[str]:
    """Folders of headers that the sources include."""
    included = {each for path in linked for each in declarations.all_included(path)}
    yield from dict.fromkeys(Path(each).parent.as_posix() for each in (header, *sorted(included)))


def _title(text: str) -> dict[str, str]:
    head = text[:4000]
    found = {name: re.search(pattern, head) for name, pattern in _TITLE.items()}
    return {name: match["text"].strip() for name, match in found.items() if match}


# -- findings -----------------------------------------------------------------------------------------------------


def _empty(interface: Interface, group: Group) -> Iterator[Finding]:
    if not interface.inputs and not interface.outputs:
        step = group.steps[0]
        message = f"{step.name!r} must read or write something to be connected; no input and no output was found."
        fix = "List them in the function.yaml, if it has any."
        yield codes.INTERFACE_EMPTY.finding(message, *step.place, fix=fix)


def _undefined(
    interface: Interface, group: Group, declarations: Declarations, linked: frozenset[str]
) -> Iterator[Finding]:
    """Report variables that the sources use, and neither the function nor its adapter defines."""
    used = use_of(group.full_names, declarations).used if linked else frozenset()
    known = {re.split(r"[.\[(]", value.expression)[0] for value in interface.values}
    known |= {each.name for each in declarations.variables if each.is_defined and each.place.file in linked}
    lacking = {
        each.name: each for each in declarations.variables if each.name in used - known and "::" not in each.name
    }
    for variable in list(lacking.values())[:1]:
        more = f" and {len(lacking) - 1:,} more" if len(lacking) > 1 else ""
        message = f"{variable.name!r}{more} must be defined: the sources use it, but it is in none of them, and no input or output."
        fix = "Import the folder with the source that defines it, or define it in your own source."
        yield codes.VARIABLE_UNDEFINED.finding(message, *variable.place, fix=fix)


def _broken(error: CompilerError) -> Finding:
    message = f"The code must compile to be read right; clang says: {error.message[:200]}."
    return codes.CODE_INVALID.finding(message, *error.place, error.column, fix="Correct the code.")


def _word_size(machine: str, declarations: Declarations) -> Iterator[Finding]:
    refusals = [error for error in declarations.errors if error.is_own]
    if machine:
        message = f"The code checks the sizes of words and refuses a machine with a long of 64 bit; it was read as of {machine}."
        fix = "Compile it so (-m32), or generate it with portable word sizes."
        yield codes.WORD_SIZES_CHECKED.finding(message, fix=fix)
    for error in refusals[:1]:
        message = f"The code refuses to be compiled: {error.message[:200]}"
        fix = "If it needs definitions of the preprocessor, give them with -D NAME=VALUE."
        yield codes.CODE_INVALID.finding(message, *error.place, error.column, fix=fix)
