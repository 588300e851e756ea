"""Parameters and errors of a node, beside those of its core."""

from collections.abc import Iterator

from sigcat.adapter.core.plan import Parameter
from sigcat.adapter.ros2.node_context import NodeContext
from sigcat.adapter.ros2.plan import Monitor, NodeParameter, Symbol
from sigcat.integration.ros2.model import RosParameter


def node_parameters(context: NodeContext) -> Iterator[NodeParameter]:
    """The parameters of the node. One whose datatype is a struct has none; its start value holds."""
    by_name = {context.host.interfaces[each.named.pointer]: each for each in context.host.core.parameters}
    for declared in context.node.parameters:
        parameter = by_name.get(declared.parameter)
        if parameter is not None:
            yield _parameter(declared, parameter)


def _parameter(declared: RosParameter, parameter: Parameter) -> NodeParameter:
    is_text = declared.type.startswith("string")
    symbols = tuple(Symbol(text, number) for text, number in parameter.value.wire.symbols) if is_text else ()
    return NodeParameter(
        name=declared.name,
        type=declared.type,
        parameter=parameter,
        description=declared.description,
        default=declared.default,
        low=declared.low,
        high=declared.high,
        constraints=declared.constraints,
        units=declared.units,
        is_read_only=declared.read_only or parameter.learned is not None,
        symbols=symbols,
    )


def monitors(context: NodeContext) -> Iterator[Monitor]:
    """The errors of the core, as they are shown to people."""
    diagnostics = {diagnostic.error: diagnostic for diagnostic in context.node.diagnostics}
    for name, error in context.host.errors.items():
        yield Monitor(error, name, diagnostics[name])
