"""Errors and safety reactions: their diagnostics for people, and the topics on which nodes exchange them.

A node publishes each of its errors and reactions on a separate topic, `core_acc/alive_error`, and hears the errors of others
there. What the platform says of a safety condition comes on a topic for all nodes, `safety_management/acc_req_invalid`.
"""

from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import optional
from sigcat.function.exchange import Part, causes, errors_of, reactions_of
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.integration.finding_collector import FindingCollector, subject_of
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.messages.common_types import ERROR_STATUS, SAFETY_REACTION
from sigcat.integration.ros2.messages.field_types import c_definition
from sigcat.integration.ros2.model import ConditionMonitor, Diagnostic, StatusTopic
from sigcat.integration.ros2.names import Name, numbered, report_renamed, shortened, topic_name
from sigcat.integration.ros2.quality_of_service import STATUS
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION

DIAGNOSTICS = "/diagnostics"
"""Topic of the nodes' statuses, as diagnostic_updater and the aggregator have it."""
SAFETY_MANAGEMENT = "safety_management"
"""Topic of the platform's safety conditions."""
_ERROR_ENDING, _REACTION_ENDING = "_ErrorSts", "_SftyCondSts"
_MILD = ("warn", "information", "amber", "none")


class Statuses(NamedTuple):
    """The errors and reactions of the set."""

    topics: Mapping[tuple[str, str], str]
    """By node and interface; by an empty node those of the platform."""
    reporters: Mapping[str, str]
    """The node that reports an error."""

    def status(self, error: str) -> str:
        """Name of the diagnostic status: `core_acc: CoreAcc_AliveError_ErrorSts`; of an error from outside its own name."""
        return f"{self.reporters[error]}: {error}" if error in self.reporters else error

    def topic(self, error: str) -> str:
        """Topic of an error, wherever it is reported."""
        return self.topics[self.reporters[error], error] if error in self.reporters else _outside(error)


def statuses_of(taken: Iterable[str], context: Context) -> Statuses:
    """Every error and reaction of the set with its topic. `taken` are topics of data and modes."""
    topics: dict[tuple[str, str], str] = {}
    reporters: dict[str, str] = {}
    names = set(taken)

    def name(item: ErrorInterface | SafetyReaction, node: str, short: str) -> None:
        wanted = topic_name(node or SAFETY_MANAGEMENT, short)
        free = numbered(wanted, names)
        if free != wanted:
            report_renamed(Name(free, f"{wanted!r} is taken"), wanted, subject_of(item), context.findings)
        names.add(free)
        topics[node, item.name] = free

    for part in context.parts:
        for error in errors_of(part):
            reporters.setdefault(error.name, part.name)
            name(error, part.name, _short(error.name, part, _ERROR_ENDING))
        for reaction in reactions_of(part):
            name(reaction, part.name, _short(reaction.name, part, _REACTION_ENDING))
    for reaction in (reaction for part in context.parts for reaction in reactions_of(part)):
        if ("", reaction.name) not in topics:
            name(reaction, "", reaction.name.removesuffix(_REACTION_ENDING))
    return Statuses(topics, reporters)


# -- topics -------------------------------------------------------------------------------------------------------


def _short(name: str, part: Part, ending: str) -> str:
    return name.removeprefix(f"{part.function_name}_").removesuffix(ending)


def _outside(error: str) -> str:
    """Return the topic of another set's error, if its name follows the rule: `Hmi_Fault_ErrorSts` → `hmi/fault`."""
    function, _, name = error.removesuffix(_ERROR_ENDING).partition("_")
    return topic_name(function, name) if name else topic_name(function)


def error_topics(part: Part, statuses: Statuses, context: Context) -> Iterator[StatusTopic]:
    """The topics of the errors of a node, then those of the errors of others on which something of it depends."""
    topic = partial(
        StatusTopic, message=f"{context.book.package}/msg/{ERROR_STATUS.name}", field="status", quality=STATUS
    )
    own = {error.name: error for error in errors_of(part)}
    for name, error in own.items():
        at = statuses.topics[part.name, name]
        yield topic(interface=name, topic=at, role=PUBLISHER, vss_path=error.vss_path)
    items: tuple[ErrorInterface | SafetyReaction, ...] = (*own.values(), *reactions_of(part))
    for name in dict.fromkeys(name for item in items for name in causes(item)):
        if name not in own:
            provider = optional(statuses.reporters.get(name))
            yield topic(interface=name, topic=statuses.topic(name), role=SUBSCRIPTION, provider=provider)


def reaction_topics(part: Part, statuses: Statuses, context: Context) -> Iterator[StatusTopic]:
    """The topics on which a node publishes its safety reactions, and those on which the platform sends them to it."""
    message, manager = f"{context.book.package}/msg/{SAFETY_REACTION.name}", context.application.safety_manager
    for node, role, provider in ((part.name, PUBLISHER, None), ("", SUBSCRIPTION, manager)):
        for each in reactions_of(part):
            yield StatusTopic(
                interface=each.name,
                topic=statuses.topics[node, each.name],
                role=role,
                message=message,
                field="state",
                provider=provider,
                quality=STATUS,
                vss_path=each.vss_path,
            )


# -- for people ---------------------------------------------------------------------------------------------------


def diagnostics(part: Part, statuses: Statuses, findings: FindingCollector) -> Iterator[Diagnostic]:
    """The diagnostic statuses of the errors of a node."""
    for error in errors_of(part):
        if error.reset_condition and error.reset is None:
            message = f"{error.name}: `resetCondition` is free text and cannot be checked."
            fix = "Set `reset` to a signal or `restart`; without it, the error resets when its cause is gone."
            findings.report(codes.RESET_CONDITION_IN_WORDS, message, error, fix, key="ResetCondition")
        yield Diagnostic(
            name=statuses.status(error.name),
            error=error.name,
            message=error.description,
            level="WARN" if any(word in error.severity.raw.lower() for word in _MILD) else "ERROR",
            severity=error.severity,
            maturation_time=error.maturation_time,
            occurrence_count_limit=error.occurrence_count_limit,
            ignition_count_limit=error.ignition_count_limit,
            reset_time=error.reset_time,
            reset_condition=error.reset_condition,
            dependencies=_dependencies(error, "Dependancy", statuses, findings),
            vss_path=error.vss_path,
        )


def conditions(part: Part, statuses: Statuses, context: Context) -> Iterator[ConditionMonitor]:
    """The safety conditions of a node."""
    for reaction in reactions_of(part):
        yield ConditionMonitor(
            condition=reaction.name,
            description=reaction.description,
            topic=statuses.topics[part.name, reaction.name],
            statuses=_dependencies(reaction, "ErrorList", statuses, context.findings),
            provider=context.application.safety_manager,
            variable_type=c_definition(reaction.datatype, context.book.table),
            vss_path=reaction.vss_path,
        )


def _dependencies(
    item: ErrorInterface | SafetyReaction, key: str, statuses: Statuses, findings: FindingCollector
) -> tuple[str, ...]:
    """Names of the statuses of errors that set it; of an error from outside of the set, its own name."""
    for error in causes(item):
        if error not in statuses.reporters:
            message = f"{item.name} depends on {shortened(error)}, which no function in the set reports."
            fix = f"The node that reports it must publish it on the topic {shortened(statuses.topic(error))!r}, or be remapped."
            findings.report(codes.ERROR_FROM_OUTSIDE, message, item, fix, key=key)
    return tuple(map(statuses.status, causes(item)))
