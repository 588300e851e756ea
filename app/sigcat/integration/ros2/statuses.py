"""Errors and safety reactions: their diagnostics for people, and the topics on which nodes exchange them.

A node publishes each of its errors and reactions on a separate topic, `core_acc/alive_error`, and hears the errors of others
there. What the platform says of a safety condition comes on a topic for all nodes, `safety_management/acc_req_invalid`.
"""

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.document.text import Text, optional
from sigcat.function.exchange import Part, errors_of, reactions_of
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.messages.common_types import ERROR_STATUS, SAFETY_REACTION
from sigcat.integration.ros2.messages.field_types import c_definition
from sigcat.integration.ros2.model import ConditionMonitor, Diagnostic, StatusTopic
from sigcat.integration.ros2.names import Name, report_renamed, shortened, topic_name
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


def statuses_of(parts: Sequence[Part], taken: Iterable[str], findings: FindingCollector) -> Statuses:
    """Every error and reaction of the set with its topic. `taken` are topics of data and modes."""
    topics: dict[tuple[str, str], str] = {}
    reporters: dict[str, str] = {}
    names = set(taken)
    for part in parts:
        for error in errors_of(part):
            reporters.setdefault(error.name, part.name)
            _name(topics, names, part.name, error, _short(error.name, part, _ERROR_ENDING), findings)
        for reaction in reactions_of(part):
            _name(topics, names, part.name, reaction, _short(reaction.name, part, _REACTION_ENDING), findings)
    for reaction in (reaction for part in parts for reaction in reactions_of(part)):
        if ("", reaction.name) not in topics:
            short = reaction.name.removesuffix(_REACTION_ENDING)
            _name(topics, names, "", reaction, short, findings)
    return Statuses(topics, reporters)


# -- topics -------------------------------------------------------------------------------------------------------


def _short(name: str, part: Part, ending: str) -> str:
    return name.removeprefix(f"{part.function_name}_").removesuffix(ending)


def _outside(error: str) -> str:
    """Return the topic of another set's error, if its name follows the rule: `Hmi_Fault_ErrorSts` → `hmi/fault`."""
    function, _, name = error.removesuffix(_ERROR_ENDING).partition("_")
    return topic_name(function, name) if name else topic_name(function)


def _name(
    topics: dict[tuple[str, str], str], taken: set[str], node: str, item: ErrorInterface | SafetyReaction, short: str,
    findings: FindingCollector,
) -> None:  # fmt: skip
    wanted = topic_name(node or SAFETY_MANAGEMENT, short)
    free = _free(wanted, taken)
    report_renamed(
        Name(free, f"{wanted!r} is taken" if free != wanted else ""), wanted, Subject(item.name, item), findings
    )
    taken.add(free)
    topics[node, item.name] = free


def _free(name: str, taken: Container[str]) -> str:
    free, number = name, 1
    while free in taken:
        number += 1
        free = f"{name}_{number}"
    return free


def error_topics(part: Part, package: str, statuses: Statuses) -> Iterator[StatusTopic]:
    """The topics of the errors of a node, then those of the errors of others on which something of it depends."""
    own = errors_of(part)
    for error in own:
        yield _end(error.name, statuses.topics[part.name, error.name], PUBLISHER, f"{package}/msg/{ERROR_STATUS.name}",
                   vss_path=error.vss_path)  # fmt: skip
    needed = (*(name for error in own for name in error.dependencies),
              *(name for reaction in reactions_of(part) for name in reaction.errors))  # fmt: skip
    for name in dict.fromkeys(needed):
        if name not in {error.name for error in own}:
            yield _end(name, statuses.topic(name), SUBSCRIPTION, f"{package}/msg/{ERROR_STATUS.name}",
                       provider=optional(statuses.reporters.get(name)))  # fmt: skip


def reaction_topics(part: Part, package: str, statuses: Statuses, manager: Text | None) -> Iterator[StatusTopic]:
    """The topics on which a node publishes its safety reactions, and those on which the platform sends them to it."""
    message = f"{package}/msg/{SAFETY_REACTION.name}"
    own = reactions_of(part)
    for reaction in own:
        yield _end(reaction.name, statuses.topics[part.name, reaction.name], PUBLISHER, message,
                   vss_path=reaction.vss_path)  # fmt: skip
    for reaction in own:
        yield _end(reaction.name, statuses.topics["", reaction.name], SUBSCRIPTION, message,
                   provider=manager, vss_path=reaction.vss_path)  # fmt: skip


def _end(
    interface: str, topic: str, role: str, message: str, *, provider: Text | None = None, vss_path: str | None = None
) -> StatusTopic:
    field = "status" if message.endswith(ERROR_STATUS.name) else "state"
    return StatusTopic(
        interface=interface, topic=topic, role=role, message=message, field=field, provider=provider,
        quality=STATUS, vss_path=vss_path,
    )  # fmt: skip


# -- for people ---------------------------------------------------------------------------------------------------


def diagnostics(part: Part, statuses: Statuses, findings: FindingCollector) -> Iterator[Diagnostic]:
    """The diagnostic statuses of the errors of a node."""
    for error in errors_of(part):
        subject = Subject(error.name, error)
        if error.reset_condition and error.reset is None:
            message = f"{error.name}: `resetCondition` is free text and cannot be checked."
            fix = "Set `reset` to a signal or `restart`; without it, the error resets when its cause is gone."
            findings.report(codes.RESET_CONDITION_IN_WORDS, message, subject, fix, key="ResetCondition")
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
            dependencies=_dependencies(subject, "Dependancy", error.dependencies, statuses, findings),
            vss_path=error.vss_path,
        )


def conditions(
    part: Part, statuses: Statuses, manager: Text | None, table: Mapping[str, Datatype], findings: FindingCollector
) -> Iterator[ConditionMonitor]:
    """The safety conditions of a node."""
    for reaction in reactions_of(part):
        yield ConditionMonitor(
            condition=reaction.name,
            description=reaction.description,
            topic=statuses.topics[part.name, reaction.name],
            statuses=_dependencies(Subject(reaction.name, reaction), "ErrorList", reaction.errors, statuses, findings),
            provider=manager,
            variable_type=c_definition(reaction.datatype, table),
            vss_path=reaction.vss_path,
        )


def _dependencies(
    subject: Subject, key: str, errors: Iterable[str], statuses: Statuses, findings: FindingCollector
) -> tuple[str, ...]:
    """Names of the statuses of errors; of an error from outside of the set, its own name."""
    made = []
    for error in errors:
        if error not in statuses.reporters:
            message = f"{subject} depends on {shortened(error)}, which no function in the set reports."
            fix = f"The node that reports it must publish it on the topic {shortened(statuses.topic(error))!r}, or be remapped."
            findings.report(codes.ERROR_FROM_OUTSIDE, message, subject, fix, key=key)
        made.append(statuses.status(error))
    return tuple(made)
