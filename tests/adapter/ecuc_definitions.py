"""Definitions of parameters that every vendor has (AUTOSAR_SWS_RTE and AUTOSAR_SWS_OS), as far as values refer to them."""

from typing import Any

from autosar_data import AutosarModel

from sigcat.adapter.files import GeneratedFile

CONTAINER, CHOICE = "ECUC-PARAM-CONF-CONTAINER-DEF", "ECUC-CHOICE-CONTAINER-DEF"
INTEGER, FLOAT = "ECUC-INTEGER-PARAM-DEF", "ECUC-FLOAT-PARAM-DEF"
ENUMERATION = "ECUC-ENUMERATION-PARAM-DEF"
REFERENCE, FOREIGN = "ECUC-REFERENCE-DEF", "ECUC-FOREIGN-REFERENCE-DEF"

TABLE: dict[str, dict[str, tuple[str, Any]]] = {
    "Rte": {
        "RteInitializationRunnableBatch": (CONTAINER, {}),
        "RteOsInteraction": (CONTAINER, {
            "RteUsedOsActivation": (CONTAINER, {
                "RteExpectedActivationOffset": (FLOAT, None),
                "RteExpectedTickDuration": (FLOAT, None),
                "RteActivationOsAlarmRef": (REFERENCE, "Os/OsAlarm"),
            }),
        }),
        "RteSwComponentInstance": (CONTAINER, {
            "RteSoftwareComponentInstanceRef": (FOREIGN, "SW-COMPONENT-PROTOTYPE"),
            "RteEventToTaskMapping": (CONTAINER, {
                "RtePositionInTask": (INTEGER, 65535),
                "RteActivationOffset": (FLOAT, None),
                "RteEventRef": (FOREIGN, "RTE-EVENT"),
                "RteMappedToTaskRef": (REFERENCE, "Os/OsTask"),
                "RteUsedInitFnc": (REFERENCE, "Rte/RteInitializationRunnableBatch"),
                "RteUsedOsAlarmRef": (REFERENCE, "Os/OsAlarm"),
                "RteUsedOsEventRef": (REFERENCE, "Os/OsEvent"),
            }),
            "RteExclusiveAreaImplementation": (CONTAINER, {
                "RteExclusiveAreaImplMechanism": (ENUMERATION, (
                    "ALL_INTERRUPT_BLOCKING", "COOPERATIVE_RUNNABLE_PLACEMENT", "OS_INTERRUPT_BLOCKING", "OS_RESOURCE",
                    "OS_SPINLOCK",
                )),
                "RteExclusiveAreaRef": (FOREIGN, "EXCLUSIVE-AREA"),
            }),
        }),
    },
    "Os": {
        "OsTask": (CONTAINER, {
            "OsTaskActivation": (INTEGER, 2**32 - 1),
            "OsTaskPriority": (INTEGER, 2**32 - 1),
            "OsTaskSchedule": (ENUMERATION, ("FULL", "NON")),
            "OsTaskEventRef": (REFERENCE, "Os/OsEvent"),
        }),
        "OsEvent": (CONTAINER, {}),
        "OsCounter": (CONTAINER, {
            "OsCounterMaxAllowedValue": (INTEGER, 2**64 - 1),
            "OsCounterMinCycle": (INTEGER, 2**64 - 1),
            "OsCounterTicksPerBase": (INTEGER, 2**32 - 1),
            "OsCounterType": (ENUMERATION, ("HARDWARE", "SOFTWARE")),
            "OsSecondsPerTick": (FLOAT, None),
        }),
        "OsAlarm": (CONTAINER, {
            "OsAlarmCounterRef": (REFERENCE, "Os/OsCounter"),
            "OsAlarmAction": (CHOICE, {
                "OsAlarmActivateTask": (CONTAINER, {"OsAlarmActivateTaskRef": (REFERENCE, "Os/OsTask")}),
                "OsAlarmSetEvent": (CONTAINER, {
                    "OsAlarmSetEventRef": (REFERENCE, "Os/OsEvent"),
                    "OsAlarmSetEventTaskRef": (REFERENCE, "Os/OsTask"),
                }),
            }),
        }),
    },
}  # fmt: skip
"""Kind of each definition, and what is in it or what it allows."""

_LISTS = {INTEGER: "PARAMETERS", FLOAT: "PARAMETERS", ENUMERATION: "PARAMETERS", REFERENCE: "REFERENCES",
          FOREIGN: "REFERENCES", CONTAINER: "SUB-CONTAINERS", CHOICE: "SUB-CONTAINERS"}  # fmt: skip


def definitions(version) -> GeneratedFile:
    """The definitions as a file of a version."""
    model = AutosarModel()
    file = model.create_file("definitions.arxml", version)
    packages = model.root_element.create_sub_element("AR-PACKAGES")
    outer = packages.create_named_sub_element("AR-PACKAGE", "AUTOSAR").create_sub_element("AR-PACKAGES")
    elements = outer.create_named_sub_element("AR-PACKAGE", "EcucDefs").create_sub_element("ELEMENTS")
    for module, containers in TABLE.items():
        made = elements.create_named_sub_element("ECUC-MODULE-DEF", module).create_sub_element("CONTAINERS")
        for name, (kind, inner) in containers.items():
            _fill(made.create_named_sub_element(kind, name), kind, inner)
    return GeneratedFile("definitions.arxml", file.serialize().encode())


def _fill(element, kind, inner) -> None:
    if not isinstance(inner, dict):
        return
    for name, (inner_kind, content) in inner.items():
        place = "CHOICES" if kind == CHOICE else _LISTS[inner_kind]
        _fill(element.get_or_create_sub_element(place).create_named_sub_element(inner_kind, name), inner_kind, content)


def _definition(path: list[str]) -> tuple[str, Any]:
    found: tuple[str, Any] = (CONTAINER, TABLE[path[0]])
    for name in path[1:]:
        found = found[1][name]
    return found


def wrong_values(model) -> list[str]:
    """Values whose definition is of another kind, and references to what their definition does not allow."""
    found = []
    for _, element in model.elements_dfs:
        if (
            element.element_name != "DEFINITION-REF"
            or element.parent.element_name == "ECUC-MODULE-CONFIGURATION-VALUES"
        ):
            continue
        parts = str(element.character_data).removeprefix("/AUTOSAR/EcucDefs/").split("/")
        try:
            kind, allowed = _definition(parts)
        except KeyError:
            found.append(f"no definition {'/'.join(parts)}")
            continue
        if element.attribute_value("DEST") != kind or not _fits(element.parent, kind, allowed):
            found.append(f"{element.xml_path} {'/'.join(parts)}")
        above = element.parent.named_parent.get_sub_element("DEFINITION-REF")
        if element.parent.element_name.startswith("ECUC-") and element.parent.element_name != "ECUC-CONTAINER-VALUE":
            above = element.named_parent.get_sub_element("DEFINITION-REF")
        if above is not None and str(above.character_data) != str(element.character_data).rpartition("/")[0]:
            found.append(f"{element.xml_path} is in {above.character_data}")
    return found


def _fits(value, kind, allowed):
    text = value.get_sub_element("VALUE")
    if kind == INTEGER:
        return text is not None and 0 <= int(str(text.character_data)) <= allowed
    if kind == FLOAT:
        return text is not None and float(str(text.character_data)) >= 0
    if kind == ENUMERATION:
        return text is not None and str(text.character_data) in allowed
    if kind in (REFERENCE, FOREIGN):
        target = value.get_sub_element("VALUE-REF").reference_target
        if kind == FOREIGN:
            return target.element_name == allowed or (allowed == "RTE-EVENT" and target.element_name.endswith("-EVENT"))
        return str(target.get_sub_element("DEFINITION-REF").character_data) == f"/AUTOSAR/EcucDefs/{allowed}"
    return True
