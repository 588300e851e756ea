"""Names in C++ that a generator of ara::com gives: header files, namespaces, classes, members, instances.

The names are those that AUTOSAR R23-11 (SWS_CM, Communication Management) prescribes for the elements of the ARXML, so that
an application compiles against the proxies and skeletons of any vendor's generator.
"""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.arxml.components import port_name, root_name
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.model import Component, IntegrationModel, ServiceInterface
from sigcat.integration.datatypes import BY_ADAPTIVE

TEXT = "string"
"""Word for a text: the only primitive that the ARXML declares in the namespace of the datatypes."""


class ServiceNames(NamedTuple):
    """Generated names of a service interface."""

    stem: str
    """Upper camel case of the short name."""
    namespace: tuple[str, ...]
    folders: tuple[str, ...]
    """Folders of its headers."""

    @property
    def variable(self) -> str:
        """The stem in lower camel case."""
        return f"{self.stem[:1].lower()}{self.stem[1:]}"

    @property
    def common_header(self) -> str:
        """Header that proxy and skeleton share, as it is included."""
        return self._header("common")

    @property
    def proxy_header(self) -> str:
        """Header of the proxy, as it is included."""
        return self._header("proxy")

    @property
    def skeleton_header(self) -> str:
        """Header of the skeleton, as it is included."""
        return self._header("skeleton")

    @property
    def proxy_class(self) -> str:
        """Name of the proxy within its namespace."""
        return f"{self.stem}Proxy"

    @property
    def skeleton_class(self) -> str:
        """Name of the skeleton within its namespace."""
        return f"{self.stem}Skeleton"

    @property
    def proxy(self) -> str:
        """The proxy with its namespaces."""
        return "::".join((*self.namespace, "proxy", self.proxy_class))

    @property
    def skeleton(self) -> str:
        """The skeleton with its namespaces."""
        return "::".join((*self.namespace, "skeleton", self.skeleton_class))

    def element(self, side: str, kind: str, name: str) -> str:
        """The class of an element with its namespaces; side: proxy or skeleton; kind: events, fields or methods."""
        return "::".join((*self.namespace, side, kind, member_name(name)))

    def _header(self, kind: str) -> str:
        return "/".join((*self.folders, f"{self.stem.lower()}_{kind}.h"))


def service_names(service: Whole, model: IntegrationModel) -> ServiceNames:
    """The names of a service; its namespace may be its own."""
    namespace = tuple(parts(service.namespace)) if service.namespace else ()
    return ServiceNames(member_name(service.name), namespace, _folders(namespace, model))


def _folders(namespace: tuple[str, ...], model: IntegrationModel) -> tuple[str, ...]:
    assert model.deployment is not None
    return namespace if model.deployment.header_folders == "namespaces" else ()


def member_name(short_name: str) -> str:
    """Class and member of an event, a field or a method: the short name in upper camel case.

    A short name begins with a letter and may have underscores, which upper camel case leaves where they are.
    """
    return short_name[:1].upper() + short_name[1:]


class TypeNames(NamedTuple):
    """Namespace and headers of the implementation datatypes of a document."""

    namespace: tuple[str, ...]
    folders: tuple[str, ...]
    """Folders of the headers."""

    def header(self, word: str) -> str:
        """Header of a datatype of the document, as it is included; of `string` too."""
        return "/".join((*self.folders, f"impl_type_{self.name(word).lower()}.h"))

    def name(self, word: str) -> str:
        """Name of a datatype within its namespace."""
        return BY_ADAPTIVE[TEXT].autosar if word == TEXT else word

    def type(self, word: str) -> str:
        """The datatype with its namespaces; numbers are those of the standard library."""
        row = BY_ADAPTIVE.get(word)
        if row is not None and word != TEXT:
            return row.cpp
        return "::".join((*self.namespace, self.name(word)))

    def headers(self, words: Iterable[str]) -> list[str]:
        """Headers of those words that have one, each once, sorted."""
        return sorted({self.header(word) for word in words if word == TEXT or word not in BY_ADAPTIVE})


def type_names(model: IntegrationModel) -> TypeNames:
    """The names of the datatypes of a document."""
    assert model.deployment is not None
    chosen = model.deployment.type_namespace or model.deployment.namespace
    namespace = tuple(parts(chosen)) if chosen else ()
    return TypeNames(namespace, _folders(namespace, model))


def instance_specifier(component: Component, interface: ServiceInterface) -> str:
    """Text of `ara::core::InstanceSpecifier` for a port: executable, root component and port.

    ```python
    instance_specifier(component, interface)  # "CoreAccExecutable/CoreAcc_Root/CoreAccService_PPort"
    ```
    """
    return "/".join((component.executable, root_name(component), port_name(interface)))
