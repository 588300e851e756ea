"""Common input of every step of `derive`: the functions with their nodes, the settings, the messages, the findings."""

from dataclasses import dataclass

from sigcat.function.exchange import Exchange, Part
from sigcat.integration.application import Application
from sigcat.integration.finding_collector import FindingCollector
from sigcat.integration.ros2.messages.existing_messages import ExistingMessages
from sigcat.integration.ros2.messages.made_messages import MessageBook
from sigcat.integration.ros2.settings import Ros2Settings


@dataclass(frozen=True)
class Context:
    """Input of one derivation, and the messages and findings on its way."""

    application: Application
    settings: Ros2Settings
    existing: ExistingMessages
    package: str
    """Package of the nodes."""
    parts: tuple[Part, ...]
    """Components under the names of their nodes."""
    exchange: Exchange
    book: MessageBook
    findings: FindingCollector
