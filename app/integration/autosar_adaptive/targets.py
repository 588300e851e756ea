"""For every field of every interface of a function: where it stands in the Integration JSON."""

from collections.abc import Sequence

from app.integration.autosar_adaptive.elements import Service
from app.integration.autosar_adaptive.grouping import Placed
from app.integration.autosar_adaptive.work import Work
from app.integration.report import Entry


def report(work: Work, sides: Sequence[Placed], all_services: Sequence[Service]) -> tuple[Entry, ...]:
    return ()
