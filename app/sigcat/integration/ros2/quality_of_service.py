"""Quality of service: from ASIL, cycle, time-out and queue, by rule.

- reliable where a lost value is not replaced by the next one, or matters: queues, attributes, calls without a cycle,
  ASIL A to D; best effort for QM values that come again in the next cycle.
- transient local where values do not come again: attributes, and publishers without a cycle.
- depth: of queues ten times their length, and 100 at least, on both ends: values received while a process is held up are taken
  later, and the core counts what does not fit into the queue itself; 1 where only the latest value counts.
- deadline: the subscriber's time-out. A publisher offers twice its cycle, so that one lost or late value passes, or
  the shortest time-out of the set's subscribers, if that is shorter.
- liveliness asserted by the publishing call itself for ASIL C and D, by the middleware otherwise.

A subscription hears only publishers that offer what it requests. For a publisher outside of the set this is unknown, so
that its subscriptions request nothing of it that an ordinary one may not offer: the adapter supervises the time-out.
Attributes are the exception: a publisher that does not keep them has nothing for who starts late.
"""

from collections.abc import Sequence

from sigcat.asil import rank
from sigcat.function.document.text import Text
from sigcat.function.exchange import Side
from sigcat.integration.ros2.model import Durability, QualityOfService, Reliability
from sigcat.integration.ros2.settings import QualitySettings, Ros2Settings
from sigcat.integration.ros2.signal_uses import asil_of_side, cycle_of, is_sent_in_each_cycle, timeout_of

MODE = QualityOfService(
    reliability="reliable", durability="transient_local", history="keep_last", depth=1, liveliness="automatic",
    reasons=(Text("A mode is sent once and holds until the next one."),),
)  # fmt: skip
_LEAST_DEPTH = 100
_QUEUES = 10
"""Depth of a queue, and how often its length has room in the middleware."""
STATUS = MODE.model_copy(update={"reasons": (Text("A status is sent on change and holds until the next one."),)})


def quality(mine: Sequence[Side], everyone: Sequence[Side], topic: str, settings: Ros2Settings) -> QualityOfService:
    """Quality of one end of a topic. `mine` are the signals of this end; `everyone` those of every end in the set."""
    reasons: list[str] = []
    asil = max((asil_of_side(use) for use in everyone), key=rank)
    is_heard = any(use.provides for use in everyone)
    is_strict = asil in ("C", "D") and is_heard
    if not is_heard:  # best effort hears a reliable publisher too, and misses values only as the network does
        reliability: Reliability = "best_effort"
        reasons.append("best effort: the publisher is not of the set, and may offer no more")
    elif topic in settings.messages:  # the message exists: nodes that are not of the set know it
        reliability = "reliable"
        reasons.append("reliable: nodes outside of the set subscribe as ROS does by default")
    else:
        reliability = _reliability(everyone, asil, reasons)
    deadline = _deadline(mine, everyone, reasons)
    derived = QualityOfService(
        reliability=reliability,
        durability=_durability(everyone, reasons),
        history="keep_last",
        depth=_depth(mine, everyone, reasons),
        deadline=deadline,
        liveliness="manual_by_topic" if is_strict else "automatic",
        lease_duration=deadline if is_strict else None,
        reasons=tuple(map(Text, reasons)),
    )
    keys = (topic, f"/{topic}", f"{settings.namespace}/{topic}", *(use.path for use in mine))
    return _overridden(derived, [settings.quality[key] for key in dict.fromkeys(keys) if key in settings.quality])


def _reliability(everyone: Sequence[Side], asil: str, reasons: list[str]) -> Reliability:
    causes = (
        (asil != "QM", f"reliable: ASIL {asil}"),
        (any(use.queue_length for use in everyone), "reliable: queued, no value may be lost"),
        (any(use.data.type == "attribute" for use in everyone), "reliable: an attribute is not sent again"),
        (any(use.provides and cycle_of(use) is None for use in everyone), "reliable: the provider has no cycle"),
    )
    for holds, reason in causes:
        if holds:
            reasons.append(reason)
            return "reliable"
    reasons.append("best effort: QM, and the next value replaces a lost one")
    return "best_effort"


def _durability(everyone: Sequence[Side], reasons: list[str]) -> Durability:
    if any(use.data.type == "attribute" or (use.provides and cycle_of(use) is None) for use in everyone):
        reasons.append("transient local: late subscribers need the last value")
        return "transient_local"
    return "volatile"


def _depth(mine: Sequence[Side], everyone: Sequence[Side], reasons: list[str]) -> int:
    relevant = everyone if any(use.provides for use in mine) else mine
    lengths = [use.queue_length for use in relevant if use.queue_length]
    if not lengths:
        reasons.append("depth 1: only the latest value counts")
        return 1
    depth = max(_LEAST_DEPTH, _QUEUES * max(lengths))
    reasons.append(f"depth {depth}: the queue loses values, and counts them, before the middleware does")
    return depth


def _deadline(mine: Sequence[Side], everyone: Sequence[Side], reasons: list[str]) -> float | None:
    timeouts = [each for use in everyone if not use.provides and (each := timeout_of(use))]
    if not any(use.provides for use in mine):
        own = [each for use in mine if (each := timeout_of(use))]
        if own and not _is_offered(mine, everyone):
            reasons.append("no deadline: no publisher of the set offers one; the adapter supervises the time-out")
            return None
        if own:
            reasons.append("deadline: the time-out")
        return min(own, default=None)
    cycles = [2 * cycle for use in mine if (cycle := cycle_of(use))]
    if not cycles:
        return None
    if not any(is_sent_in_each_cycle(use) for use in mine):
        reasons.append("no deadline: a call may have nothing to send")
        return None
    shortest = min([*timeouts, max(cycles)])
    reasons.append("deadline: twice the cycle" if shortest == max(cycles) else "deadline: a subscriber's time-out")
    return shortest


def _is_offered(mine: Sequence[Side], everyone: Sequence[Side]) -> bool:
    """Whether every publisher of the signals is of the set, and sends in each of its cycles."""
    offered = [is_sent_in_each_cycle(use) for use in everyone if use.provides]
    provided = {use.identity for use in everyone if use.provides}
    return bool(offered) and all(offered) and provided >= {use.identity for use in mine}


def _overridden(derived: QualityOfService, settings: Sequence[QualitySettings]) -> QualityOfService:
    changes: dict[str, object] = {}
    for setting in settings:
        changes.update(setting.model_dump(exclude_none=True, by_alias=False))
    if not changes:
        return derived
    if changes.get("deadline") == 0:
        changes["deadline"] = None
    return derived.model_copy(update={**changes, "reasons": (*derived.reasons, Text("as the deployment file says"))})
