"""What proxy and skeleton of a service share: its datatypes, and what its methods give."""

from sigcat.adapter.autosar_adaptive.bench.method_errors import errors_path
from sigcat.adapter.autosar_adaptive.bench.services import Service, output_name
from sigcat.adapter.autosar_adaptive.bench.text import comment, header, within
from sigcat.function.document.text import sentence
from sigcat.integration.autosar_adaptive.model import Method, MethodArgument
from sigcat.integration.datatypes import BY_ADAPTIVE


def common_header(service: Service) -> str:
    """The header of what both share."""
    words = service.words()
    standard = ["<cstdint>"] if any(word in BY_ADAPTIVE for word in words) else []
    errors = [errors_path(service.types)] if service.whole.methods else []
    includes = [*standard, *service.types.headers(words), *errors]
    about = f"Datatypes of {service.whole.name}."
    outputs = [_output(method, service) for method in service.whole.methods if method.outputs]
    body = within(service.outputs, outputs) if outputs else []
    return header(service.names.common_header, about, includes, body)


def arguments(method: Method, service: Service) -> str:
    """The arguments of a method as they are declared."""
    return ", ".join(f"const {service.types.type(each.datatype)}& {each.name}" for each in method.inputs or ())


def signature(method: Method, service: Service) -> str:
    """What a method gives and takes: `Output(First, Second)`."""
    taken = ", ".join(service.types.type(each.datatype) for each in method.inputs or ())
    return f"{service.result(method)}({taken})"


def told(argument: MethodArgument) -> str | None:
    """Name and unit of an argument."""
    return f"{argument.name} in {argument.unit}" if argument.unit else None


def _output(method: Method, service: Service) -> str:
    rows = [f"    {service.types.type(each.datatype)} {each.name}{{}};" for each in method.outputs or ()]
    about = sentence(f"What {method.name} gives", *map(told, method.outputs or ()))
    return "\n".join([comment(about), f"struct {output_name(method)} {{", *rows, "};"])
