"""Connections of a served process: invalid requests are refused with a problem, and none blocks other clients."""

import asyncio
import json
import socket
import time
import urllib.error
import urllib.request
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from urllib.parse import urlsplit

import httpx
import pytest

from sigcat.api.answers.problems import KINDS
from sigcat.api.client_network import network_of
from sigcat.api.connections.http import CHUNK_BYTES, HEAD_BYTES, HEADERS
from sigcat.api.connections.open_connections import OpenConnections
from sigcat.api.connections.request_starts import RequestStarts
from sigcat.api.connections.trusted_proxies import trusted_by
from sigcat.api.connections.unread_answers import UnreadAnswers
from tests import plain_http
from tests.api.conftest import TREE
from tests.api.serving import Service, served
from tests.waiting import DEADLINE, wait_until

LIVE = b"GET /health/live HTTP/1.1\r\nHost: a\r\n\r\n"
LAST = b"GET /health/live HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n"
LINT = b"POST /api/v1/lint HTTP/1.1\r\nHost: a\r\n"
ELSEWHERE = "127.0.0.2"
"""Another address of this machine: another client."""


@contextmanager
def connected(service: Service, sent: bytes = b"", source: str = "127.0.0.1") -> Iterator[socket.socket]:
    """A connection on which something was sent."""
    parts = urlsplit(service.address)
    assert parts.hostname
    with socket.create_connection((parts.hostname, parts.port or 0), DEADLINE, (source, 0)) as connection:
        connection.sendall(sent)
        yield connection


def received(connection: socket.socket) -> bytes:
    """All that comes until the service closes, which it has to."""
    answer = b""
    with suppress(ConnectionError):
        while part := connection.recv(65536):
            answer += part
    return answer


def answer_to(service: Service, sent: bytes) -> bytes:
    with connected(service, sent) as connection:
        return received(connection)


def statuses(answer: bytes) -> list[int]:
    return [int(part[:3]) for part in answer.split(b"HTTP/1.1 ")[1:]]


def problem_in(answer: bytes) -> dict[str, object]:
    """The problem of the last answer, which has its id in a header too."""
    head, _, body = answer.rpartition(b"\r\n\r\n")
    problem: dict[str, object] = json.loads(body)
    headers = dict(line.split(b": ", 1) for line in head.rpartition(b"HTTP/1.1 ")[2].split(b"\r\n")[1:])
    assert headers[b"content-type"] == b"application/problem+json"
    assert headers[b"x-request-id"].decode() == problem["request_id"]
    assert headers[b"connection"] == b"close"
    return problem


@pytest.fixture(scope="module")
def service() -> Iterator[Service]:
    with served(TREE / "tree.vspec", SIGCAT_HEAD_SECONDS="1", SIGCAT_ROOT_PATH="/signals") as service:
        yield service


CHUNKED = b"Transfer-Encoding: chunked\r\n"
NO_REQUESTS = {
    "a length beside chunks": (LINT + b"Content-Length: 5\r\n" + CHUNKED + b"\r\n0\r\n\r\n", 400, "Content-Length"),
    "chunks beside a length": (LINT + CHUNKED + b"Content-Length: 5\r\n\r\n0\r\n\r\n", 400, "Content-Length"),
    "two lengths": (LINT + b"Content-Length: 5\r\nContent-Length: 6\r\n\r\naaaaaa", 400, "Content-Length"),
    "one length twice": (LINT + b"Content-Length: 5\r\nContent-Length: 5\r\n\r\naaaaa", 400, "Content-Length"),
    "a list of lengths": (LINT + b"Content-Length: 5, 6\r\n\r\naaaaaa", 400, "Content-Length"),
    "a length below zero": (LINT + b"Content-Length: -1\r\n\r\n", 400, "Content-Length"),
    "chunks twice": (LINT + 2 * CHUNKED + b"\r\n0\r\n\r\n", 400, "header"),
    "chunks in packed chunks": (LINT + b"Transfer-Encoding: gzip\r\n" + CHUNKED + b"\r\n0\r\n\r\n", 400, "chunked"),
    "packed chunks": (LINT + b"Transfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n", 400, "chunked"),
    "chunks in HTTP/1.0": (b"POST /api/v1/lint HTTP/1.0\r\n" + CHUNKED + b"\r\n0\r\n\r\n", 400, "chunked"),
    "a chunk that is none": (LINT + CHUNKED + b"\r\nzz\r\n", 400, "chunk size"),
    "another method": (b"INVENTED / HTTP/1.1\r\nHost: a\r\n\r\n", 400, "method"),
    "a proxy's method": (b"CONNECT a:1 HTTP/1.1\r\nHost: a\r\n\r\n", 400, "must be a path"),
    "the next protocol": (b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 400, "HTTP/2"),
    "a method in small letters": (b"get / HTTP/1.1\r\nHost: a\r\n\r\n", 400, "capitals"),
    "a chunk that is longer than it says": (LINT + CHUNKED + b"\r\n5\r\nVehicle", 400, "chunk size"),
    "a line that ends early": (b"GET / HTTP/1.1\nHost: a\n\n", 400, "CR LF"),
    "an address with a space": (b"GET /a b HTTP/1.1\r\nHost: a\r\n\r\n", 400, "METHOD ADDRESS"),
    "an address that is not ASCII": (b"GET /\xc3\xa4 HTTP/1.1\r\nHost: a\r\n\r\n", 400, "%C3%A4"),
    "an address with a port that is none": (b"GET http://a:99999/ HTTP/1.1\r\nHost: a\r\n\r\n", 400, "must be a path"),
    "all addresses": (b"GET * HTTP/1.1\r\nHost: a\r\n\r\n", 400, "must be a path"),
    "a way up": (b"GET /rules/../ HTTP/1.1\r\nHost: a\r\n\r\n", 400, "segments"),
    "a way up that is hidden": (b"GET /rules%2f.%2E HTTP/1.1\r\nHost: a\r\n\r\n", 400, "segments"),
    "a way on the spot": (b"GET /tree/./small HTTP/1.1\r\nHost: a\r\n\r\n", 400, "segments"),
    "another version": (b"GET / HTTP/9.9\r\nHost: a\r\n\r\n", 400, "version"),
    "no version": (b"GET /\r\n\r\n", 400, "version"),
    "another protocol": (b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 400, "TLS"),
    "no host": (b"GET / HTTP/1.1\r\n\r\n", 400, "`Host`"),
    "a host that is none": (b"GET / HTTP/1.1\r\nHost: a/b\r\n\r\n", 400, "`Host`"),
    "a host with a port that is none": (b"GET / HTTP/1.1\r\nHost: a:b\r\n\r\n", 400, "`Host`"),
    "a fragment": (b"GET /rules#V101 HTTP/1.1\r\nHost: a\r\n\r\n", 400, "must be a path"),
    "two hosts": (b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n", 400, "`Host`"),
    "an address without a path": (b"GET http://a HTTP/1.1\r\nHost: a\r\n\r\n", 400, "path"),
    "a header without a name": (b"GET / HTTP/1.1\r\nHost: a\r\n: b\r\n\r\n", 400, "header"),
    "a folded header": (b"GET / HTTP/1.1\r\nHost: a\r\nX: a\r\n b\r\n\r\n", 400, "header"),
    "a long header": (b"GET / HTTP/1.1\r\nHost: a\r\nX: " + b"a" * HEAD_BYTES + b"\r\n\r\n", 431, "32,768 bytes"),
    "a long address": (b"GET /" + b"a" * HEAD_BYTES + b" HTTP/1.1\r\nHost: a\r\n\r\n", 431, "32,768 bytes"),
    "a header that does not end": (b"GET / HTTP/1.1\r\nHost: a\r\nX: " + b"a" * 20 * HEAD_BYTES, 431, "32,768 bytes"),
    "headers that are long together": (b"GET / HTTP/1.1\r\nHost: a\r\n" + (b"X: " + b"a" * 500 + b"\r\n") * 65 + b"\r\n", 431, "32,768 bytes"),
    "many headers": (b"GET / HTTP/1.1\r\nHost: a\r\n" + b"A:\r\n" * HEADERS + b"\r\n", 431, "100 headers"),
    "many headers behind a body": (LINT + CHUNKED + b"\r\n0\r\n" + b"X: 1\r\n" * HEADERS, 431, "100 headers"),
    "a chunk extension without end": (LINT + CHUNKED + b"\r\n1;" + b"a" * 20 * CHUNK_BYTES, 413, "extensions"),
    "extensions of many chunks": (LINT + CHUNKED + b"\r\n" + (b"1;" + b"a" * 500 + b"\r\n \r\n") * 1500, 413, "32,768 bytes"),
    "half a head": (b"GET / HTTP/1.1\r\nHost: a\r\n", 408, "within 1 seconds"),
    "half a head after a request": (LIVE + b"GET / HTTP", 408, "within 1 seconds"),
}  # fmt: skip


@pytest.mark.parametrize("case", NO_REQUESTS)
def test_what_is_no_request_is_a_problem_with_an_id_and_a_line_in_the_log(service: Service, case: str) -> None:
    sent, status, detail = NO_REQUESTS[case]
    answer = answer_to(service, sent)
    assert statuses(answer)[-1] == status
    problem = problem_in(answer)
    assert (problem["status"], problem["type"]) == (status, f"/signals/problems/{KINDS[status][0]}")
    assert detail in str(problem["detail"])
    (line,) = service.logged(request_id=str(problem["request_id"]))
    assert (line["status"], line["refused"], line["client"]) == (status, problem["detail"], "127.0.0.1")
    assert "Traceback" not in service.log.read_text()


def test_requests_before_what_is_none_are_answered(service: Service) -> None:
    assert statuses(answer_to(service, 3 * LIVE + b"nothing\r\n\r\n")) == [200, 200, 200]


@pytest.mark.parametrize("body", [b"", b"Vehicle: 1"])
def test_a_wish_for_another_protocol_is_not_heard(service: Service, body: bytes) -> None:
    """Java's client asks for HTTP/2 like this, with its first request; RFC 9110 lets a server continue with HTTP/1.1."""
    head = LINT + b"Connection: upgrade, http2-settings\r\nUpgrade: h2c\r\nContent-Length: %d\r\n\r\n" % len(body)
    answer = answer_to(service, head + body + LAST)
    assert statuses(answer) == [200, 200]


@pytest.mark.parametrize("connection", [b"Upgrade, close", b"close, upgrade"])
@pytest.mark.parametrize("protocol", [b"websocket", b"h2c"])
def test_a_wish_for_another_protocol_on_a_last_request_is_answered(
    service: Service, connection: bytes, protocol: bytes
) -> None:
    for version in (b"1.1", b"1.0"):
        start = b"GET /health/live HTTP/%b\r\nHost: a\r\n" % version
        head = start + b"Connection: %b\r\nUpgrade: %b\r\n\r\n" % (connection, protocol)
        assert statuses(answer_to(service, head)) == [200]


def test_a_question_for_the_whole_service_is_answered_with_its_methods(service: Service) -> None:
    answer = answer_to(service, b"OPTIONS * HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n")
    assert statuses(answer) == [204]
    assert b"\r\nallow: GET, HEAD, OPTIONS, POST\r\n" in answer


@pytest.mark.parametrize(
    "host", ["", "a", "a.example:8000", "a:", "127.0.0.1:1", "[::1]", "[fe80::1]:8000", "xn--mnchen-3ya.example"]
)
def test_a_host_is_a_name_or_an_address_and_perhaps_a_port(service: Service, host: str) -> None:
    answer = answer_to(service, b"GET /health/live HTTP/1.1\r\nHost: %b\r\nConnection: close\r\n\r\n" % host.encode())
    assert statuses(answer) == [200]


BODIES = {
    "spaces around its length": b"Content-Length: \t10 \t\r\n\r\nVehicle: 1",
    "chunks in other letters": b"Transfer-Encoding: Chunked \r\n\r\na\r\nVehicle: 1\r\n0\r\n\r\n",
    "chunks of a byte": CHUNKED + b"\r\n" + b"1\r\n \r\n" * 100_000 + b"0\r\n\r\n",
    "a chunk with an extension": CHUNKED + b"\r\na;name=value\r\nVehicle: 1\r\n0\r\n\r\n",
}


@pytest.mark.parametrize("case", BODIES)
def test_spaces_around_a_value_and_letters_of_a_coding_say_nothing(service: Service, case: str) -> None:
    assert statuses(answer_to(service, LINT + BODIES[case] + LAST)) == [200, 200]


@pytest.mark.parametrize("path", ["/.well-known/x", "/...", "/a..b/c.d", "/tree/tree/Vehicle..Speed"])
def test_dots_in_names_are_no_way_up(service: Service, path: str) -> None:
    answer = answer_to(service, b"GET %b HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n" % path.encode())
    assert statuses(answer) == [404]


def test_half_a_head_that_drips_is_late_too(service: Service) -> None:
    with connected(service, b"GET /") as connection:
        start = time.monotonic()
        with suppress(ConnectionError):
            while time.monotonic() < start + DEADLINE:
                connection.sendall(b"a")
                connection.settimeout(0.1)
                with suppress(TimeoutError):
                    assert statuses(connection.recv(65536)) == [408]
                    break
    assert time.monotonic() < start + DEADLINE


@pytest.mark.parametrize("sent", [b"", b"\r\n\r\n"])
def test_a_connection_without_a_request_is_closed(service: Service, sent: bytes) -> None:
    assert answer_to(service, sent) == b""


def test_requests_that_wait_for_others_on_their_connection_are_bounded(service: Service) -> None:
    found = statuses(answer_to(service, 5_000 * LIVE))
    assert 10 < len(found) < 100
    assert set(found) == {200}


@pytest.mark.parametrize("path", ["lint", "catalogues/local/trial", "functions/build", "functions/validate"])
def test_a_request_without_a_body_has_forgotten_its_text_and_an_empty_text_is_one(service: Service, path: str) -> None:
    head = b"POST /api/v1/%b HTTP/1.1\r\nHost: a\r\nConnection: close\r\n" % path.encode()
    forgotten = problem_in(answer_to(service, head + b"\r\n"))
    assert (forgotten["status"], "`curl --data-binary @FILE`" in str(forgotten["detail"])) == (422, True)
    assert b"`curl" not in answer_to(service, head + b"Content-Length: 0\r\n\r\n")


LEFT = {
    "in the middle of its body": (
        LINT + b"X-Request-Id: left-before\r\nExpect: 100-continue\r\nContent-Length: 100\r\n\r\nVehicle",
        lambda service, connection: connection.recv(100).startswith(b"HTTP/1.1 100 "),
    ),
    "while work is done for it": (
        b"GET /api/v1/catalogues/local/export/csv HTTP/1.1\r\nHost: a\r\nX-Request-Id: left-before\r\n\r\n",
        lambda service, connection: "sigcat_exports_pending 1" in plain_http.get(f"{service.address}/metrics").text,
    ),
}
"""Bytes to send, and when the client leaves."""


@pytest.mark.parametrize("case", LEFT)
def test_a_client_that_leaves_is_no_failure_and_what_it_asked_for_is_given_up(tmp_path: Path, case: str) -> None:
    tree = tmp_path / "tree.vspec"
    lines = (f"Vehicle.S{n}: {{type: sensor, datatype: float, description: One.}}\n" for n in range(20_000))
    tree.write_text("Vehicle: {type: branch, description: A vehicle.}\n" + "".join(lines))
    with served(tree) as service:
        sent, is_begun = LEFT[case]
        with connected(service, sent) as connection:
            wait_until(lambda: is_begun(service, connection), "the request has begun")
        (line,) = service.logged(request_id="left-before")
        assert line["status"] == 499
        assert "sigcat_exports_pending 0" in plain_http.get(f"{service.address}/metrics").text
        assert "Traceback" not in service.log.read_text()


def test_requests_that_wait_go_with_their_connection(service: Service) -> None:
    """The one that is answered may be another one than was parsed last."""
    page = b"GET /signals/docs HTTP/1.1\r\nHost: a\r\nX-Request-Id: with-others\r\n\r\n"
    with ExitStack() as stack:
        for _ in range(20):
            stack.enter_context(connected(service, page * 30))
        wait_until(lambda: service.logged(request_id="with-others"), "the first ones are answered")
    service.logged(request_id="with-others", status=499)
    assert plain_http.get(f"{service.address}/health/live").status_code == 200
    assert len(service.logged(request_id="with-others")) < 400
    assert "Traceback" not in service.log.read_text()


def test_a_body_that_is_too_long_may_be_sent_on_so_that_the_refusal_is_read(service: Service) -> None:
    """A connection that is closed while its client still sends is reset, and most clients never see the answer."""
    size = 6_000_000
    with connected(service, LINT + b"Content-Length: %d\r\n\r\n" % size) as connection:
        connection.sendall(b"a" * size)
        connection.sendall(LAST)
        assert statuses(received(connection)) == [413, 200]


def test_a_client_that_reads_after_its_body_reads_the_refusal(service: Service) -> None:
    """urllib asks for the connection to be closed, sends the whole body, and then reads."""
    asked = urllib.request.Request(f"{service.address}/api/v1/lint", b"a" * 6_000_000)
    for _ in range(20):
        with pytest.raises(urllib.error.HTTPError, match="413"):
            urllib.request.urlopen(asked)


@pytest.mark.parametrize("header", [b"", b"Connection: close\r\n"])
def test_what_is_discarded_after_an_answer_is_bounded(service: Service, header: bytes) -> None:
    with connected(service, LINT + header + b"Content-Length: 9999999999\r\n\r\n") as connection:
        assert statuses(connection.recv(65536)) == [413]
        with pytest.raises(ConnectionError):
            connection.sendall(b"a" * 100_000_000)


# -- what a client invents ------------------------------------------------------------------------------------------

NODE = "/api/v1/catalogues/small/nodes/Vehicle.Speed"


def invented(number: int) -> dict[str, tuple[str, str, dict[str, str]]]:
    """Requests of which one part is new each time: method, address and headers."""
    word = f"invented{number}"
    return {
        "methods": (f"{word.upper()}", NODE, {}),
        "paths": ("GET", f"/{word}/{'%0A' * 3000}", {}),
        "nodes": ("GET", f"/api/v1/catalogues/small/nodes/{word}{'ä' * 2000}", {}),
        "catalogues": ("GET", f"/api/v1/catalogues/{word}/tree", {}),
        "parameters": ("GET", f"{NODE}?{word}=1", {}),
        "values": ("GET", f"/api/v1/catalogues/small/search?q={word}&limit=1", {}),
        "agents": ("GET", NODE, {"User-Agent": word * 1000}),
        "hosts": ("GET", NODE, {"Host": word}),
        "headers": ("GET", NODE, {word: word * 1000}),
        "ids": ("GET", NODE, {"X-Request-Id": word * 1000}),
        "addresses": ("GET", NODE, {"X-Forwarded-For": word * 1000}),
        "protocols": ("GET", NODE, {"X-Forwarded-Proto": word}),
        "tokens": ("POST", "/api/v1/catalogues/small/reload", {"Authorization": f"Bearer {word}"}),
        "forms": ("GET", NODE, {"Accept": f"application/{word}, */*"}),
    }


@pytest.fixture(scope="module")
def trusting() -> Iterator[Service]:
    """A service that believes what any proxy says of its clients."""
    with served(TREE / "tree.vspec", SIGCAT_TRUSTED_PROXIES="*") as service:
        yield service


def series(service: Service) -> set[str]:
    """Names of all series of the metrics, with their labels."""
    lines = plain_http.get(f"{service.address}/metrics").text.splitlines()
    return {line.rpartition(" ")[0] for line in lines if not line.startswith("#")}


def send(service: Service, client: httpx.Client, kind: str, number: int) -> None:
    method, address, headers = invented(number)[kind]
    with suppress(httpx.RemoteProtocolError):  # an invalid method of HTTP is refused and closes the connection
        client.request(method, f"{service.address}{address.replace('small', 'local')}", headers=headers)


@pytest.mark.parametrize("kind", invented(0))
def test_nothing_that_a_client_invents_makes_series_or_long_lines(trusting: Service, kind: str) -> None:
    with httpx.Client(timeout=DEADLINE, verify=False) as client:
        send(trusting, client, kind, 0)
        series(trusting)
        before = series(trusting)
        for number in range(1, 30):
            send(trusting, client, kind, number)
    assert series(trusting) == before
    wait_until(lambda: len(trusting.logged(path="/metrics")) % 3 == 0, "all lines of the log are written")
    lines = trusting.log.read_text().splitlines()
    assert max(map(len, lines)) < 4_500, "a path of 500 characters may take six times as many in JSON"
    assert "invented" not in "".join(before)


# -- how many -------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def narrow(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Service]:
    """A service of few connections, with an answer that is longer than what a connection holds."""
    tree = tmp_path_factory.mktemp("narrow") / "tree.vspec"
    tree.write_text(
        "Vehicle: {type: branch, description: A vehicle., instances: 'Part[1,20000]'}\n"
        f"Vehicle.S: {{type: sensor, datatype: float, description: {'Long. ' * 50}}}\n"
    )
    with served(tree, SIGCAT_CONNECTIONS="6", SIGCAT_CLIENT_CONNECTIONS="4", SIGCAT_UNREAD_SECONDS="1") as service:
        yield service


def is_answered(service: Service, source: str = "127.0.0.1") -> bool:
    with connected(service, LAST, source) as connection:
        return statuses(received(connection)) == [200]


WAITING = {
    "nothing": b"",
    "half heads": b"GET / HTTP/1.1\r\nHost",
    "half bodies": LINT + b"Content-Length: 10\r\n\r\nVehicle",
    "answered requests": LIVE,
}


@pytest.mark.parametrize("case", WAITING)
def test_the_connection_that_waits_longest_for_its_client_gives_way(narrow: Service, case: str) -> None:
    with ExitStack() as stack:
        held = [stack.enter_context(connected(narrow, WAITING[case])) for _ in range(20)]
        assert is_answered(narrow)
        wait_until(lambda: sum(map(is_open, held)) < 4, "the first ones are closed")
        assert [is_open(each) for each in held] == sorted(map(is_open, held))
        assert is_answered(narrow, ELSEWHERE)


def is_open(connection: socket.socket) -> bool:
    connection.settimeout(0.01)
    try:
        while connection.recv(65536):
            pass
    except TimeoutError:
        return True
    except ConnectionError:
        pass
    return False


def test_with_all_at_work_the_next_is_told_to_come_again_until_those_who_read_nothing_are_cut_off(
    narrow: Service,
) -> None:
    unread = b"GET /api/v1/catalogues/local/nodes?fields=description HTTP/1.1\r\nHost: a\r\nAccept: text/csv\r\n\r\n"
    with ExitStack() as stack:
        held = [stack.enter_context(connected(narrow, unread)) for _ in range(4)]
        assert all(each.recv(10) for each in held)
        refused = wait_until(lambda: answer_unless_200(narrow), "all connections are at work")
        assert problem_in(refused)["type"] == "/problems/busy"
        assert b"\r\nretry-after: " in refused
        assert is_answered(narrow, ELSEWHERE), "another client has separate connections"
        wait_until(lambda: is_answered(narrow), "those that read nothing are cut off")
    assert "Traceback" not in narrow.log.read_text()


def answer_unless_200(service: Service) -> bytes:
    answer = answer_to(service, LAST)
    return b"" if statuses(answer) == [200] else answer


def test_of_many_answers_that_wait_the_one_left_longest_is_cut_off(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    lines = (f"Vehicle.S{n}: {{type: sensor, datatype: float, description: {'Long. ' * 500}}}\n" for n in range(3_000))
    tree.write_text("Vehicle: {type: branch, description: A vehicle.}\n" + "".join(lines))
    long = b"GET /api/v1/catalogues/local/tree HTTP/1.1\r\nHost: a\r\nAccept-Encoding: identity\r\n\r\n"
    with served(tree, SIGCAT_UNREAD_BYTES=str(12 * 1024 * 1024)) as service, ExitStack() as stack:
        held = []
        for _ in range(6):
            held.append(stack.enter_context(connected(service, long)))
            assert held[-1].recv(10)
        sizes = [len(received_to_its_end(each)) for each in held]
        assert sizes[0] < sizes[-1], "the first one is cut off, the last one is whole"
        assert sizes[-1] > 9_000_000


def received_to_its_end(connection: socket.socket) -> bytes:
    """Read until the answer is whole, or the service closes."""
    answer = bytearray()
    with suppress(ConnectionError):
        while not answer.endswith(b"\r\n0\r\n\r\n") and (part := connection.recv(1 << 20)):
            answer += part
    return bytes(answer)


def test_who_reads_slowly_reads_all(narrow: Service) -> None:
    with connected(narrow, b"GET /api/v1/catalogues/local/export/json HTTP/1.0\r\n\r\n") as connection:
        size, reading = 0, time.monotonic() + 3
        while part := connection.recv(65536):
            size += len(part)
            time.sleep(0.01 if time.monotonic() < reading else 0)
    assert size > 5_000_000


def test_connections_are_counted(narrow: Service) -> None:
    with connected(narrow, LIVE) as connection:
        connection.recv(65536)
        metrics = plain_http.get(f"{narrow.address}/metrics").text
    (count,) = [line.split()[1] for line in metrics.splitlines() if line.startswith("sigcat_connections ")]
    assert 2 <= float(count) <= 6


# -- who gives way, without a network -------------------------------------------------------------------------------


class Held:
    """A connection."""

    def __init__(self, *, waits: bool = True) -> None:
        self.waits_for_its_client = waits
        self.is_open = True

    def give_way(self) -> None:
        self.is_open = False


def added(connections: OpenConnections, *held: tuple[str, Held]) -> list[bool]:
    return [connections.add(each, address) for address, each in held]


def test_room_is_made_among_the_connections_of_the_same_client_first() -> None:
    first, other, second, third = Held(), Held(), Held(), Held()
    connections = OpenConnections(10, 2, trusted_by(()))
    assert all(added(connections, ("10.0.0.1", first), ("10.0.0.2", other), ("10.0.0.1", second), ("10.0.0.1", third)))
    assert [each.is_open for each in (first, other, second, third)] == [False, True, True, True]


def test_requests_of_one_client_are_no_wall_before_those_of_another() -> None:
    begun: list[str] = []

    async def crowd() -> None:
        starts = RequestStarts()
        for number in range(90):
            starts.add("greedy", lambda number=number: begun.append(f"greedy {number}"))  # type: ignore[misc]
        starts.add("modest", lambda: begun.append("modest"))
        await asyncio.sleep(0)
        asyncio.get_running_loop().call_soon(starts.add, "late", lambda: begun.append("late"))
        await asyncio.sleep(0.01)

    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, crowd()).result()
    assert begun.index("modest") < 40
    assert begun.index("late") < 50
    assert [each for each in begun if each.startswith("greedy")] == [f"greedy {number}" for number in range(90)]


def test_what_was_heard_from_last_gives_way_last() -> None:
    held = [Held() for _ in range(4)]
    connections = OpenConnections(3, 3, trusted_by(()))
    added(connections, *(("10.0.0.1", each) for each in held[:3]))
    connections.heard_from(held[0])
    added(connections, ("10.0.0.1", held[3]))
    assert [each.is_open for each in held] == [True, False, True, True]


def test_what_is_at_work_never_gives_way() -> None:
    working, extra = [Held(waits=False), Held(waits=False)], [Held() for _ in range(5)]
    connections = OpenConnections(2, 2, trusted_by(()))
    added(connections, *(("10.0.0.1", each) for each in working))
    assert added(connections, *(("10.0.0.2", each) for each in extra)) == [False] * 5
    assert len(connections) == 3, "the one that is about to be refused"
    assert all(each.is_open for each in working)


def test_a_trusted_proxy_has_all_connections() -> None:
    connections = OpenConnections(100, 2, trusted_by(("10.0.0.0/24", "192.0.2.7")))
    for address, count in (("10.0.0.9", 50), ("192.0.2.7", 30), ("192.0.2.8", 2)):
        before = len(connections)
        assert all(added(connections, *((address, Held(waits=False)) for _ in range(count))))
        assert len(connections) == before + count
    assert not connections.add(Held(waits=False), "192.0.2.8")


class Answer:
    """An answer that is read as far as the test says."""

    def __init__(self, unread: int) -> None:
        self.unread = unread
        self.is_cut_off = False

    def cut_off(self) -> None:
        self.is_cut_off = True


def test_who_leaves_most_unread_loses_what_it_left_longest() -> None:
    small, first, second, third = Answer(30), Answer(30), Answer(10), Answer(40)
    answers = UnreadAnswers(100)
    for client, answer in (("10.0.0.1", small), ("10.0.0.2", first), ("10.0.0.2", second), ("10.0.0.2", third)):
        answers.add(answer, client)
    assert [each.is_cut_off for each in (small, first, second, third)] == [False, True, False, False]


def test_what_was_read_meanwhile_does_not_count() -> None:
    first, second, third = Answer(60), Answer(60), Answer(60)
    answers = UnreadAnswers(100)
    answers.add(first, "10.0.0.1")
    first.unread = 0
    answers.add(second, "10.0.0.1")
    answers.remove(second)
    answers.add(third, "10.0.0.1")
    assert not any(each.is_cut_off for each in (first, second, third))


@pytest.mark.parametrize(
    ("proxies", "address", "trusted"),
    [
        ((), "10.0.0.1", False), (("*",), "10.0.0.1", True), (("10.0.0.1",), "10.0.0.1", True), (("10.0.0.1",), "10.0.0.2", False),
        (("10.0.0.0/8",), "10.9.9.9", True), (("2001:db8::/32",), "2001:db8::1", True), (("10.0.0.0/8",), "", False), (("proxy",), "10.0.0.1", False),
    ],
)  # fmt: skip
def test_proxies_are_named_by_address_or_network(proxies: Sequence[str], address: str, trusted: bool) -> None:
    assert trusted_by(proxies)(address) == trusted


@pytest.mark.parametrize(
    ("address", "client"),
    [
        ("192.0.2.7", "192.0.2.7"), ("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"), ("2001:db8:1:2::9", "2001:db8:1:2::/64"),
        ("::ffff:192.0.2.7", "192.0.2.7"), ("", ""), ("a socket", "a socket"),
    ],
)  # fmt: skip
def test_a_client_is_an_address_or_a_network_of_64_bits(address: str, client: str) -> None:
    assert network_of(address) == client


def test_the_limit_of_open_files_bounds_connections(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource", reason="a system with limits of open files")
    import subprocess
    import sys

    code = (
        "import resource\nfrom sigcat.api.connections.open_files import connections_allowed\n"
        "resource.setrlimit(resource.RLIMIT_NOFILE, ({soft}, {hard}))\n"
        "print(connections_allowed(1000), resource.getrlimit(resource.RLIMIT_NOFILE)[0])"
    )
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    for soft, hard, expected in ((256, min(most, 5000) if most > 0 else 5000, "1000 1200"), (256, 512, "312 512")):
        command = [sys.executable, "-c", code.format(soft=soft, hard=hard)]
        found = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path).stdout
        assert found.split() == expected.split()
