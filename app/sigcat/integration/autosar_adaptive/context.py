"""Common input of every step of `derive`: the functions with their components, the settings, the findings."""

from dataclasses import dataclass

from sigcat.function.exchange import Exchange, Part
from sigcat.integration.application import Application
from sigcat.integration.autosar_adaptive.deployment.settings import AutosarAdaptiveSettings
from sigcat.integration.finding_collector import FindingCollector


@dataclass(frozen=True)
class Context:
    """Input of one derivation, and the findings on its way."""

    application: Application
    settings: AutosarAdaptiveSettings
    parts: tuple[Part, ...]
    exchange: Exchange
    findings: FindingCollector
