"""Messages and services that every set has: for errors, safety reactions, and a step in time."""

from sigcat.function.document.text import Text
from sigcat.integration.ros2.model import Message, MessageConstant, MessageField, Service


def _field(name: str, datatype: str, description: str, units: str | None = None) -> MessageField:
    return MessageField(name=name, datatype=datatype, description=Text(description), units=units)


def _numbers(*names: str) -> tuple[MessageConstant, ...]:
    return tuple(
        MessageConstant(name=name, datatype="uint8", value=Text(str(value))) for value, name in enumerate(names)
    )


STAMP = _field("stamp", "builtin_interfaces/Time", "Time at which the call that wrote the values began.")
_TOLD = _field("stamp", "builtin_interfaces/Time", "Time at which it was sent.")
ERROR_STATUS = Message(
    name="ErrorStatus",
    description=Text("Status of an error, published with the first verdict and on change."),
    constants=_numbers("PASSED", "FAILED"),
    fields=(_TOLD, _field("status", "uint8", "PASSED or FAILED.")),
)
SAFETY_REACTION = Message(
    name="SafetyReaction",
    description=Text("Whether a safety condition holds, published at the start and on change."),
    constants=_numbers("INACTIVE", "ACTIVE"),
    fields=(_TOLD, _field("state", "uint8", "INACTIVE or ACTIVE.")),
)
STEP = Service(
    name="Step",
    description=Text(
        "Gives a node in lock-step its time. The node waits until it has taken `received` messages, runs all that "
        "is due at its present time, then sets its time to `time`."
    ),
    request=(
        _field("received", "uint64", "Messages that it has taken in all since it was configured."),
        _field("time", "uint64", "Its time afterwards, since activation.", "ns"),
        _field("only_wait", "bool", "Whether it only waits: nothing runs, and its time stays."),
    ),
    response=(
        _field("success", "bool", "Whether it has taken so many messages in time."),
        _field("message", "string", "Why not."),
        _field("received", "uint64", "Messages that it has taken in all."),
        _field("sent", "uint64", "Messages that it has published in all."),
        _field(
            "next",
            "uint64",
            "Its time when it runs next, as far as it knows now; what is past, or 0, says nothing.",
            "ns",
        ),
    ),
)
