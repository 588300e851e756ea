"""Objects of the code under the names that a function.yaml gives them."""

import re
from collections.abc import Mapping, Sequence

from sigcat.function.c_project.code_values import Value
from sigcat.function.c_project.project import CodeObject, CodeProject
from sigcat.function.declaration.code_section import ObjectItem


def with_object_names(project: CodeProject, declared: Sequence[ObjectItem]) -> CodeProject:
    """The project with the names of a declaration, where only one of its objects has the type and the member."""
    names = _names(project.interface.objects, declared)
    if not names:
        return project
    whole = project.interface
    interface = whole._replace(
        inputs=_values(whole.inputs, names),
        outputs=_values(whole.outputs, names),
        parameters=_values(whole.parameters, names),
        others=_values(whole.others, names),
        objects=tuple(each._replace(name=names.get(each.name, each.name)) for each in whole.objects),
        arguments={call: tuple(names.get(each, each) for each in taken) for call, taken in whole.arguments.items()},
    )
    calls = (each._replace(arguments=tuple(names.get(name, name) for name in each.arguments)) for each in project.calls)
    return project._replace(
        interface=interface,
        calls=tuple(calls),
        others=_values(project.others, names),
        expressions=frozenset(_renamed(each, names) for each in project.expressions),
        undivided=frozenset(_renamed(each, names) for each in project.undivided),
    )


def _names(objects: Sequence[CodeObject], declared: Sequence[ObjectItem]) -> Mapping[str, str]:
    """The declared name of each object that has another one in the code."""
    own, known = {each.name for each in declared}, {each.name for each in objects}
    found: dict[str, str] = {}
    for each in objects:
        same = [one.name for one in declared if (one.type, one.member or "") == (each.type, each.member)]
        rivals = [one for one in objects if (one.type, one.member) == (each.type, each.member)]
        if each.name not in own and len(same) == len(rivals) == 1 and same[0] not in known:
            found[each.name] = same[0]
    return found


def _values(values: Sequence[Value], names: Mapping[str, str]) -> tuple[Value, ...]:
    return tuple(each._replace(expression=_renamed(each.expression, names)) for each in values)


def _renamed(expression: str, names: Mapping[str, str]) -> str:
    root = re.match(r"\w*", expression, re.ASCII)
    name = root[0] if root else ""
    return names.get(name, name) + expression[len(name) :]
