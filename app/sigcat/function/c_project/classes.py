"""Code in a C++ class: inputs, outputs and parameters are its members, which have to be public."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Code, Value, values_of
from sigcat.function.c_project.declarations import CClass, CFunction, Member
from sigcat.function.c_project.found_calls import Group, use_of
from sigcat.function.c_project.globals import ADD_BY_HAND, direction_unknown
from sigcat.function.c_project.project import ROLES, Interface, interface_of
from sigcat.function.c_project.roles import Role, role_of


def class_interface(group: Group, code: Code) -> Interface:
    """The interface in the members of the class."""
    owner = group.owner
    assert owner is not None
    found: list[tuple[Role, Value]] = []
    findings = list(_with_arguments(group.functions))
    others: list[Value] = []
    unknown: list[Value] = []
    used = use_of((f"{owner.name}::{step.name}" for step in group.steps), code.declarations).used
    for member in owner.members:
        role = _role(member, code)
        if role not in ROLES and member.public:
            values = list(values_of(member.name, member.type, member.place, code, key=member.key))
            others += values
            unknown += [each for each in values if not role and each.key in used and not each.problem]
        elif role in ROLES:
            getter = _getter(owner, member) if not member.public and role == "output" else ""
            found += ((role, each) for each in _values(getter or member.name, member, owner, code))
            if not member.public and not getter:
                findings.append(_private(member, role))
    findings += direction_unknown(unknown, ADD_BY_HAND)
    return interface_of(found, findings=tuple(findings), others=tuple(others))


def _role(member: Member, code: Code) -> Role:
    return role_of(member.name, member.type.name, code.heading(member.place)) if member.type.kind == "record" else ""


def _values(expression: str, member: Member, owner: CClass, code: Code) -> Iterator[Value]:
    start = next(
        (each.value for each in code.declarations.variables if each.name == f"{owner.name}::{member.name}"), None
    )
    return values_of(expression, member.type, member.place, code, start)


def _getter(owner: CClass, member: Member) -> str:
    """A call of the public method that returns the struct: `getExternalOutputs()`."""
    for method in owner.methods:
        if method.public and not method.parameters and method.result.target.key == member.type.key:
            return f"{method.name}()" if method.result.kind in ("record", "pointer") else ""
    return ""


def _private(member: Member, role: Role) -> Finding:
    message = f"{member.name!r} must be public: the adapter cannot reach an {role} that is private."
    message = message.replace("an parameter", "a parameter")
    fix = "Generate the class with public data members (Code Mappings, Data)."
    return codes.CALL_NOT_EXPRESSIBLE.finding(message, *member.place, fix=fix)


def _with_arguments(functions: tuple[CFunction, ...]) -> Iterator[Finding]:
    for function in functions:
        if function.parameters:
            names = ", ".join(repr(each.name) for each in function.parameters)
            message = f"{function.name!r} must take nothing, as a member of a class; it takes {names}."
            fix = "Generate the class with data members for inputs and outputs, or write a function around it."
            yield codes.CALL_NOT_EXPRESSIBLE.finding(message, *function.place, fix=fix)
