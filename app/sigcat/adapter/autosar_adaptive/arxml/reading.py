"""SOME/IP ids of earlier ARXML, by the keys of a deployment: an id catalogue that every project has."""

from collections.abc import Iterator

from autosar_data import AutosarDataError, AutosarModel, Element

from sigcat.adapter.autosar_adaptive.arxml.deployment import DEPLOYMENT, GROUP_SUFFIX
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.someip.id_catalogue import Entry, collected
from sigcat.limits import Limits

_INSTANCES = {
    "PROVIDED-SOMEIP-SERVICE-INSTANCE": "SERVICE-INSTANCE-ID",
    "REQUIRED-SOMEIP-SERVICE-INSTANCE": "REQUIRED-SERVICE-INSTANCE-ID",
}
_OF_FIELD = (("NOTIFIER", "", "EVENT-ID"), ("GET", "Get", "METHOD-ID"), ("SET", "Set", "METHOD-ID"))
"""Parts of the deployment of a field: prefixes of their keys, and elements with their ids."""
_ANY = ("ANY", "ALL")
"""Values of a required instance that replace an id."""


def read_arxml(data: bytes, name: str, limits: Limits) -> dict[str, int]:
    """The ids of the SOME/IP deployments and service instances of a file. Raises InputRefused if it cannot be used."""
    if len(data) > limits.file_bytes:
        raise InputRefused(f"{name} must have at most {limits.file_bytes:,} bytes.")
    model = AutosarModel()
    try:
        model.load_buffer(data.decode("utf-8-sig"), name, strict=False)
    except (AutosarDataError, UnicodeDecodeError) as error:
        raise InputRefused(f"{name} must be ARXML to be used as an id catalogue: {error}") from error
    return collected(_entries(model), name)


def _entries(model: AutosarModel) -> Iterator[Entry]:
    services = [element for _, element in model.elements_dfs if element.element_name == DEPLOYMENT]
    for deployment in services:
        for key, number in _of_service(deployment):
            yield 0, key, number
    names = {deployment.path: _target(deployment, "SERVICE-INTERFACE-REF") for deployment in services}
    stated: set[str] = set()
    for _, element in model.elements_dfs:
        if element.element_name in _INSTANCES:
            service = names.get(_text(element, "SERVICE-INTERFACE-DEPLOYMENT-REF"), "")
            number = _text(element, _INSTANCES[element.element_name])
            # Of several instances of a service the first is that of the component, others are of further processes.
            if service and number and number not in _ANY and service not in stated:
                stated.add(service)
                yield 0, f"{service}:instance", number


def _of_service(deployment: Element) -> Iterator[tuple[str, str]]:
    service = _target(deployment, "SERVICE-INTERFACE-REF")
    yield service, _text(deployment, "SERVICE-INTERFACE-ID")
    for event in _listed(deployment, "EVENT-DEPLOYMENTS"):
        yield f"{service}.{_target(event, 'EVENT-REF')}", _text(event, "EVENT-ID")
    for method in _listed(deployment, "METHOD-DEPLOYMENTS"):
        yield f"{service}.{_target(method, 'METHOD-REF')}", _text(method, "METHOD-ID")
    for group in _listed(deployment, "EVENT-GROUPS"):
        yield f"{service}.{(group.item_name or '').removesuffix(GROUP_SUFFIX)}", _text(group, "EVENT-GROUP-ID")
    for field in _listed(deployment, "FIELD-DEPLOYMENTS"):
        for part, prefix, number in _OF_FIELD:
            found = field.get_sub_element(part)
            if found is not None:
                yield f"{service}.{prefix}{_target(field, 'FIELD-REF')}", _text(found, number)


def _listed(element: Element, tag: str) -> Iterator[Element]:
    found = element.get_sub_element(tag)
    yield from found.sub_elements if found is not None else ()


def _text(element: Element, tag: str) -> str:
    found = element.get_sub_element(tag)
    return "" if found is None or found.character_data is None else str(found.character_data)


def _target(element: Element, tag: str) -> str:
    """Last name in a reference."""
    return _text(element, tag).rpartition("/")[2]
