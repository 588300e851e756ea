"""Common input of every step of `derive`."""

from sigcat.integration.autosar_adaptive.adaptive_types import TypeTable
from sigcat.integration.autosar_adaptive.deployment.settings import AutosarAdaptiveSettings
from sigcat.integration.autosar_context import AutosarContext

Context = AutosarContext[AutosarAdaptiveSettings, TypeTable]
"""Input of one derivation, and the findings on its way."""
