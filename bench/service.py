"""Measure the service as it is shipped, its log on: on one core, load from the other, the floor in the same run.

Rates are requests in a second of the server's processor, which is what one core serves: they hold on a busy machine, too.
Posted texts are work for separate processes, which use every core: their time is that of the whole machine.
"""

import sys
from collections.abc import Iterator, Sequence
from itertools import cycle, islice
from random import Random
from statistics import median

from bench.clients import request, sent
from bench.servers import FLOOR, SERVICE, Server, server
from sigcat.data import ROOT_FILE

Row = tuple[str, str, str, str, str, bool]
_VSS = "/api/v1/catalogues/vss"
_OVERLAY = "".join(
    f"Vehicle.Bench{n}:\n  type: sensor\n  datatype: float\n  unit: km/h\n  description: Signal number {n} of a test.\n\n"
    for n in range(20)
)


def rows(runs: int, count: int = 5000) -> Iterator[Row]:
    """Work, figure, reference, ratio, target and whether it is met, for each row."""
    # the same tree under several names, so that each run can ask for what was never asked before
    fresh = [f"run{number}" for number in range(runs)]
    named = [option for name in fresh for option in ("--catalogue", f"{name}={ROOT_FILE}")]
    with server(FLOOR) as floor, server(SERVICE, *named) as service:
        yield from _reading(floor, service, fresh, count)
    with server(SERVICE, is_on_one_core=False) as service:
        yield from _posting(service, runs, count // 10)
    yield memory()


def memory(count: int = 20_000) -> Row:
    """Mixed requests, as many as a busy hour has: what the process holds at their end, and what in their middle."""
    with server(SERVICE) as service:
        requests = _mixed(service.place)
        held = []
        for _ in range(2):
            sent(service.place, islice(requests, count // 2))
            held.append(service.memory)
        middle, end = held
    return (
        f"memory after {count:,} mixed requests", f"{end / 1e6:.0f} MB", f"in the middle: {middle / 1e6:.0f} MB",
        f"{end / middle:.2f} ×", "at most 1.10 ×", end <= 1.1 * middle,
    )  # fmt: skip


def _reading(floor: Server, service: Server, fresh: Sequence[str], count: int) -> Iterator[Row]:
    paths = _paths()
    nodes = [f"{_VSS}/nodes/{path}" for path in paths]
    words = iter([f"{_VSS}/search?q={word}" for word in reversed(_words(paths))])
    tag = (("If-None-Match", _tag(service, nodes[0])),)
    sent(
        service.place,
        [request(service.place, asked) for asked in (*nodes, *(_VSS.replace("vss", name) for name in fresh))],
    )
    for work, least, headers, addresses in (
        ("node by path, kept", 0.6, (), [list(islice(cycle(nodes), count)) for _ in fresh]),
        ("node by path, never asked before", 0.25, (), [_moved(nodes, name) for name in fresh]),
        ("304", 0.6, tag, [list(islice(cycle(nodes), count)) for _ in fresh]),
        ("search of the standard tree, never asked before", 0.1, (), [list(islice(words, count // 5)) for _ in fresh]),
    ):
        rates = [(_rate(service, asked, headers), _rate(floor, ["/floor"] * count)) for asked in addresses]
        rate, reference = (median(taken) for taken in zip(*rates, strict=True))
        ratio = median(ours / other for ours, other in rates)
        yield (
            work,
            f"{rate:.0f}/s",
            f"prebuilt bytes: {reference:.0f}/s",
            f"{ratio:.2f} ×",
            f"at least {least} ×",
            ratio >= least,
        )


def _rate(asked: Server, addresses: Sequence[str], headers: Sequence[tuple[str, str]] = ()) -> float:
    """Requests in a second of the server's processor."""
    requests = [request(asked.place, address, headers) for address in addresses]
    before = asked.seconds
    sent(asked.place, requests)
    return len(requests) / (asked.seconds - before)


def _posting(service: Server, runs: int, count: int) -> Iterator[Row]:
    for work, most, address in (
        ("lint of a 2 kB overlay, ten clients, p99", 0.04, "/api/v1/lint"),
        ("composition of an overlay, ten clients, p99", 0.25, f"{_VSS}/trial"),
    ):
        post = request(service.place, address, body=_OVERLAY.encode())
        loads = [sent(service.place, [post] * count) for _ in range(runs + 1)][1:]  # the first one warms up
        p99, rate = (median(getattr(load, name) for load in loads) for name in ("p99", "rate"))
        yield work, f"{p99 * 1000:.0f} ms", f"{rate:.0f}/s", "", f"at most {most * 1000:.0f} ms", p99 <= most


def _mixed(place: str) -> Iterator[bytes]:
    """Mixed requests: of a hundred, 60 for nodes, 25 searches, ten overlays to check or try, and five long answers."""
    paths = _paths()
    nodes = cycle([f"{_VSS}/nodes/{path}" for path in paths])
    words = cycle([f"{_VSS}/search?q={word}" for word in _words(paths)])
    long = cycle([f"{_VSS}/tree?depth=9", f"{_VSS}/export/json", f"{_VSS}/nodes?limit=200", f"{_VSS}/units", _VSS])
    posts = cycle(["/api/v1/lint", f"{_VSS}/trial"])
    kinds = Random(1).choices((nodes, words, posts, long), (60, 25, 10, 5), k=10_000)
    for kind in cycle(kinds):
        yield request(place, next(kind), body=_OVERLAY.encode() if kind is posts else b"")


def _paths() -> list[str]:
    from sigcat.catalogue.composing.compose import read_catalogue

    return list(read_catalogue(ROOT_FILE).nodes)


def _moved(addresses: Sequence[str], catalogue: str) -> list[str]:
    """The same addresses in another catalogue."""
    return [address.replace("/vss/", f"/{catalogue}/") for address in addresses]


def _words(paths: Sequence[str]) -> list[str]:
    """Searches of two words, each once: none is answered from what is kept."""
    names = sorted({path.rpartition(".")[2] for path in paths})
    return [f"{a}+{b[:3]}" for a in names[:150] for b in names[150:260]]


def _tag(service: Server, address: str) -> str:
    import urllib.request

    with urllib.request.urlopen(f"http://{service.place}{address}") as answer:
        return str(answer.headers["ETag"])


def main() -> int:
    """Print the table."""
    print("| work | sigcat | reference | ratio | target |\n|---|---|---|---|---|")
    for row in rows(runs=int(sys.argv[1]) if len(sys.argv) > 1 else 3):
        print(f"| {' | '.join(map(str, row))} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
