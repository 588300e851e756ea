"""Send one request to an address, within limits of time and size."""

import socket
import ssl
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from typing import NamedTuple
from urllib.parse import SplitResult

from sigcat.limits import WEBHOOK_SECONDS
from sigcat.registry.webhooks.addresses import Forbidden, Policy, checked_url, port_of, resolved

_GONE = 410


class Answer(NamedTuple):
    """The answer to a request."""

    is_delivered: bool
    text: str
    """Status, or why there is none."""
    is_final: bool = False
    """Whether the receiver wants no more attempts."""


def send(url: str, body: bytes, headers: Mapping[str, str], policy: Policy) -> Answer:
    """Send a request. Its answer is the status line: redirects are not followed, and the body is not read."""
    try:
        parts = checked_url(url, policy)
        status = _status(parts, resolved(parts, policy), body, headers)
    except Forbidden as error:
        return Answer(is_delivered=False, text=f"not sent: {error}")
    except ssl.SSLError as error:
        return Answer(is_delivered=False, text=f"TLS: {error.reason or 'failed'}")
    except TimeoutError:
        return Answer(is_delivered=False, text=f"no answer within {WEBHOOK_SECONDS} s")
    except (OSError, HTTPException, ValueError) as error:
        return Answer(is_delivered=False, text=f"no answer: {str(error)[:200] or type(error).__name__}")
    is_delivered = 200 <= status < 300
    is_redirect = 300 <= status < 400
    text = f"HTTP {status}{', a redirect, which is not followed' if is_redirect else ''}"
    return Answer(is_delivered, text, is_final=status == _GONE)


def _status(parts: SplitResult, address: str, body: bytes, headers: Mapping[str, str]) -> int:
    connection = _connection(parts)
    with _connected(parts, address) as connected:
        connection.sock = connected
        target = f"{parts.path or '/'}{f'?{parts.query}' if parts.query else ''}"
        connection.request("POST", target, body, {**headers, "Connection": "close"})
        return connection.getresponse().status


def _connection(parts: SplitResult) -> HTTPConnection:
    """A connection that names the host, and whose socket is made here."""
    kind = HTTPSConnection if parts.scheme == "https" else HTTPConnection
    return kind(parts.hostname or "", port_of(parts))


@contextmanager
def _connected(parts: SplitResult, address: str) -> Iterator[socket.socket]:
    """A socket to a numeric address, which ends after some seconds, however slowly the other side sends."""
    plain = socket.create_connection((address, port_of(parts)), timeout=WEBHOOK_SECONDS)
    is_over = threading.Event()
    with _secured(plain, parts) as connected:

        def end() -> None:
            is_over.set()
            with suppress(OSError):  # the other side has ended it
                socket.socket.shutdown(connected, socket.SHUT_RDWR)  # that of TLS would wait for the other side

        timer = threading.Timer(WEBHOOK_SECONDS, end)
        timer.daemon = True
        timer.start()
        try:
            if isinstance(connected, ssl.SSLSocket):
                connected.do_handshake()
            yield connected
        except (OSError, HTTPException):
            if is_over.is_set():
                raise TimeoutError from None
            raise
        finally:
            timer.cancel()


def _secured(plain: socket.socket, parts: SplitResult) -> socket.socket:
    """The socket with TLS before its handshake. The certificate must be that of the host."""
    if parts.scheme != "https":
        return plain
    context = ssl.create_default_context()
    return context.wrap_socket(plain, server_hostname=parts.hostname, do_handshake_on_connect=False)
