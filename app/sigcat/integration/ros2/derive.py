"""From functions to the Integration JSON of ROS 2, without any further input."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.function_json.data_interfaces import ParameterInterface
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, MetaInfo, Mode
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.application import DEFAULT_VERSION, Application, Part, application, joined
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.report import Entry
from sigcat.integration.ros2.field_targets import field_targets
from sigcat.integration.ros2.function_set import function_set
from sigcat.integration.ros2.messages import MessageBook
from sigcat.integration.ros2.model import InterfacePackage, NodePackage, Ros2Integration, RosNode, SourceFunction
from sigcat.integration.ros2.names import package_name
from sigcat.integration.ros2.nodes import Managers, node_of, report_calls, status_names
from sigcat.integration.ros2.services import with_services
from sigcat.integration.ros2.settings import NO_SETTINGS, Ros2Settings
from sigcat.integration.ros2.signal_uses import asil_of, data_of, node_parts, signal_uses
from sigcat.integration.ros2.topics import communications, topics_of

_VERSION = re.compile(r"\d+\.\d+\.\d+")
_NODE_DEPENDENCIES = ("builtin_interfaces", "diagnostic_msgs", "lifecycle_msgs", "rclcpp", "rclcpp_lifecycle")


class Derived(NamedTuple):
    """The document, the findings about it, and where each field of each interface went."""

    model: Ros2Integration
    findings: tuple[Finding, ...]
    report: tuple[Entry, ...]


def derive(
    functions: Sequence[ResolvedFunction], deployment: Deployment = NO_DEPLOYMENT, settings: Ros2Settings = NO_SETTINGS
) -> Derived:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    app = application(functions, deployment)
    merged = function_set(app.functions)
    wholes = tuple(each.function for each in merged.functions)
    findings = FindingCollector(merged.functions)
    book = MessageBook(settings.message_package, {each.reference: each for each in merged.datatypes}, findings)
    parts = node_parts(wholes, findings)
    uses = signal_uses(parts, app.paths)
    exchanged = communications(topics_of(uses, settings, book, findings), uses, settings, book, findings)
    exchanged = with_services(exchanged, parts, book, findings)
    statuses = status_names(parts)
    managers = Managers(app.safety_manager, app.mode_manager)
    nodes = {part.name: node_of(part, managers, exchanged, statuses, settings, book, findings) for part in parts}
    _report_asil(parts, findings)
    for part in parts:
        report_calls(part, findings)
    model = Ros2Integration(
        meta=_meta(app),
        info=_info(app),
        components=tuple(part.component for part in parts),
        modes=_modes(wholes),
        datatypes=merged.datatypes,
        mode_interfaces=tuple(each for f in wholes for each in f.mode_interfaces or ()) or None,
        communications=exchanged,
        interface_packages=_interface_packages(book, app, settings),
        node_packages=tuple(_node_package(part, nodes[part.name], book, app, settings) for part in parts),
        functions=tuple(_source(function) for function in wholes),
    )
    return Derived(model, findings.findings, field_targets(parts, nodes, exchanged))


def _report_asil(parts: Sequence[Part], findings: FindingCollector) -> None:
    """ROS 2 protects no message end to end and isolates no call: one finding for each call and interface above QM."""
    for part in parts:
        for call in part.component.runnables:
            _above_qm(
                Subject(call.name, call), call.asil_level, "the call shares process and executor with others", findings
            )
            for contract in call.contracts or ():
                for item in data_of(contract):
                    name = item.vss_path or f"{part.function_name}.{item.name}"
                    _above_qm(Subject(name, item), item.asil_level, "messages have no end-to-end protection", findings)
                for parameter in contract.parameters or ():
                    name = parameter.vss_path or f"{part.function_name}.{parameter.name}"
                    _above_qm(Subject(name, parameter), parameter.asil_level, "parameters are not protected", findings)
                for error in contract.errors or ():
                    _above_qm(Subject(error.name, error), error.asil_level, "diagnostics are not protected", findings)
                for reaction in contract.safety_reactions or ():
                    _above_qm(
                        Subject(reaction.name, reaction), reaction.asil_level, "diagnostics are not protected", findings
                    )


def _above_qm(subject: Subject, asil: str | None, why: str, findings: FindingCollector) -> None:
    level = asil_of(asil)
    if level != "QM":
        message = f"{subject}: ROS 2 does not support ASIL {level}: {why}."
        key = "Asillevel" if isinstance(subject.part, ParameterInterface) else "AsilLevel"
        fix = "Protect it in the code, or use a qualified platform."
        findings.report(codes.ASIL_NOT_SUPPORTED, message, subject, fix, key=key)


# -- the parts of the document ------------------------------------------------------------------------------------


def _meta(app: Application) -> MetaInfo:
    return MetaInfo(
        authority=app.authority or None,
        schema_author=app.author or None,
        date=app.date.strftime("%d.%m.%Y") if app.date else None,
        schema_version="1.0.0",
        schema_description=f"Integration of {app.name} with ROS 2",
    )


def _info(app: Application) -> FunctionInfo:
    return FunctionInfo(
        function_name=app.name,
        function_responsible=app.responsible,
        description=app.description,
        version=app.version or joined(function.function.info.version for function in app.functions) or None,
    )


def _modes(functions: Sequence[FunctionJson]) -> tuple[Mode, ...] | None:
    """The modes of one function; in a set, each bears the name of its function, for many have a mode OFF."""
    if len(functions) == 1:
        return functions[0].modes
    return (
        tuple(
            mode.model_copy(update={"name": f"{function.info.function_name}.{mode.name}"})
            for function in functions
            for mode in function.modes or ()
        )
        or None
    )


def _interface_packages(book: MessageBook, app: Application, settings: Ros2Settings) -> tuple[InterfacePackage, ...]:
    if not (book.messages or book.services):
        return ()
    functions = joined(function.function.info.function_responsible for function in app.functions)
    package = InterfacePackage(
        name=book.package,
        version=app.version or DEFAULT_VERSION,
        description=f"Messages and services of {app.name}.",
        maintainer=settings.maintainer or functions or "unknown",
        email=settings.email,
        license=settings.license,
        dependencies=("builtin_interfaces",),
        messages=book.messages,
        services=book.services,
    )
    return (package,)


def _node_package(
    part: Part, node: RosNode, book: MessageBook, app: Application, settings: Ros2Settings
) -> NodePackage:
    info = part.function.info
    name = package_name(part.name, {book.package}).text
    version = app.version or info.version or ""
    return NodePackage(
        name=name,
        version=version if _VERSION.fullmatch(version) else DEFAULT_VERSION,
        description=info.description,
        maintainer=settings.maintainer or info.function_responsible or "unknown",
        email=settings.email,
        license=settings.license,
        dependencies=tuple(sorted((*_NODE_DEPENDENCIES, *((book.package,) if book.messages or book.services else ())))),
        executable=f"{name}_node",
        nodes=(node,),
    )


def _source(function: FunctionJson) -> SourceFunction:
    return SourceFunction(
        name=function.info.function_name,
        version=function.info.version,
        code=function.code,
        provenance=function.provenance,
    )
