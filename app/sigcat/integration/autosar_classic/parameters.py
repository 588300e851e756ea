"""Parameters of a component: calibration over ports or within, and what is kept in non-volatile memory."""

from collections.abc import Iterable
from typing import Any, NamedTuple

from sigcat.function.document.text import Text
from sigcat.function.exchange import Part
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import OF_ADAPTER, Context, named_calls
from sigcat.integration.autosar_classic.datatypes.classic_types import Meaning
from sigcat.integration.autosar_names import distinct_names, short_name
from sigcat.integration.autosar_parts import parameter_uses
from sigcat.integration.sent_values import initial, sent

PORT = "Parameters"
"""Port of calibration parameters, and the end of the name of its interface."""
LEARNING = "LearningParameter"


class Parameter(NamedTuple):
    """A parameter of a component, under its own name."""

    name: str
    interface: ParameterInterface
    calls: tuple[str, ...]

    @property
    def is_stored(self) -> bool:
        """Whether its value is kept in non-volatile memory: it is learned, or persistent."""
        kind = "".join(letter for letter in self.interface.interface_type.lower() if letter.isalpha())
        return self.interface.attribute == LEARNING or kind.startswith("persist")


def parameters_of(part: Part) -> tuple[Parameter, ...]:
    """The parameters of a component; one that several calls use stands once."""
    users: dict[str, list[str]] = {}
    found: dict[str, ParameterInterface] = {}
    for call, parameter in parameter_uses(part):
        key = parameter.variable or parameter.name
        found.setdefault(key, parameter)
        users.setdefault(key, []).append(call.name)
    taken = (*OF_ADAPTER, *(each.name for each in named_calls(part)))
    names = distinct_names([short_name(each.name) for each in found.values()], taken)
    return tuple(
        Parameter(name, found[key], tuple(dict.fromkeys(users[key]))) for name, key in zip(names, found, strict=True)
    )


def calibration(part: Part) -> tuple[Parameter, ...]:
    """Parameters that are calibrated, and neither learned nor persistent."""
    return tuple(each for each in parameters_of(part) if not each.is_stored)


def parameter_interface(part: Part, context: Context) -> model.ParameterInterface:
    """The interface of the calibration parameters of a component."""
    return model.ParameterInterface(
        name=f"{part.name}_{PORT}",
        elements=tuple(
            model.DataElement(
                name=each.name,
                type=type_of_parameter(part, each, context),
                description=each.interface.description or None,
                vss_path=each.interface.vss_path,
                unit=(each.interface.vss_unit or each.interface.units) or None,
            )
            for each in calibration(part)
        ),
    )


def type_of_parameter(part: Part, parameter: Parameter, context: Context) -> str:
    """Application type of a parameter: in the unit and datatype of the catalogue, which the core takes."""
    interface = parameter.interface
    is_enumeration = context.types.numbers(part.function, interface) is not None
    has_limits = not is_enumeration and not (interface.min == 0 and interface.max == 0)
    meaning = Meaning(
        (interface.vss_unit or interface.units) or None,
        sent(interface.min, interface) if has_limits else None,
        sent(interface.max, interface) if has_limits else None,
        interface.description or None,
    )
    return context.types.application(
        short_name(f"{part.name}_{parameter.name}"), context.types.sent(part.function, interface), meaning
    )


def value_of_parameter(part: Part, parameter: Parameter, context: Context) -> Any:
    """Its value, as the catalogue has it."""
    return initial(parameter.interface, context.types.numbers(part.function, parameter.interface))


def parameter_port(part: Part, direction: Any, context: Context) -> model.Port:
    """The port of a component that requires its calibration parameters, or of the one that provides them."""
    return model.Port(
        name=PORT if direction == "Required" else f"{part.name}_{PORT}",
        direction=direction,
        kind="Parameter",
        interface=f"{part.name}_{PORT}",
        elements=tuple(
            model.Element(
                name=each.name,
                init=value_of_parameter(part, each, context),
                uses=tuple(
                    model.Use(interface=each.interface.name, kind="parameter", function=part.function_name, call=call)
                    for call in each.calls
                ),
            )
            for each in calibration(part)
        ),
        description=Text("Calibration parameters."),
    )


def internal_parameters(part: Part, context: Context) -> Iterable[model.InternalParameter]:
    """Calibration parameters that stay within the component."""
    for each in calibration(part):
        yield model.InternalParameter(
            name=each.name,
            type=type_of_parameter(part, each, context),
            init=value_of_parameter(part, each, context),
            uses=(each.interface.name,),
        )
