"""Requirements for ARXML that `autosar-data` does not check by itself."""

from collections import Counter
from collections.abc import Iterable

from autosar_data import AutosarModel, AutosarVersion, ContentMode, Element

VERSIONS = {
    "R20-11": AutosarVersion.AUTOSAR_00049, "R21-11": AutosarVersion.AUTOSAR_00050,
    "R22-11": AutosarVersion.AUTOSAR_00051, "R23-11": AutosarVersion.AUTOSAR_00052,
    "R24-11": AutosarVersion.AUTOSAR_00053,
}  # fmt: skip


def loaded(files) -> AutosarModel:
    """All files in one model, loaded strictly. Raises for an element, an order or a value that the version lacks."""
    model = AutosarModel()
    for file in files:
        _, warnings = model.load_buffer(file.data.decode("utf-8"), file.name, strict=True)
        assert warnings == [], warnings
    return model


def dangling(model: AutosarModel) -> list[str]:
    """References to nothing."""
    return [f"{element.element_name} {element.character_data}" for element in model.check_references()]


def version_of(model: AutosarModel) -> AutosarVersion:
    """The version that all files of a model have."""
    first, *others = [file.version for file in model.files]
    assert all(version == first for version in others)
    return first


def misplaced(model: AutosarModel) -> list[str]:
    """Elements that stand before one that the metamodel of their version wants before them."""
    found = []
    version = version_of(model)
    for _, element in model.elements_dfs:
        if element.element_type.content_mode != ContentMode.Sequence:
            continue
        order = [
            spec.element_name for spec in element.element_type.sub_elements_spec if version in spec.allowed_versions
        ]
        places = [order.index(child.element_name) for child in element.sub_elements]
        if places != sorted(places):
            found.append(element.xml_path)
    return found


def doubled_names(model: AutosarModel) -> list[str]:
    """Paths that two elements have, case aside."""
    return [path for path, count in Counter(path.lower() for path in _paths(model)).items() if count > 1]


def _paths(model: AutosarModel) -> Iterable[str]:
    return [element.path for _, element in model.elements_dfs if element.is_identifiable]


def numbers(model: AutosarModel) -> list[tuple[str, str, str, int]]:
    """Scope, kind, element and number of every SOME/IP id."""
    found = []
    for _, element in model.elements_dfs:
        name = element.element_name
        if name not in ("SERVICE-INTERFACE-ID", "EVENT-ID", "METHOD-ID", "EVENT-GROUP-ID", "SERVICE-INSTANCE-ID"):
            continue
        owner = element.named_parent.path
        scope = "" if name in ("SERVICE-INTERFACE-ID", "SERVICE-INSTANCE-ID") else "/".join(owner.split("/")[:4])
        found.append((scope, name, owner, int(str(element.character_data), 0)))
    return found


def doubled_numbers(model: AutosarModel) -> list[tuple[str, str, int]]:
    """Ids that two elements of one scope have."""
    counted = Counter((scope, kind, number) for scope, kind, _, number in numbers(model))
    return [key for key, count in counted.items() if count > 1]


def without_number(model: AutosarModel) -> list[str]:
    """Deployments that have no id."""
    wanted = {
        "SOMEIP-EVENT-DEPLOYMENT": "EVENT-ID", "NOTIFIER": "EVENT-ID", "SOMEIP-METHOD-DEPLOYMENT": "METHOD-ID",
        "GET": "METHOD-ID", "SOMEIP-EVENT-GROUP": "EVENT-GROUP-ID",
        "SOMEIP-SERVICE-INTERFACE-DEPLOYMENT": "SERVICE-INTERFACE-ID",
    }  # fmt: skip
    return [
        element.path
        for _, element in model.elements_dfs
        if element.element_name in wanted and not _has(element, wanted[element.element_name])
    ]


def _has(element: Element, name: str) -> bool:
    return any(child.element_name == name for child in element.sub_elements)
