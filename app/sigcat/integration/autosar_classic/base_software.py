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
CLOCK = model.ClientServerInterface(
    name="AdapterClock",
    operations=(
        model.Operation(
            name="GetTime",
            arguments=(model.OperationArgument(name="Time", type="uint64", direction="OUT", unit="ns"),),
            description=Text("Time of the counter that starts timing events: it never goes back, and starts anywhere."),
        ),
    ),
)
IGNITION = model.ClientServerInterface(
    name="AdapterIgnition",
    operations=(
        model.Operation(
            name="GetCycle",
            arguments=(model.OperationArgument(name="Cycle", type="uint32", direction="OUT"),),
            description=Text("Number of the ignition cycle: another one after each start of the vehicle."),
        ),
    ),
)
DIAGNOSTIC_MONITOR = model.ClientServerInterface(
    name="DiagnosticMonitor",
    operations=(
        model.Operation(
            name="SetEventStatus",
            arguments=(model.OperationArgument(name="EventStatus", type="Dem_EventStatusType", direction="IN"),),
            errors=("E_NOT_OK",),
            description=Text("What a test has come to: 0 passed, 1 failed."),
        ),
    ),
    errors=(E_NOT_OK,),
    service="DiagnosticEventManager",
)
SUPERVISION = model.ClientServerInterface(
    name="WdgM_LocalSupervision",
    operations=(
        model.Operation(
            name="CheckpointReached",
            arguments=(),
            errors=("E_NOT_OK",),
            description=Text("A checkpoint was reached: which one, the port says."),
        ),
    ),
    errors=(E_NOT_OK,),
    service="WatchdogManager",
)
NV_MEMORY = model.ClientServerInterface(
    name="NvMService",
    operations=(
        model.Operation(
            name="GetErrorStatus",
            arguments=(model.OperationArgument(name="ErrorStatus", type="NvM_RequestResultType", direction="OUT"),),
            errors=("E_NOT_OK",),
            description=Text("How the last request went: 0, and what is in the block is what was stored."),
        ),
        model.Operation(
            name="SetRamBlockStatus",
            arguments=(model.OperationArgument(name="BlockChanged", type="boolean", direction="IN"),),
            errors=("E_NOT_OK",),
            description=Text("The block has changed, and must be stored at shutdown."),
        ),
    ),
    errors=(E_NOT_OK,),
    service="NvRamManager",
)
SERVICE_TYPES = {"Dem_EventStatusType": "uint8", "NvM_RequestResultType": "uint8"}
"""Datatypes of the base software, and the platform types that they are."""
