"""Methods of a function as operations of ports."""

from collections.abc import Iterator, Mapping

from sigcat import codes
from sigcat.adapter.autosar_classic.code.plan import ArgumentEnd, MethodEnd
from sigcat.adapter.autosar_classic.code.planning.ends import SwcContext
from sigcat.adapter.core.plan import Argument
from sigcat.errors import InputRefused
from sigcat.integration.autosar_classic.model import ClientServerInterface, Operation, OperationArgument, Use


def method_ends(context: SwcContext) -> Iterator[MethodEnd]:
    """Yield methods that the function offers, and those that it uses."""
    interfaces = {each.name: each for each in context.model.client_server_interfaces}
    for port in context.component.ports:
        for element in port.elements if port.kind == "ClientServer" else ():
            for use in element.uses or ():
                method = context.host.methods.get(use.interface)
                if method is not None:
                    interface = interfaces[port.interface]
                    operation = next(each for each in interface.operations if each.name == element.name)
                    given = [each for each in operation.arguments if each.direction != "OUT"]
                    taken = [each for each in operation.arguments if each.direction == "OUT"]
                    if (len(given), len(taken)) != (len(method.arguments), len(method.results)):
                        raise _other_arguments(context.model.client_server_interfaces.index(interface), operation, use)
                    yield MethodEnd(
                        port.name, element.name, method,
                        _arguments(given, method.arguments, context), _arguments(taken, method.results, context),
                        _errors(operation, interface), interface.name, (use.interface,),
                    )  # fmt: skip
                    break


def _other_arguments(index: int, operation: Operation, use: Use) -> InputRefused:
    message = f"{operation.name} must have the arguments of the method {use.interface} of {use.function}."
    pointer = f"/ClientServerInterfaces/{index}/Operations"
    finding = codes.NOT_WRITABLE_AS_CLASSIC.finding(message, pointer=pointer, fix="Integrate the functions again.")
    return InputRefused("The integration cannot become software components.", (finding,))


def _arguments(
    given: list[OperationArgument], own: tuple[Argument, ...], context: SwcContext
) -> tuple[ArgumentEnd, ...]:
    return tuple(
        ArgumentEnd(each.name, context.types[each.type], one.value.wire, one.name)
        for each, one in zip(given, own, strict=True)
    )


def _errors(operation: Operation, interface: ClientServerInterface) -> Mapping[str, int]:
    numbers = {each.name: each.value for each in interface.errors or ()}
    return {name: numbers[name] for name in operation.errors or ()}
