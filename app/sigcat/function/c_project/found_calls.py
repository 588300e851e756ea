"""Calls of a model, by the names of functions: init, one step or several, terminate."""

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Literal, NamedTuple, NoReturn

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.c_project.declarations import CClass, CFunction, Declarations, Place
from sigcat.function.c_project.files import is_header

CallKind = Literal["init", "step", "terminate"]

_WORDS: Mapping[CallKind, str] = {
    "init": "initialize|initialise|init|setup",
    "step": "step",
    "terminate": "terminate|term|deinitialize|deinit|shutdown|finalize|cleanup|destroy",
}
_LOOSE = "run|update|execute|process|cyclic|cycle|calc|compute|task|main|output"
"""Names that a step may have by hand, where nothing is called one."""
_REST = r"_?(?P<number>\d*)(?:_?(?P<time>\d+)_?(?P<unit>ms|us|s))?"
_MAIN = frozenset(("main", "wmain", "WinMain", "app_main"))


Heading = Callable[[Place], str]


class Group(NamedTuple):
    """The calls of one model, or of one class."""

    name: str
    """Prefix of the names of its functions, or the name of the class."""
    init: CFunction | None
    steps: tuple[CFunction, ...]
    terminate: CFunction | None
    owner: CClass | None = None

    @property
    def functions(self) -> tuple[CFunction, ...]:
        """All calls, in the order in which they are made."""
        return tuple(each for each in (self.init, *self.steps, self.terminate) if each is not None)

    def full_name(self, function: CFunction) -> str:
        """Name of a call, with that of its class."""
        return f"{self.owner.name}::{function.name}" if self.owner else function.name

    @property
    def full_names(self) -> tuple[str, ...]:
        """Names of all calls."""
        return tuple(map(self.full_name, self.functions))


def find_calls(declarations: Declarations, model: str, function: str, folder: str, heading: Heading) -> Group:
    """The calls of the model that is named, of the one that is called as the function is, or of the only one.

    `heading` gives the comment above a declaration or its group. Raises InputRefused.
    """
    groups = [*_groups_of_classes(declarations), *_groups_of_functions(declarations, heading)]
    if not groups:
        raise _refused(_none(folder))
    if model:
        chosen = [group for group in groups if group.name == model]
        return chosen[0] if chosen else _not_one(groups, folder, f"has no model {model!r}, but")
    chosen = _group_named(groups, function) or _outer(groups, declarations)
    return chosen[0] if len(chosen) == 1 else _not_one(chosen, folder, f"has the calls of {len(chosen)} models:")


def _not_one(groups: list[Group], folder: str, what: str) -> NoReturn:
    names = ", ".join(sorted(group.name or group.steps[0].name for group in groups))
    message = f"One model must be chosen: the folder {what} {names}."
    raise _refused(codes.CALLS_OF_SEVERAL_MODELS.finding(message, folder, fix="Name one with --model."))


def _refused(finding: Finding) -> InputRefused:
    return InputRefused("the code cannot be imported", (finding,))


def _none(folder: str) -> Finding:
    message = "The folder must have a function to call in every cycle, such as NAME_step."
    ends = "calls are found by names that end in init, step, terminate"
    fix = f"Name the folder with the header that declares it; {ends}."
    return codes.CALLS_NOT_FOUND.finding(message, folder, fix=fix)


def _group_named(groups: list[Group], wanted: str) -> list[Group]:
    plain = _plain(wanted)
    return [group for group in groups if plain and _plain(group.name) in (plain, f"{plain}modelclass")][:1]


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.rpartition("::")[2].lower())


# -- groups -------------------------------------------------------------------------------------------------------


def _groups_of_functions(declarations: Declarations, heading: Heading) -> Iterator[Group]:
    """By the name of a step; else by what Simulink writes above functions that are called from outside; else loosely."""
    found = _callable(declarations)
    declared = [each for each in found if is_header(each.place.file)]
    groups = (
        list(_grouped(found, _WORDS))
        or list(_exported(declared, heading))
        or list(_grouped(declared, {**_WORDS, "step": _LOOSE}))
    )
    yield from (_without_dispatcher(group, declarations) for group in groups)


def _callable(declarations: Declarations) -> list[CFunction]:
    """Functions that others can call, at the header that declares them if there is one."""
    examples = main_files(declarations)
    found: dict[str, CFunction] = {}
    for each in declarations.functions:
        may_be_called = not each.is_static and each.name not in _MAIN and "::" not in each.name
        if may_be_called and each.place.file not in examples:
            known = found.setdefault(each.name, each)
            if is_header(each.place.file) and not is_header(known.place.file):
                found[each.name] = each
    return list(found.values())


def _exported(declared: list[CFunction], heading: Heading) -> Iterator[Group]:
    """Models without a step: each function that is called from outside is one."""
    by_file: defaultdict[str, list[CFunction]] = defaultdict(list)
    for each in declared:
        if _ENTRY_POINT.search(heading(each.place)):
            by_file[each.place.file].append(each)
    for functions in by_file.values():
        ends = {kind: _ending(functions, kind) for kind in ("init", "terminate")}
        steps = tuple(each for each in functions if each not in ends.values())
        init = ends["init"]
        if init and steps:
            yield Group(_PREFIX_OF_INIT.sub("", init.name), init, steps, ends["terminate"])


_ENTRY_POINT = re.compile(r"\bentry.?point function", re.IGNORECASE)
_PREFIX_OF_INIT = re.compile(rf"_?(?:{_WORDS['init']})$", re.IGNORECASE)


def _ending(functions: list[CFunction], kind: CallKind) -> CFunction | None:
    pattern = re.compile(rf".*?_?(?:{_WORDS[kind]})", re.IGNORECASE)
    return next((each for each in functions if pattern.fullmatch(each.name)), None)


def _without_dispatcher(group: Group, declarations: Declarations) -> Group:
    """Without the step that calls the others, one by one, as the number of a task tells it."""
    names = {step.name for step in group.steps}
    calling = {name for name in names if names & (reachable([name], declarations) - {name})}
    return group._replace(steps=tuple(step for step in group.steps if step.name not in calling) or group.steps)


def main_files(declarations: Declarations) -> frozenset[str]:
    """Files with a program, such as the example that Simulink generates."""
    return frozenset(each.place.file for each in declarations.functions if each.is_defined and each.name in _MAIN)


def _groups_of_classes(declarations: Declarations) -> Iterator[Group]:
    for each in declarations.classes:
        public = [method for method in each.methods if method.public]
        for group in _grouped(public, _WORDS):
            if not group.name:
                yield group._replace(name=each.name, owner=each)


def _grouped(functions: Iterable[CFunction], kinds: Mapping[CallKind, str]) -> Iterator[Group]:
    """Functions by what their names begin with, where one of them is a step."""
    groups: defaultdict[str, dict[CallKind, list[CFunction]]] = defaultdict(lambda: defaultdict(list))
    for function in functions:
        for kind, alternatives in kinds.items():
            match = re.fullmatch(rf"(?P<prefix>.*?)_?(?:{alternatives}){_REST}", function.name, re.IGNORECASE)
            if match and _begins_a_word(function.name, len(match["prefix"])):
                groups[match["prefix"]][kind].append(function)
                break
    for name, calls in groups.items():
        if calls["step"]:
            init, terminate = (next(iter(calls[kind]), None) for kind in ("init", "terminate"))
            yield Group(name, init, tuple(calls["step"]), terminate)


def _begins_a_word(name: str, at: int) -> bool:
    """Whether a word begins here: `CoreAccStep`, `core_step`; not `timestep`, `footstep`."""
    return at == 0 or name[at] == "_" or name[at].isupper() or not name[at - 1].isalpha()


# -- what calls use -----------------------------------------------------------------------------------------------


class Use(NamedTuple):
    """Names that functions, with all that they call, read and write: variables, and keys of members."""

    is_known: bool
    """Whether a body of theirs was read."""
    used: frozenset[str] = frozenset()
    written: frozenset[str] = frozenset()


def use_of(names: Iterable[str], declarations: Declarations) -> Use:
    """Names that functions use."""
    reached = reachable(names, declarations)
    bodies = [each for each in declarations.functions if each.name in reached and each.is_defined]
    used = frozenset(name for each in bodies for name in each.uses)
    return Use(bool(bodies), used, frozenset(name for each in bodies for name in each.writes))


# -- the outermost ------------------------------------------------------------------------------------------------


def _outer(groups: list[Group], declarations: Declarations) -> list[Group]:
    """Groups that no other one calls; a model calls the steps of the models in it."""
    if len(groups) == 1:
        return groups
    reached = {group.name: reachable((each.name for each in group.steps), declarations) for group in groups}
    inner = {
        group.name
        for group in groups
        for other in groups
        if other.name != group.name and any(step.name in reached[other.name] for step in group.steps)
    }
    outer = [group for group in groups if group.name not in inner]
    complete = [group for group in outer if group.init]
    return complete or outer or groups


def reachable(names: Iterable[str], declarations: Declarations) -> frozenset[str]:
    """Everything that functions use, and what those use, by name."""
    uses: defaultdict[str, set[str]] = defaultdict(set)
    for each in declarations.named:
        uses[each.name] |= each.uses
    found: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            left.extend(uses[name] - found)
    return frozenset(found)
