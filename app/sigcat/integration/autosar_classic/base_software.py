"""Interfaces of the base software that components use, by the names that its specifications give them."""

from sigcat.function.document.text import Text
from sigcat.integration.autosar_classic import model

ECU_MODES = model.ModeGroup(
    name="EcuM_Mode",
    modes=tuple(
        model.ModeNumber(name=name, value=number)
        for number, name in enumerate(("POST_RUN", "RUN", "SHUTDOWN", "SLEEP", "STARTUP"))
    ),
    initial="STARTUP",
    type="uint8",
    on_transition=5,
)
ECU_MODE = model.ModeSwitchInterface(
    name="EcuM_CurrentMode", group="EcuM_Mode", prototype="currentMode", service="EcuManager"
)
E_NOT_OK = model.ApplicationError(name="E_NOT_OK", value=1)


def _operation(name: str, description: str, *arguments: model.OperationArgument) -> model.Operation:
    return model.Operation(name=name, arguments=arguments, description=Text(description))


def failing_interface(
    name: str, *operations: model.Operation, module: str | None = None
) -> model.ClientServerInterface:
    """An interface of a component, or of a module of the base software, whose operations may fail."""
    failing = tuple(each.model_copy(update={"errors": (E_NOT_OK.name,)}) for each in operations)
    return model.ClientServerInterface(name=name, operations=failing, errors=(E_NOT_OK,), service=module)


_TIME = model.OperationArgument(name="Time", type="uint64", direction="OUT", unit="ns")
_CYCLE = model.OperationArgument(name="Cycle", type="uint32", direction="OUT")
_EVENT_STATUS = model.OperationArgument(name="EventStatus", type="Dem_EventStatusType", direction="IN")
_ERROR_STATUS = model.OperationArgument(name="ErrorStatus", type="NvM_RequestResultType", direction="OUT")
_CHANGED = model.OperationArgument(name="BlockChanged", type="boolean", direction="IN")
_GET_TIME = "Time of the counter that starts timing events: it never goes back, and starts anywhere."
_GET_CYCLE = "Number of the ignition cycle: another one after each start of the vehicle."
CLOCK = model.ClientServerInterface(name="AdapterClock", operations=(_operation("GetTime", _GET_TIME, _TIME),))
IGNITION = model.ClientServerInterface(name="AdapterIgnition", operations=(_operation("GetCycle", _GET_CYCLE, _CYCLE),))
DIAGNOSTIC_MONITOR = failing_interface(
    "DiagnosticMonitor",
    _operation("SetEventStatus", "What a test has come to: 0 passed, 1 failed.", _EVENT_STATUS),
    module="DiagnosticEventManager",
)
SUPERVISION = failing_interface(
    "WdgM_LocalSupervision",
    _operation("CheckpointReached", "A checkpoint was reached: which one, the port says."),
    module="WatchdogManager",
)
NV_MEMORY = failing_interface(
    "NvMService",
    _operation(
        "GetErrorStatus", "How the last request went: 0, and what is in the block is what was stored.", _ERROR_STATUS
    ),
    _operation("SetRamBlockStatus", "The block has changed, and must be stored at shutdown.", _CHANGED),
    module="NvRamManager",
)
SERVICES = (CLOCK, DIAGNOSTIC_MONITOR, IGNITION, NV_MEMORY, SUPERVISION)
SERVICE_TYPES = {"Dem_EventStatusType": "uint8", "NvM_RequestResultType": "uint8"}
"""Datatypes of the base software, and the platform types that they are."""
