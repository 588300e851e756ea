"""The head of an answer is one piece with the first part of its body, and each of its headers is one line."""

import asyncio
from typing import Any

import pytest
from uvicorn.protocols.http.flow_control import FlowControl

from sigcat.api.connections.exchange import Exchange
from tests.own_loop import run


class Written:
    """Keeps what is written to a transport, and whether it was closed."""

    def __init__(self) -> None:
        self.pieces: list[bytes] = []
        self.is_closed = False

    def write(self, data: bytes) -> None:
        self.pieces.append(bytes(data))

    def writelines(self, pieces: tuple[bytes, ...]) -> None:
        self.pieces.extend(pieces)

    def close(self) -> None:
        self.is_closed = True


def answered(*messages: dict[str, Any], method: str = "GET", keep_alive: bool = True) -> Written:
    """Return the bytes that are written for these messages."""
    written = Written()

    async def send() -> None:
        exchange = Exchange(
            scope={"method": method, "type": "http"},  # type: ignore[typeddict-item]
            transport=written,  # type: ignore[arg-type]
            flow=FlowControl(written),  # type: ignore[arg-type]
            logger=None,  # type: ignore[arg-type]
            access_logger=None,  # type: ignore[arg-type]
            access_log=False,
            default_headers=[(b"date", b"now")],
            message_event=asyncio.Event(),
            expect_100_continue=False,
            keep_alive=keep_alive,
            on_response=lambda: None,
        )
        for message in messages:
            await exchange.send(message)  # type: ignore[arg-type]

    run(send())
    return written


def start(*headers: tuple[bytes, bytes], status: int = 200) -> dict[str, Any]:
    return {"type": "http.response.start", "status": status, "headers": list(headers)}


def body(data: bytes, *, more: bool = False) -> dict[str, Any]:
    return {"type": "http.response.body", "body": data, "more_body": more}


LENGTH = (b"Content-Length", b"2")
HEAD = b"HTTP/1.1 200 OK\r\ndate: now\r\ncontent-length: 2\r\n"


def test_a_whole_answer_is_one_piece() -> None:
    assert answered(start(LENGTH), body(b"ab")).pieces == [HEAD + b"\r\nab"]


def test_a_long_body_is_not_copied() -> None:
    long = b"x" * 100_000
    pieces = answered(start((b"content-length", b"100000")), body(long)).pieces
    assert pieces[-1] is long
    assert len(pieces) == 2


def test_the_head_of_a_stream_does_not_wait_for_its_parts() -> None:
    assert answered(start()).pieces == [b"HTTP/1.1 200 OK\r\ndate: now\r\ntransfer-encoding: chunked\r\n\r\n"]
    assert answered(start(), body(b"ab", more=True), body(b"")).pieces[1:] == [b"2\r\nab\r\n", b"0\r\n\r\n"]


def test_parts_of_a_known_length_are_written_one_by_one() -> None:
    assert answered(start(LENGTH), body(b"a", more=True), body(b"b")).pieces == [HEAD + b"\r\n", b"a", b"b"]


@pytest.mark.parametrize("method", ["HEAD", "GET"])
def test_what_has_no_body_is_its_head(method: str) -> None:
    status = 200 if method == "HEAD" else 304
    written = answered(start(*[LENGTH] * (method == "HEAD"), status=status), body(b""), method=method)
    assert b"".join(written.pieces).endswith(b"\r\n\r\n")
    assert b"chunked" not in b"".join(written.pieces)


@pytest.mark.parametrize(("keep_alive", "header"), [(False, ()), (True, ((b"connection", b"Keep-Alive, Close"),))])
def test_the_last_answer_says_that_it_closes(keep_alive: bool, header: tuple[tuple[bytes, bytes], ...]) -> None:
    written = answered(start(LENGTH, *header), body(b"ab"), keep_alive=keep_alive)
    assert written.pieces[0].lower().count(b"connection:") == 1
    assert written.is_closed


@pytest.mark.parametrize("name", [b"x-text", b"x-request-id"])
@pytest.mark.parametrize("value", [b"a\r\nset-cookie: b", b"a\nb", b"a\rb", b"\0", b"\x7f"])
def test_no_value_becomes_a_second_header(name: bytes, value: bytes) -> None:
    with pytest.raises(RuntimeError, match=name.decode()):
        answered(start(LENGTH, (name, value)), body(b"ab"))


@pytest.mark.parametrize("name", [b"", b"a b", b"a:b", b"a\r\nb", b"a\tb"])
def test_no_name_has_what_ends_it(name: bytes) -> None:
    with pytest.raises(RuntimeError):
        answered(start(LENGTH, (name, b"value")), body(b"ab"))


@pytest.mark.parametrize("data", [b"a", b"abc"])
def test_a_body_has_the_length_that_its_head_says(data: bytes) -> None:
    with pytest.raises(RuntimeError, match="Content-Length"):
        answered(start(LENGTH), body(data))
