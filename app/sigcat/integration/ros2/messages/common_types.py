"""Messages and services that every set has: for errors, safety reactions, and a step in time."""

from sigcat.function.document.text import Text
from sigcat.integration.ros2.model import Message, MessageConstant, MessageField, Service

STAMP = MessageField(
    name="stamp",
    datatype="builtin_interfaces/Time",
    description=Text("Time at which the call that wrote the values began."),
)
_TOLD = MessageField(name="stamp", datatype="builtin_interfaces/Time", description=Text("Time at which it was sent."))


def _numbers(*names: str) -> tuple[MessageConstant, ...]:
    return tuple(
        MessageConstant(name=name, datatype="uint8", value=Text(str(value))) for value, name in enumerate(names)
    )


ERROR_STATUS = Message(
    name="ErrorStatus",
    description=Text("Status of an error, published with the first verdict and on change."),
    constants=_numbers("PASSED", "FAILED"),
    fields=(_TOLD, MessageField(name="status", datatype="uint8", description=Text("PASSED or FAILED."))),
)
SAFETY_REACTION = Message(
    name="SafetyReaction",
    description=Text("Whether a safety condition holds, published at the start and on change."),
    constants=_numbers("INACTIVE", "ACTIVE"),
    fields=(_TOLD, MessageField(name="state", datatype="uint8", description=Text("INACTIVE or ACTIVE."))),
)
STEP = Service(
    name="Step",
    description=Text(
        "Gives a node in lock-step its time. The node waits until it has taken `received` messages, runs all that "
        "is due at its present time, then sets its time to `time`."
    ),
    request=(
        MessageField(
            name="received",
            datatype="uint64",
            description=Text("Messages that it has taken in all since it was configured."),
        ),
        MessageField(
            name="time", datatype="uint64", description=Text("Its time afterwards, since activation."), units="ns"
        ),
        MessageField(
            name="only_wait",
            datatype="bool",
            description=Text("Whether it only waits: nothing runs, and its time stays."),
        ),
    ),
    response=(
        MessageField(
            name="success", datatype="bool", description=Text("Whether it has taken so many messages in time.")
        ),
        MessageField(name="message", datatype="string", description=Text("Why not.")),
        MessageField(name="received", datatype="uint64", description=Text("Messages that it has taken in all.")),
        MessageField(name="sent", datatype="uint64", description=Text("Messages that it has published in all.")),
        MessageField(
            name="next",
            datatype="uint64",
            description=Text("Its time when it runs next, as far as it knows now; what is past, or 0, says nothing."),
            units="ns",
        ),
    ),
)
