"""The graph of a set as a Mermaid picture: nodes are round, and their topics are in boxes between them."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from sigcat.adapter.ros2.bringup.graph import publishers_of, subscribers_of
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.function.document.text_filters import AnyText

OUTSIDE = "outside of the set"


class End(NamedTuple):
    """A node of the set, or who is outside: in front of it, or behind. One who is both is drawn twice, so that lines lead onward."""

    name: AnyText
    place: Literal["set", "before", "behind"] = "set"


class Link(NamedTuple):
    """Edges with the same ends: names of topics, or of services."""

    sources: tuple[End, ...]
    names: tuple[str, ...]
    targets: tuple[End, ...]


BEFORE = End(OUTSIDE, "before")
BEHIND = End(OUTSIDE, "behind")


class Picture(NamedTuple):
    """Plan of the picture: its ends with their names in the source of the picture, and its links."""

    outside: Mapping[End, str]
    nodes: Mapping[End, str]
    topics: Sequence[Link]
    services: Sequence[Link]

    @property
    def names(self) -> Mapping[End, str]:
        """Names of all ends."""
        return {**self.nodes, **self.outside}


def picture(workspace: WorkspacePlan, providers: Mapping[str, AnyText]) -> Picture:
    """The picture. `providers` are who is outside, by topic."""
    topics, services = _bundled(_topics(workspace, providers)), _bundled(_services(workspace))
    nodes = {End(node.name): node.stem for node in workspace.nodes}
    ends = (end for link in (*topics, *services) for end in (*link.sources, *link.targets) if end not in nodes)
    outside = {end: f"outside{number}" for number, end in enumerate(dict.fromkeys(ends), 1)}
    return Picture(outside, nodes, topics, services)


def _topics(workspace: WorkspacePlan, providers: Mapping[str, AnyText]) -> Iterator[Link]:
    """Each topic that a node of the set hears; then those that others may hear, and that do not only tell how a node is."""
    known, heard = publishers_of(workspace), subscribers_of(workspace)
    for topic, nodes in heard.items():
        sources = tuple(map(End, known.get(topic, ()))) or (End(providers.get(topic, OUTSIDE), "before"),)
        yield Link(sources, (topic,), tuple(map(End, nodes)))
    told = [end.topic for node in workspace.nodes for end in node.publishers if not end.is_status]
    for topic in dict.fromkeys(told):
        if topic not in heard:
            yield Link(tuple(map(End, known[topic])), (topic,), (BEHIND,))


def _services(workspace: WorkspacePlan) -> Iterator[Link]:
    """Each service, from the client to the server."""
    asking: dict[str, list[End]] = {}
    answering: dict[str, list[End]] = {}
    for node in workspace.nodes:
        for used in node.used:
            asking.setdefault(used.topic, []).append(End(node.name))
        for offered in node.offered:
            answering.setdefault(offered.topic, []).append(End(node.name))
    for service in asking | answering:
        yield Link(tuple(asking.get(service, [BEFORE])), (service,), tuple(answering.get(service, [BEHIND])))


def _bundled(links: Iterator[Link]) -> Sequence[Link]:
    """Links between the same ends as one."""
    found: dict[tuple[tuple[End, ...], tuple[End, ...]], Link] = {}
    for link in links:
        ends = link.sources, link.targets
        known = found.get(ends)
        found[ends] = link if known is None else known._replace(names=known.names + link.names)
    return tuple(found.values())
