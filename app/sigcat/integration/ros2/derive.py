"""From functions to the Integration JSON of ROS 2, without any further input."""

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, MetaInfo, Mode
from sigcat.integration.deployment import DEFAULT_DEPLOYMENT, Deployment
from sigcat.integration.function_set import FunctionSet, function_set
from sigcat.integration.names import package_name
from sigcat.integration.report import Entry
from sigcat.integration.ros2.field_targets import report
from sigcat.integration.ros2.limits import Limits
from sigcat.integration.ros2.messages import MessageBook
from sigcat.integration.ros2.model import InterfacePackage, NodePackage, Ros2Integration, RosNode, SourceFunction
from sigcat.integration.ros2.nodes import node_of, report_calls, status_names
from sigcat.integration.ros2.services import with_services
from sigcat.integration.ros2.signal_uses import Place, asil_of, data_of, places, uses_of
from sigcat.integration.ros2.topics import communications, topics_of

_VERSION = re.compile(r"\d+\.\d+\.\d+")
_NODE_DEPENDENCIES = ("builtin_interfaces", "diagnostic_msgs", "lifecycle_msgs", "rclcpp", "rclcpp_lifecycle")


class Derived(NamedTuple):
    """What was derived, what is to be said about it, and where each field went."""

    model: Ros2Integration
    findings: tuple[Finding, ...]
    report: tuple[Entry, ...]


def derive(functions: Sequence[FunctionJson], deployment: Deployment = DEFAULT_DEPLOYMENT) -> Derived:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    if not functions:
        raise UsageError("There is no function to integrate: name one at least.")
    ordered = function_set(sorted(functions, key=lambda function: function.info.function_name))
    _refuse_doubles(ordered.functions)
    settings, limits = deployment.ros2, Limits()
    book = MessageBook(settings.message_package, {each.reference: each for each in ordered.datatypes}, limits)
    parts = places(ordered.functions, limits)
    uses = uses_of(parts, deployment.paths)
    exchanged = communications(topics_of(uses, settings, book, limits), uses, settings, book, limits)
    exchanged = with_services(exchanged, parts, settings, book, limits)
    statuses = status_names(parts)
    nodes = {part.node: node_of(part, exchanged, statuses, settings, book, limits) for part in parts}
    _report_asil(parts, limits)
    for part in parts:
        report_calls(part, limits)
    model = Ros2Integration(
        meta=_meta(ordered.functions, deployment),
        info=_info(ordered.functions, deployment),
        components=tuple(part.component for part in parts),
        modes=_modes(ordered.functions),
        datatypes=ordered.datatypes,
        mode_interfaces=tuple(each for f in ordered.functions for each in f.mode_interfaces or ()) or None,
        communications=exchanged,
        interface_packages=_interface_packages(book, ordered, deployment),
        node_packages=tuple(_node_package(part, nodes[part.node], book, deployment) for part in parts),
        functions=tuple(_source(function) for function in ordered.functions),
    )
    return Derived(model, limits.findings, report(parts, nodes, exchanged))


def _refuse_doubles(functions: Sequence[FunctionJson]) -> None:
    names = [function.info.function_name for function in functions]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise UsageError(f"A set has each function once; given twice: {', '.join(twice)}.")


def _report_asil(parts: Sequence[Place], limits: Limits) -> None:
    """ROS 2 protects no message end to end and isolates no call: one finding for each call and interface above QM."""
    for part in parts:
        for call in part.component.runnables:
            _above_qm(call.name, call.asil_level, "the call shares process and executor with others", limits)
            for contract in call.contracts or ():
                for item in data_of(contract):
                    name = item.vss_path or f"{part.name}.{item.name}"
                    _above_qm(name, item.asil_level, "messages have no end-to-end protection", limits)
                for parameter in contract.parameters or ():
                    name = parameter.vss_path or f"{part.name}.{parameter.name}"
                    _above_qm(name, parameter.asil_level, "parameters are not protected", limits)
                for error in contract.errors or ():
                    _above_qm(error.name, error.asil_level, "diagnostics are not protected", limits)
                for reaction in contract.safety_reactions or ():
                    _above_qm(reaction.name, reaction.asil_level, "diagnostics are not protected", limits)


def _above_qm(name: str, asil: str | None, why: str, limits: Limits) -> None:
    level = asil_of(asil)
    if level != "QM":
        message = f"{name}: ROS 2 does not support ASIL {level}: {why}."
        limits.report(
            codes.ASIL_NOT_SUPPORTED, name, message, "Protect it in the code, or use a platform that is qualified."
        )


# -- the parts of the document ------------------------------------------------------------------------------------


def _meta(functions: Sequence[FunctionJson], deployment: Deployment) -> MetaInfo:
    dates = [function.meta.date for function in functions if function.meta.date]
    latest = max(dates, key=lambda date: (date[6:], date[3:5], date[:2]), default=None)
    return MetaInfo(
        authority=deployment.authority or _joined(function.meta.authority for function in functions),
        schema_author=deployment.author or _joined(function.meta.schema_author for function in functions),
        date=deployment.date.strftime("%d.%m.%Y") if deployment.date else latest,
        schema_version="1.0.0",
        schema_description=f"Integration of {application_name(functions, deployment)} with ROS 2",
    )


def application_name(functions: Sequence[FunctionJson], deployment: Deployment) -> str:
    """Name of the application: as the deployment says, or the names of its functions."""
    return deployment.name or " and ".join(function.info.function_name for function in functions)


def _info(functions: Sequence[FunctionJson], deployment: Deployment) -> FunctionInfo:
    infos = [function.info for function in functions]
    return FunctionInfo(
        function_name=application_name(functions, deployment),
        function_responsible=deployment.responsible or _joined(info.function_responsible for info in infos) or "",
        description=deployment.description or " ".join(dict.fromkeys(info.description for info in infos)),
        version=deployment.version or _joined(info.version for info in infos),
    )


def _joined(texts: Iterable[str | None]) -> str | None:
    return ", ".join(dict.fromkeys(text for text in texts if text)) or None


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


def _interface_packages(book: MessageBook, merged: FunctionSet, deployment: Deployment) -> tuple[InterfacePackage, ...]:
    if not (book.messages or book.services):
        return ()
    infos = [function.info for function in merged.functions]
    package = InterfacePackage(
        name=book.package,
        version=deployment.version or "1.0.0",
        description=f"Messages and services of {application_name(merged.functions, deployment)}.",
        maintainer=deployment.ros2.maintainer or _joined(info.function_responsible for info in infos) or "unknown",
        email=deployment.ros2.email,
        license=deployment.ros2.license,
        dependencies=("builtin_interfaces",),
        messages=book.messages,
        services=book.services,
    )
    return (package,)


def _node_package(part: Place, node: RosNode, book: MessageBook, deployment: Deployment) -> NodePackage:
    info = part.function.info
    name = package_name(part.node, {book.package}).text
    version = deployment.version or info.version or ""
    return NodePackage(
        name=name,
        version=version if _VERSION.fullmatch(version) else "1.0.0",
        description=info.description,
        maintainer=deployment.ros2.maintainer or info.function_responsible or "unknown",
        email=deployment.ros2.email,
        license=deployment.ros2.license,
        dependencies=tuple(sorted((*_NODE_DEPENDENCIES, *((book.package,) if book.messages or book.services else ())))),
        executable=f"{name}_node",
        nodes=(node,),
    )


def _source(function: FunctionJson) -> SourceFunction:
    return SourceFunction(
        name=function.info.function_name, version=function.info.version, provenance=function.provenance
    )
