"""Common input of every step of `derive`: the functions with their components, the settings, the findings."""

from dataclasses import dataclass

from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.integration.application import Application, Part
from sigcat.integration.autosar_adaptive.settings import AutosarAdaptiveSettings
from sigcat.integration.autosar_parts import Item
from sigcat.integration.finding_collector import FindingCollector


@dataclass(frozen=True)
class Context:
    """Input of one derivation, and the findings on its way."""

    application: Application
    settings: AutosarAdaptiveSettings
    parts: tuple[Part, ...]
    findings: FindingCollector

    def path_of(self, item: Item) -> str:
        """VSS path of a data interface, its own or the one that the deployment gives; empty if there is none."""
        interface = item.interface
        assert isinstance(interface, Signal | DataQueue)
        return interface.vss_path or self.application.paths.get(f"{item.part.function_name}.{interface.name}", "")
