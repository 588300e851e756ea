"""Places of the core for the interfaces of a function: every platform needs them to connect the two."""

from collections.abc import Mapping
from functools import cached_property

from sigcat.adapter.core.plan import CorePlan, Error, Named, Output, Port
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data, parts


class CorePlaces:
    """A function beside the core that was planned for it."""

    def __init__(self, function: FunctionJson, core: CorePlan) -> None:
        self.function = function
        self.core = core

    @cached_property
    def data_pointers(self) -> Mapping[tuple[str, str], Pointer]:
        """Pointers of the data interfaces of the function, by call and name."""
        return {(at.runnable.name, item.name): pointer for pointer, at, item in data(self.function)}

    @cached_property
    def ports(self) -> Mapping[Pointer, Port]:
        """Places that take signals, by where these stand."""
        return {item.named.pointer: port for port in self.core.ports for _, item in port.consumers}

    @cached_property
    def outputs(self) -> Mapping[Pointer, Output]:
        """Sent values, by pointer."""
        return {output.named.pointer: output for output in self.core.outputs}

    @cached_property
    def interface_names(self) -> Mapping[Pointer, str]:
        """Names of all interfaces, by where they stand."""
        return {at: name for at, item in parts(self.function) if isinstance(name := getattr(item, "name", None), str)}

    @cached_property
    def errors(self) -> Mapping[str, Error]:
        """Errors of the function, by the name of the interface."""
        return {self.name_of(error.named): error for error in self.core.errors}

    def name_of(self, named: Named) -> str:
        """Name of the interface that a part of the core was made from."""
        return self.interface_names[named.pointer]
