"""The README of the test RTE."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.test_rte.plan import Scheduled, TestRte
from sigcat.adapter.templates import rendered

_TEMPLATE = "adapter/autosar_classic/test_rte/README.md.j2"


class _Readme(NamedTuple):
    name: str
    scheduled: Sequence[Scheduled]


def readme(rte: TestRte) -> str:
    """README.md."""
    of_batches = (each for batch in rte.batches.values() for each in batch)
    return rendered(_TEMPLATE, _Readme(rte.model.info.name, (*of_batches, *rte.scheduled)))
