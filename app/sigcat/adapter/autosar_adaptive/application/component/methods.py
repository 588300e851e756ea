"""Methods that the function uses or offers."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.names import cpp_type
from sigcat.adapter.autosar_adaptive.application.plan import CalledMethod, ComponentPlan, Provided
from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, METHOD_ERRORS
from sigcat.adapter.core.plan import Argument


class _Passed(NamedTuple):
    """An argument or a result: its names in the service interface and in the core, and its type."""

    name: str
    core: str
    type: str

    @property
    def local(self) -> str:
        """Its name in a function: unlike every local variable and member, whatever its own name is."""
        return f"argument_{self.name}"


class AdapterMethod(NamedTuple):
    """A method: its name in the service interface and in the core, and what it takes and gives."""

    member: str
    name: str
    service: str
    """The member for its service."""
    output: str
    """Type of its results, or void."""
    arguments: Sequence[_Passed]
    results: Sequence[_Passed]

    @property
    def pending(self) -> str:
        """The member that waits for an answer."""
        return f"pending_{self.member}_"

    @property
    def future(self) -> str:
        """Return type of the function that calls it."""
        return f"ara::core::Future<{self.output}>"

    @property
    def parameters(self) -> str:
        """Parameters of the function in C++ that answers it."""
        return ", ".join(f"const {each.type}& {each.local}" for each in self.arguments)


class Refusal(NamedTuple):
    """A reply of the core that refuses a request, as an error of the domain of methods."""

    reply: str
    code: str


def used_methods(component: ComponentPlan) -> Sequence[AdapterMethod]:
    """Methods of other functions."""
    return [
        _method(each, service.variable, f"::{service.names.element('proxy', 'methods', each.member)}::Output")
        for service in component.required
        for each in service.methods
    ]


def offered_methods(service: Provided) -> Sequence[AdapterMethod]:
    """Methods that the component answers."""
    return [
        _method(each, service.variable, f"::{service.names.skeleton}::{each.member}Output") for each in service.methods
    ]


def error_namespace(component: ComponentPlan) -> str:
    """Namespace of the errors of methods."""
    return "::".join(("", *component.error_namespace))


def refusals() -> Sequence[Refusal]:
    """All replies that are errors."""
    return [Refusal(f"SIGCAT_{each.reply}", f"{DOMAIN}Errc::{each.name}") for each in METHOD_ERRORS]


def _method(method: CalledMethod, service: str, output: str) -> AdapterMethod:
    core = method.method
    arguments, results = _passed(method.arguments, core.arguments), _passed(method.results, core.results)
    return AdapterMethod(
        method.member, core.named.name, service, output if method.results else "void", arguments, results
    )


def _passed(named: Iterable[tuple[str, str]], core: Iterable[Argument]) -> Sequence[_Passed]:
    return [_Passed(name, each.name, cpp_type(type_)) for (name, type_), each in zip(named, core, strict=True)]
