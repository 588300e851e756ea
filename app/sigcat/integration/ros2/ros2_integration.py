"""From functions to the Integration JSON of ROS 2, without any further input."""

import re
from collections.abc import Collection, Iterator, Sequence
from typing import Any

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part, exchange_of
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.function.function_json.model import FunctionJson, Mode
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import interface_lists
from sigcat.function.function_json.walk import parts as walked
from sigcat.integration.application import DEFAULT_VERSION, Application, application, info_of, joined, meta_of
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.derived import Derived
from sigcat.integration.finding_collector import FindingCollector, Subject, subject_of
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.field_targets import field_targets
from sigcat.integration.ros2.function_set import function_set
from sigcat.integration.ros2.messages.existing_messages import existing_messages, with_existing_messages
from sigcat.integration.ros2.messages.made_messages import MessageBook
from sigcat.integration.ros2.model import Communication, InterfacePackage, NodePackage, Ros2Integration, RosNode
from sigcat.integration.ros2.names import PACKAGES_OF_ROS, package_name, topic_name
from sigcat.integration.ros2.nodes import mode_topic, node_of, report_calls
from sigcat.integration.ros2.services import with_services
from sigcat.integration.ros2.settings import NO_SETTINGS, Ros2Settings
from sigcat.integration.ros2.signal_uses import asil_of, node_parts
from sigcat.integration.ros2.statuses import statuses_of
from sigcat.integration.ros2.topics import communications, topics_of
from sigcat.integration.unknown_paths import report_unknown_paths
from sigcat.names import did_you_mean

_VERSION = re.compile(r"\d+\.\d+\.\d+")
_NODE_DEPENDENCIES = (
    "builtin_interfaces", "diagnostic_msgs", "lifecycle_msgs", "rcl_interfaces", "rclcpp", "rclcpp_components",
    "rclcpp_lifecycle",
)  # fmt: skip
_UNPROTECTED = "messages have no end-to-end protection"


def derive(
    functions: Sequence[ResolvedFunction], deployment: Deployment = NO_DEPLOYMENT, settings: Ros2Settings = NO_SETTINGS
) -> Derived[Ros2Integration]:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    app = application(functions, deployment)
    mapped, existing = with_existing_messages(app.functions, existing_messages(settings), app.paths)
    app = app._replace(functions=mapped)
    merged = function_set(app.functions)
    wholes = tuple(each.function for each in merged.functions)
    findings = FindingCollector(merged.functions, deployment)
    for problem in existing.problems:
        findings.report_deployment(codes.FIELD_DOES_NOT_FIT, problem.message, problem.pointer, problem.fix, "")
    package, interfaces = _packages(app, settings)
    book = MessageBook(interfaces, {each.reference: each for each in merged.datatypes}, findings)
    parts = node_parts(wholes, findings)
    exchange = exchange_of(parts, app.paths, joins_names=False)
    context = Context(app, settings, existing, package, parts, exchange, book, findings)
    exchanged = _exchanged(context)
    statuses = statuses_of(_topic_names(exchanged, parts), context)
    nodes = {part.name: node_of(part, exchanged, statuses, context) for part in parts}
    _report_asil(context)
    for part in parts:
        report_calls(part, findings)
    report_unknown_paths(codes.QUALITY_OF_NOTHING, app, findings)
    model = Ros2Integration(
        meta=meta_of(app, f"Integration of {app.name} with ROS 2"),
        info=info_of(app, _version(app)),
        components=tuple(part.component for part in parts),
        modes=_modes(wholes),
        datatypes=merged.datatypes,
        mode_interfaces=tuple(each for f in wholes for each in f.mode_interfaces or ()) or None,
        communications=exchanged,
        interface_packages=(_interface_package(context),),
        node_packages=(_node_package(tuple(nodes.values()), _message_packages(exchanged), context),),
        functions=app.wholes,
    )
    return Derived(model, findings.findings, field_targets(parts, nodes, exchanged))


def _exchanged(context: Context) -> tuple[Communication, ...]:
    """Communications of each call with others."""
    made = communications(topics_of(context), context)
    _report_quality_of_nothing(made, context)
    _report_fields_of_nothing(context)
    return with_services(made, context)


def _report_quality_of_nothing(exchanged: Sequence[Communication], context: Context) -> None:
    """A finding for each quality of service that the deployment states for no signal and no topic."""
    topics = {topic.name for communication in exchanged for topic in communication.topics}
    beginnings = ("", "/", f"{context.settings.namespace}/")
    known = {use.path for use in context.exchange.data if use.path}
    known |= {f"{beginning}{topic}" for beginning in beginnings for topic in topics}
    for key in context.settings.quality:
        if key not in known:
            message = f"Nothing in the set is called {key!r}, which the deployment file names under `ros2: quality`."
            context.findings.report(codes.QUALITY_OF_NOTHING, message, key, did_you_mean(key, known))


def _report_fields_of_nothing(context: Context) -> None:
    """A finding for each signal that the deployment maps to a field, and that is none of the set."""
    known, rule = {use.identity for use in context.exchange.data}, codes.QUALITY_OF_NOTHING
    for key, field in context.existing.fields.items():
        if key not in known:
            message = f"Nothing in the set is called {key!r}, which the deployment file names under `ros2: messages`."
            context.findings.report_deployment(rule, message, field.at, did_you_mean(key, known), key)


def _packages(app: Application, settings: Ros2Settings) -> tuple[str, str]:
    """Names of the packages of nodes and of interfaces: `EcoControl` → `eco_control` and `eco_control_interfaces`."""
    taken = {*PACKAGES_OF_ROS, *(name.removesuffix("_interfaces") for name in PACKAGES_OF_ROS)}
    interfaces = settings.message_package or f"{package_name(app.name, taken).text}_interfaces"
    return package_name(app.name, {interfaces, *taken, *_c_names(app)}).text, interfaces


def _c_names(app: Application) -> Iterator[str]:
    """Names of the C code: the package is a namespace of C++ beside them."""
    for function in app.wholes:
        for _, part in walked(function):
            for text in (getattr(part, "variable", None), getattr(part, "symbol", None)):
                if isinstance(text, str) and (name := re.match(r"\w+", text)):
                    yield name[0]


def _topic_names(exchanged: Sequence[Communication], parts: Sequence[Part]) -> Iterator[str]:
    """Topics of data and modes, and those that every lifecycle node has."""
    yield from (topic.name for communication in exchanged for topic in communication.topics)
    for part in parts:
        yield topic_name(part.name, "transition_event")
        yield from (mode_topic(part.function_name, mode) for mode in part.function.mode_interfaces or ())


def _report_asil(context: Context) -> None:
    """ROS 2 protects no message end to end and isolates no call: one finding for each call and interface above QM."""
    findings = context.findings
    for part in context.parts:
        for call in part.component.runnables:
            _above_qm(subject_of(call), call.asil_level, "the call shares its process with others", findings)
            for key, items in (each for contract in call.contracts or () for each in interface_lists(contract)):
                why = "parameters are not protected" if key == "ParameterList" else _UNPROTECTED
                for item in items or () if key != "MethodList" else ():
                    is_status = key in ("ErrorList", "SafetyReactionList")
                    name = item.name if is_status else item.vss_path or f"{part.function_name}.{item.name}"
                    _above_qm(Subject(name, item), item.asil_level, why, findings)


def _above_qm(subject: Subject, asil: str | None, why: str, findings: FindingCollector) -> None:
    level = asil_of(asil)
    if level != "QM":
        message = f"{subject}: ROS 2 does not support ASIL {level}: {why}."
        key = "Asillevel" if isinstance(subject.part, ParameterInterface) else "AsilLevel"
        fix = "Protect it in the code, or use a qualified platform."
        findings.report(codes.ASIL_NOT_SUPPORTED, message, subject, fix, key=key)


# -- the parts of the document ------------------------------------------------------------------------------------


def _version(app: Application) -> str | None:
    """The version that the deployment states, or that all functions have."""
    versions = {function.info.version for function in app.wholes}
    return app.version or (versions.pop() if len(versions) == 1 else None)


def _modes(functions: Sequence[FunctionJson]) -> tuple[Mode, ...] | None:
    """The modes of one function; in a set, each bears the name of its function, for many have a mode OFF."""
    if len(functions) == 1:
        return functions[0].modes
    renamed = (
        mode.model_copy(update={"name": f"{function.info.function_name}.{mode.name}"})
        for function in functions
        for mode in function.modes or ()
    )
    return tuple(renamed) or None


def _interface_package(context: Context) -> InterfacePackage:
    return InterfacePackage(
        name=context.book.package,
        version=context.application.version or DEFAULT_VERSION,
        description=Text(f"Messages and services of {context.application.name}."),
        **_responsible(context),
        dependencies=("builtin_interfaces",),
        messages=context.book.messages,
        services=context.book.services,
    )


def _node_package(nodes: tuple[RosNode, ...], existing: Collection[str], context: Context) -> NodePackage:
    app, bond = context.application, context.settings.bond
    (first, *others) = app.wholes
    version = app.version or ("" if others else first.info.version) or ""
    used = {*_NODE_DEPENDENCIES, *existing, *(("bondcpp",) if bond else ()), context.book.package}
    return NodePackage(
        name=context.package,
        version=version if _VERSION.fullmatch(version) else DEFAULT_VERSION,
        description=app.description,
        **_responsible(context),
        dependencies=tuple(sorted(used)),
        nodes=nodes,
        bond=bond or None,
    )


def _message_packages(exchanged: Sequence[Communication]) -> set[str]:
    """Packages of the messages that calls exchange."""
    return {topic.message.partition("/")[0] for each in exchanged for topic in each.topics if topic.message}


def _responsible(context: Context) -> dict[str, Any]:
    """Maintainer and license, which every package has."""
    settings = context.settings
    responsible = joined(each.info.function_responsible for each in context.application.wholes)
    given = settings.maintainer or responsible.raw or "unknown"
    maintainer = " ".join("".join(each if each.isprintable() else " " for each in given).split())
    return {"maintainer": Text(maintainer or "unknown"), "email": settings.email, "license": Text(settings.license)}
