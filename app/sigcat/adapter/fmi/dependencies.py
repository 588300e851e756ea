"""Inputs on which outputs of an FMU depend: those of the function that sends, and of functions that it hears from."""

from collections.abc import Mapping

from sigcat.adapter.fmi.variables import Layout
from sigcat.adapter.host.connections import Connections


def dependencies(connections: Connections, layout: Layout) -> Mapping[int, tuple[int, ...]]:
    """Return the value references of inputs by that of each output, after that of the time: schedules depend on it."""
    heard = _heard(connections)
    entry_of = {reference: each.owner for reference, each in enumerate(layout.variables) if each.causality == "input"}
    receivers: dict[int, set[int]] = {}
    for entry, place in zip(connections.entries, layout.inputs, strict=True):
        receivers.setdefault(place.variable, set()).add(entry.member)
    return {
        output: (
            0,
            *(
                number
                for number, entry in entry_of.items()
                if receivers[entry] & heard[connections.exits[each.owner].member]
            ),
        )
        for output, each in enumerate(layout.variables)
        if each.causality == "output"
    }


def _heard(connections: Connections) -> Mapping[int, set[int]]:
    """Return each function with those whose values reach it."""
    heard = {member: {member} for member in range(len(connections.members))}
    links = {
        (connections.exits[index].member, connections.entries[target].member)
        for index, targets in enumerate(connections.routes)
        for target in targets
    }
    for entry, server in connections.servers.items():  # an answer depends on what was asked
        links |= {
            (server.member, connections.entries[entry].member),
            (connections.entries[entry].member, server.member),
        }
    for _ in heard:
        for source, target in links:
            heard[target] |= heard[source]
    return heard
