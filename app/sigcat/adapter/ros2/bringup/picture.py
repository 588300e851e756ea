"""The graph of a set as a Mermaid picture."""

from collections.abc import Iterator, Mapping

from sigcat.adapter.ros2.bringup.graph import edges_of, publishers_of, subscribers_of
from sigcat.adapter.ros2.plan import WorkspacePlan

OUTSIDE = "outside of the set"


def picture(workspace: WorkspacePlan, providers: Mapping[str, str]) -> str:
    """The picture: nodes, who is outside, and topics and services between them. `providers` are who is outside, by topic."""
    outside = {name: f"outside{number}" for number, name in enumerate(_outsiders(workspace, providers), 1)}
    lines = [
        "flowchart LR",
        *(f'  {node.stem}(["{node.name}"])' for node in workspace.nodes),
        *(f'  {key}["{_label(name)}"]' for name, key in outside.items()),
        *_arrows(workspace, providers, outside),
        *(_request(asks, services, answers, outside) for (asks, answers), services in _services(workspace).items()),
    ]
    return "\n".join(lines) + "\n"


def _outsiders(workspace: WorkspacePlan, providers: Mapping[str, str]) -> tuple[str, ...]:
    """Who publishes to the set, in the order of the topics; then who hears what no node of the set does."""
    known, heard = publishers_of(workspace), subscribers_of(workspace)
    sources = [providers.get(topic, OUTSIDE) for topic in heard if topic not in known]
    is_told = any(end.topic not in heard for node in workspace.nodes for end in node.publishers if not end.is_status)
    is_asked = any(None in ends for ends in _services(workspace))
    return tuple(dict.fromkeys([*sources, *([OUTSIDE] if is_told or is_asked else [])]))


def _arrows(workspace: WorkspacePlan, providers: Mapping[str, str], outside: Mapping[str, str]) -> Iterator[str]:
    known, heard = publishers_of(workspace), subscribers_of(workspace)
    for node in workspace.nodes:
        sources: dict[str, list[str]] = {}
        for end in node.subscriptions:
            if end.topic not in known:
                sources.setdefault(providers.get(end.topic, OUTSIDE), []).append(end.topic)
        for source, topics in sources.items():
            yield _arrow(outside[source], topics, node.stem)
    stems = {node.name: node.stem for node in workspace.nodes}
    for edge in edges_of(workspace):
        yield _arrow(stems[edge.source], edge.topics, stems[edge.target])
    for node in workspace.nodes:
        told = [end.topic for end in node.publishers if not end.is_status and end.topic not in heard]
        if told:
            yield _arrow(node.stem, told, outside[OUTSIDE])


def _arrow(source: str, topics: list[str] | tuple[str, ...], target: str) -> str:
    return f'  {source} -- "{"<br>".join(topics)}" --> {target}'


def _label(text: str) -> str:
    words = " ".join("".join(each if each.isprintable() else " " for each in text).split())
    return "".join(each if each.isalnum() or each in " .,;:_-/" else f"#{ord(each)};" for each in words)


def _services(workspace: WorkspacePlan) -> Mapping[tuple[str | None, str | None], list[str]]:
    """Services between who asks and who answers; None is who is outside."""
    asking = [(node.stem, each.topic) for node in workspace.nodes for each in node.used]
    answering = [(node.stem, each.topic) for node in workspace.nodes for each in node.offered]
    found: dict[tuple[str | None, str | None], list[str]] = {}
    for stem, topic in asking:
        targets: list[str | None] = [other for other, offered in answering if offered == topic]
        for target in targets or [None]:
            found.setdefault((stem, target), []).append(topic)
    for stem, topic in answering:
        if topic not in {used for _, used in asking}:
            found.setdefault((None, stem), []).append(topic)
    return found


def _request(asks: str | None, services: list[str], answers: str | None, outside: Mapping[str, str]) -> str:
    return f'  {asks or outside[OUTSIDE]} -. "{"<br>".join(services)}" .-> {answers or outside[OUTSIDE]}'
