"""The README of the test RTE."""

from sigcat.adapter.autosar_classic.test_rte.plan import TestRte
from sigcat.adapter.templates import rendered

_TEMPLATE = "adapter/autosar_classic/test_rte/README.md.j2"


def readme(rte: TestRte) -> str:
    """README.md."""
    of_batches = (each for batch in rte.batches.values() for each in batch)
    return rendered(_TEMPLATE, name=rte.model.info.name, scheduled=(*of_batches, *rte.scheduled))
