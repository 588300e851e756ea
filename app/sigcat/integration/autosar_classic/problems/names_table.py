"""Names in the document: those of one namespace differ, and each reference is to a name that is there."""

from sigcat.integration.references import Reference

_COMPONENT = "Components/*/"
_ENTITY = "Components/*/SupervisedEntities/*/"
_INTERFACES = ("SenderReceiverInterfaces", "ClientServerInterfaces", "ModeSwitchInterfaces", "ParameterInterfaces")
_IN_COMPONENT = ("Runnables", "Events", "ExclusiveAreas", "PerInstanceMemories", "InternalParameters")

SINGLE_NAMES = ("ClassicDeployment/Package", "Composition/Name", "Ecu/Name")
"""Names outside of lists."""
NAMESPACES: tuple[tuple[str, ...], ...] = (
    ("ImplementationTypes",),
    ("ApplicationTypes",),
    ("ModeGroups",),
    ("Components", "ParameterComponents"),
    ("CompuMethods",),
    ("Units",),
    ("DataConstraints",),
    _INTERFACES,
    ("ImplementationTypes/*/Members",),
    ("ApplicationTypes/*/Members",),
    ("ModeGroups/*/Modes",),
    ("SenderReceiverInterfaces/*/Elements",),
    ("ParameterInterfaces/*/Elements",),
    ("ClientServerInterfaces/*/Operations",),
    ("ClientServerInterfaces/*/Operations/*/Arguments",),
    ("ClientServerInterfaces/*/ApplicationErrors",),
    ("Components/*/Ports",),
    ("ParameterComponents/*/Ports",),
    tuple(f"{_COMPONENT}{each}" for each in _IN_COMPONENT),
    ("Components/*/MemorySections",),
    ("Components/*/Runnables/*/Accesses",),
    ("Components/*/NvBlocks",),
    ("Components/*/DiagnosticEvents",),
    ("Components/*/SupervisedEntities",),
    ("Components/*/SupervisedEntities/*/Checkpoints",),
    ("Components/*/Inhibitions",),
    ("Composition/Components", "Composition/Ports", "Composition/Assemblies", "Composition/Delegations"),
    ("Ecu/Tasks",),
    ("Ecu/InitBatches",),
)
"""Lists of elements with a name, of which no two in one space have the same."""

_UNITS, _METHODS, _GROUPS = ("Units/*/Name",), ("CompuMethods/*/Name",), ("ModeGroups/*/Name",)
_TYPES = ("ImplementationTypes/*/Name",)
_MEANINGS = (*_TYPES, "ApplicationTypes/*/Name")
_COMPONENT_TYPES = ("Components/*/Name", "ParameterComponents/*/Name")
_RUNNABLES, _MEMORIES = ("Components/*/Runnables/*/Name",), ("Components/*/PerInstanceMemories/*/Name",)
_POINTS = (f"{_ENTITY}Checkpoints/*/Name",)
_COUNTED = "error of a diagnostic event of the component"
_ERRORS = "ClientServerInterfaces/*/Operations/*/PossibleErrors/*"

REFERENCES = (
    Reference("CompuMethods/*/Unit", "unit", _UNITS),
    Reference("ApplicationTypes/*/Unit", "unit", _UNITS),
    Reference("ImplementationTypes/*/CompuMethod", "compu method", _METHODS),
    Reference("ApplicationTypes/*/CompuMethod", "compu method", _METHODS),
    Reference("ApplicationTypes/*/DataConstraint", "data constraint", ("DataConstraints/*/Name",)),
    Reference("ApplicationTypes/*/ImplementationType", "implementation type", _TYPES),
    Reference("SenderReceiverInterfaces/*/Elements/*/Type", "datatype", _MEANINGS),
    Reference("ParameterInterfaces/*/Elements/*/Type", "datatype", _MEANINGS),
    Reference("ClientServerInterfaces/*/Operations/*/Arguments/*/Type", "implementation type", _TYPES),
    Reference(_ERRORS, "application error of the interface", ("ClientServerInterfaces/*/ApplicationErrors/*/Name",)),
    Reference("ModeSwitchInterfaces/*/ModeGroup", "mode group", _GROUPS),
    Reference("ModeGroups/*/InitialMode", "mode of the group", ("ModeGroups/*/Modes/*/Name",)),
    Reference("Components/*/Runnables/*/ExclusiveAreas/*", "exclusive area", ("Components/*/ExclusiveAreas/*/Name",)),
    Reference("Components/*/Events/*/Runnable", "runnable", _RUNNABLES),
    Reference("Components/*/NvBlocks/*/PerInstanceMemory", "per-instance memory", _MEMORIES),
    Reference("Components/*/NvBlocks/*/Errors/*", _COUNTED, ("Components/*/DiagnosticEvents/*/Error",)),
    Reference(f"{_ENTITY}Alive/*/Checkpoint", "checkpoint", _POINTS),
    Reference(f"{_ENTITY}Deadline/*/Start", "checkpoint", _POINTS),
    Reference(f"{_ENTITY}Deadline/*/End", "checkpoint", _POINTS),
    Reference(f"{_ENTITY}Logical/*/Source", "checkpoint", _POINTS),
    Reference(f"{_ENTITY}Logical/*/Target", "checkpoint", _POINTS),
    Reference("Composition/Components/*/Type", "component type", _COMPONENT_TYPES),
)
