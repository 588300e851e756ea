"""Messages and services of the interface package, each made once."""

from collections.abc import Iterable, Mapping
from collections.abc import Set as AbstractSet

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.messages.common_types import ERROR_STATUS, SAFETY_REACTION, STEP
from sigcat.integration.ros2.messages.field_types import FieldType, field_type
from sigcat.integration.ros2.model import Message, MessageConstant, MessageField, Service
from sigcat.integration.ros2.names import Name, constant_name, field_name, message_name, report_renamed


class MessageBook:
    """The messages and services of one package: those of every set, and what is added."""

    def __init__(self, package: str, table: Mapping[str, Datatype], findings: FindingCollector) -> None:
        self.package = package
        self.table = table
        self._findings = findings
        self._messages = {message.name.lower(): message for message in (ERROR_STATUS, SAFETY_REACTION)}
        self._services = {STEP.name.lower(): STEP}
        self._taken = {*self._messages, *self._services}
        self._structs: dict[str, str] = {}
        self.modes: dict[str, str] = {}
        """Messages of mode interfaces, by interface name: every node of a function has them."""
        self._open: list[str] = []

    @property
    def messages(self) -> tuple[Message, ...]:
        """All messages, by name."""
        return tuple(self._messages[name] for name in sorted(self._messages))

    @property
    def services(self) -> tuple[Service, ...]:
        """All services, by name."""
        return tuple(self._services[name] for name in sorted(self._services))

    def add(
        self, name: str, description: Text, fields: Iterable[MessageField], constants: Iterable[MessageConstant]
    ) -> str:
        """Add a message under a name that was reserved for it."""
        message = Message(name=name, description=description, constants=tuple(constants), fields=tuple(fields))
        self._messages[name.lower()] = message
        return name

    def add_service(
        self,
        source: str,
        interface: Subject,
        description: Text,
        request: Iterable[MessageField],
        response: Iterable[MessageField],
    ) -> str:
        """Add a service and return its name."""
        name = self.reserved(source, interface)
        service = Service(name=name, description=description, request=tuple(request), response=tuple(response))
        self._services[name.lower()] = service
        return name

    def written(self, kind: FieldType, interface: Subject) -> str | None:
        """Return how a message of this package writes a datatype. None, and a finding, if no message can have it."""
        if kind.element is not None:
            return kind.element.ros2 + kind.suffix
        name = self._struct(kind.struct, interface)
        return None if name is None else name + kind.suffix

    def reserved(self, source: str, interface: Subject) -> str:
        """A name that nothing else of the package gets."""
        name = message_name(source, self._taken)
        report_renamed(name, source, interface, self._findings)
        self._taken.add(name.text.lower())
        return name.text

    def _struct(self, reference: str, interface: Subject) -> str | None:
        if reference in self._structs:
            return self._structs[reference]
        if reference in self._open:
            message = f"{interface}: {reference} must not contain itself: no ROS 2 message can."
            fix = "Break the cycle, for instance with an index."
            self._findings.report(codes.DATATYPE_UNRESOLVED, message, interface, fix)
            return None
        self._open.append(reference)
        members = self._members(self.table[reference], interface)
        self._open.pop()
        if members is None:
            return None
        datatype = self.table[reference]
        description = datatype.description or Text(f"Struct {datatype.vss_datatype or reference}.")
        name = self.add(self._struct_name(reference, interface), description, *members)
        self._structs[reference] = name
        return name

    def _struct_name(self, reference: str, interface: Subject) -> str:
        """Messages of topics keep their names, which other sets know; a struct of the same name says what it is."""
        source = reference.removeprefix("DT_")
        if message_name(source).text.lower() in self._taken:
            renamed = self.reserved(f"{source}Struct", interface)
            report_renamed(Name(renamed, f"{source!r} is the message of a topic"), source, interface, self._findings)
            return renamed
        return self.reserved(source, interface)

    def _members(
        self, datatype: Datatype, interface: Subject
    ) -> tuple[list[MessageField], list[MessageConstant]] | None:
        """Fields, and the values of those that are enumerations. None, and a finding, if no message can have them."""
        made: list[MessageField] = []
        values: list[MessageConstant] = []
        for member in datatype.fields or ():
            kind = field_type(member.datatype, None, self.table)
            if kind is None:
                unresolved(self._findings, interface, member.datatype)
                return None
            written = self.written(kind, interface)
            if written is None:
                return None
            name = field_name(member.name, {field.name for field in made})
            report_renamed(name, member.name, interface, self._findings)
            meaning = member.description or Text(member.name)
            made.append(MessageField(name=name.text, datatype=written, description=meaning, units=member.units))
            values += constants(kind, name.text, interface, self._findings, {value.name for value in values})
        return made, values


def unresolved(findings: FindingCollector, interface: Subject, reference: str) -> None:
    """Note that a datatype cannot be resolved."""
    message = f"{interface}: the datatype {reference} must be defined, with a C type. The field is left out."
    fix = f"Define {reference} under `Datatypes`, with its `cDef`."
    findings.report(codes.DATATYPE_UNRESOLVED, message, interface, fix)


def constants(
    kind: FieldType, prefix: str, interface: Subject, findings: FindingCollector, taken: AbstractSet[str] = frozenset()
) -> tuple[MessageConstant, ...]:
    """The values of an enumeration, as the message holds them. `taken` are names that the message has already."""
    made: dict[str, MessageConstant] = {}
    datatype = kind.element.ros2 if kind.element else "string"
    for symbol in kind.symbols:
        name = constant_name(f"{prefix}_{symbol.symbol}" if prefix else symbol.symbol, taken | made.keys())
        report_renamed(name, symbol.symbol, interface, findings)
        value = symbol.symbol if kind.is_text else str(symbol.value)
        made[name.text] = MessageConstant(name=name.text, datatype=datatype, value=Text(value))
    return tuple(made.values())
