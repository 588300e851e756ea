"""From functions to the Integration JSON of ROS 2, without any further input."""

import re
from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part, exchange_of
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, Mode
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import interface_lists
from sigcat.function.function_json.walk import parts as walked
from sigcat.integration.application import DEFAULT_VERSION, Application, application, joined, meta_of
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.report import Entry
from sigcat.integration.ros2.field_targets import field_targets
from sigcat.integration.ros2.function_set import function_set
from sigcat.integration.ros2.messages.existing_messages import (
    ExistingMessages,
    existing_messages,
    with_existing_messages,
)
from sigcat.integration.ros2.messages.made_messages import MessageBook
from sigcat.integration.ros2.model import Communication, InterfacePackage, NodePackage, Ros2Integration, RosNode
from sigcat.integration.ros2.names import PACKAGES_OF_ROS, package_name, topic_name
from sigcat.integration.ros2.nodes import NodeContext, mode_topic, node_of, report_calls
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
    mapped, existing = with_existing_messages(app.functions, existing_messages(settings), app.paths)
    app = app._replace(functions=mapped)
    merged = function_set(app.functions)
    wholes = tuple(each.function for each in merged.functions)
    findings = FindingCollector(merged.functions, deployment)
    for problem in existing.problems:
        findings.report_deployment(codes.FIELD_DOES_NOT_FIT, problem.message, problem.pointer, problem.fix, "")
    packages = _packages(app, settings)
    book = MessageBook(packages.interfaces, {each.reference: each for each in merged.datatypes}, findings)
    parts = node_parts(wholes, findings)
    exchanged = _exchanged(parts, app, existing, settings, book, findings)
    context = NodeContext(
        package=packages.nodes,
        namespace=settings.namespace or "/",
        safety_manager=app.safety_manager,
        mode_manager=app.mode_manager,
        policy=settings.scheduling_policy,
        exchanged=exchanged,
        statuses=statuses_of(parts, _topic_names(exchanged, parts), findings),
        book=book,
        findings=findings,
    )
    nodes = {part.name: node_of(part, context) for part in parts}
    _report(parts, findings)
    report_unknown_paths(codes.QUALITY_OF_NOTHING, app, findings)
    model = Ros2Integration(
        meta=meta_of(app, f"Integration of {app.name} with ROS 2"),
        info=_info(app),
        components=tuple(part.component for part in parts),
        modes=_modes(wholes),
        datatypes=merged.datatypes,
        mode_interfaces=tuple(each for f in wholes for each in f.mode_interfaces or ()) or None,
        communications=exchanged,
        interface_packages=(_interface_package(book, app, settings),),
        node_packages=(_node_package(packages, tuple(nodes.values()), _message_packages(exchanged), app, settings),),
        functions=tuple(each.function for each in app.functions),
    )
    return Derived(model, findings.findings, field_targets(parts, nodes, exchanged))


def _exchanged(
    parts: Sequence[Part], app: Application, existing: ExistingMessages, settings: Ros2Settings, book: MessageBook,
    findings: FindingCollector,
) -> tuple[Communication, ...]:  # fmt: skip
    """Communications of each call with others."""
    exchange = exchange_of(parts, app.paths, joins_names=False)
    topics = topics_of(exchange, existing, settings, book, findings)
    made = communications(topics, exchange.data, settings, book, findings)
    _report_quality_of_nothing(made, {use.path for use in exchange.data if use.path}, settings, findings)
    _report_fields_of_nothing(existing, {use.identity for use in exchange.data}, findings)
    return with_services(made, exchange, book, findings)


def _report_quality_of_nothing(
    exchanged: Sequence[Communication], paths: Collection[str], settings: Ros2Settings, findings: FindingCollector
) -> None:
    """A finding for each quality of service that the deployment states for no signal and no topic."""
    topics = {topic.name for communication in exchanged for topic in communication.topics}
    known = {
        *paths,
        *topics,
        *(f"/{topic}" for topic in topics),
        *(f"{settings.namespace}/{topic}" for topic in topics),
    }
    for key in settings.quality:
        if key not in known:
            message = f"Nothing in the set is called {key!r}, which the deployment file names under `ros2: quality`."
            findings.report(codes.QUALITY_OF_NOTHING, message, key, did_you_mean(key, known))


def _report_fields_of_nothing(existing: ExistingMessages, known: Collection[str], findings: FindingCollector) -> None:
    """A finding for each signal that the deployment maps to a field, and that is none of the set."""
    for key, field in existing.fields.items():
        if key not in known:
            message = f"Nothing in the set is called {key!r}, which the deployment file names under `ros2: messages`."
            findings.report_deployment(codes.QUALITY_OF_NOTHING, message, field.at, did_you_mean(key, known), key)


class _Packages(NamedTuple):
    """Names of the packages."""

    nodes: str
    interfaces: str


def _packages(app: Application, settings: Ros2Settings) -> _Packages:
    """`EcoControl` → `eco_control` and `eco_control_interfaces`."""
    taken = {*PACKAGES_OF_ROS, *(name.removesuffix("_interfaces") for name in PACKAGES_OF_ROS)}
    interfaces = settings.message_package or f"{package_name(app.name, taken).text}_interfaces"
    return _Packages(package_name(app.name, {interfaces, *taken, *_c_names(app)}).text, interfaces)


def _c_names(app: Application) -> Iterator[str]:
    """Names of the C code: the package is a namespace of C++ beside them."""
    for resolved in app.functions:
        for _, part in walked(resolved.function):
            for text in (getattr(part, "variable", None), getattr(part, "symbol", None)):
                if isinstance(text, str) and (name := re.match(r"\w+", text)):
                    yield name[0]


def _topic_names(exchanged: Sequence[Communication], parts: Sequence[Part]) -> Iterator[str]:
    """Topics of data and modes, and those that every lifecycle node has."""
    yield from (topic.name for communication in exchanged for topic in communication.topics)
    for part in parts:
        yield topic_name(part.name, "transition_event")
        yield from (mode_topic(part.function_name, mode) for mode in part.function.mode_interfaces or ())


def _report(parts: Sequence[Part], findings: FindingCollector) -> None:
    """Note what ROS 2 cannot express."""
    _report_asil(parts, findings)
    for part in parts:
        report_calls(part, findings)


def _report_asil(parts: Sequence[Part], findings: FindingCollector) -> None:
    """ROS 2 protects no message end to end and isolates no call: one finding for each call and interface above QM."""
    for part in parts:
        for call in part.component.runnables:
            _above_qm(Subject(call.name, call), call.asil_level, "the call shares its process with others", findings)
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


def _info(app: Application) -> FunctionInfo:
    versions = {function.function.info.version for function in app.functions}
    return FunctionInfo(
        function_name=app.name,
        function_responsible=app.responsible,
        description=app.description,
        version=app.version or (versions.pop() if len(versions) == 1 else None),
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


def _interface_package(book: MessageBook, app: Application, settings: Ros2Settings) -> InterfacePackage:
    return InterfacePackage(
        name=book.package,
        version=app.version or DEFAULT_VERSION,
        description=Text(f"Messages and services of {app.name}."),
        maintainer=_maintainer(app, settings),
        email=settings.email,
        license=Text(settings.license),
        dependencies=("builtin_interfaces",),
        messages=book.messages,
        services=book.services,
    )


def _node_package(
    packages: _Packages, nodes: tuple[RosNode, ...], existing: Collection[str], app: Application, settings: Ros2Settings
) -> NodePackage:
    (first, *others) = app.functions
    version = app.version or ("" if others else first.function.info.version) or ""
    bond = ("bondcpp",) if settings.bond else ()
    return NodePackage(
        name=packages.nodes,
        version=version if _VERSION.fullmatch(version) else DEFAULT_VERSION,
        description=app.description,
        maintainer=_maintainer(app, settings),
        email=settings.email,
        license=Text(settings.license),
        dependencies=tuple(sorted({*_NODE_DEPENDENCIES, *existing, *bond, packages.interfaces})),
        nodes=nodes,
        bond=settings.bond or None,
    )


def _message_packages(exchanged: Sequence[Communication]) -> set[str]:
    """Packages of the messages that calls exchange."""
    return {topic.message.partition("/")[0] for each in exchanged for topic in each.topics if topic.message}


def _maintainer(app: Application, settings: Ros2Settings) -> Text:
    responsible = joined(each.function.info.function_responsible for each in app.functions)
    given = settings.maintainer or responsible.raw or "unknown"
    return Text(" ".join("".join(each if each.isprintable() else " " for each in given).split()) or "unknown")
