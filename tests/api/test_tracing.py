"""Traces for OpenTelemetry: exported where the environment names a collector, and nothing loaded where it does not."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread
from typing import Any

import pytest
from opentelemetry.proto.collector.trace.v1.trace_service_pb2 import ExportTraceServiceRequest

from sigcat.api.tracing import telemetry
from sigcat.errors import UsageError
from tests import plain_http
from tests.api.conftest import TREE
from tests.api.serving import served
from tests.waiting import wait_until

TRACE = "0af7651916cd43dd8448eb211c80319c"
PARENT = "b7ad6b7169203331"
NODE = "/api/v1/catalogues/{catalogue}/nodes/{path}"


@contextmanager
def collector(received: list[ExportTraceServiceRequest]) -> Iterator[str]:
    """The address of a collector that keeps what it is sent."""

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["Content-Length"]))
            assert self.path == "/v1/traces"
            received.append(ExportTraceServiceRequest.FromString(body))
            self.send_response(200)
            self.send_header("Content-Length", "0")
            self.end_headers()

        def log_message(self, *_: object) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


def test_requests_are_spans_of_the_trace_that_their_client_names() -> None:
    received: list[ExportTraceServiceRequest] = []
    variables = {"OTEL_BSP_SCHEDULE_DELAY": "50", "OTEL_EXPORTER_OTLP_COMPRESSION": "none"}
    headers = {"traceparent": f"00-{TRACE}-{PARENT}-01"}
    with (
        collector(received) as address,
        served(TREE / "tree.vspec", OTEL_EXPORTER_OTLP_ENDPOINT=address, **variables) as service,
    ):
        node = f"{service.address}/api/v1/catalogues/local/nodes/Vehicle.Speed"
        answers = [plain_http.get(node, headers=headers) for _ in range(2)]
        wait_until(lambda: len(spans(received, f"GET {NODE}")) == 2, "both spans are exported")
        servers = spans(received, f"GET {NODE}")
        wait_until(lambda: len(service.logged(trace_id=TRACE)) == 2, "both requests are logged")
        lines = service.logged(trace_id=TRACE)
    assert {span.trace_id.hex() for span in servers} == {TRACE}
    assert {span.parent_span_id.hex() for span in servers} == {PARENT}
    ids = [answer.headers["x-request-id"] for answer in answers]
    assert [attributes(span)["sigcat.request_id"] for span in servers] == ids
    assert {attributes(span)["http.route"] for span in servers} == {NODE}
    assert [line["request_id"] for line in lines] == ids
    (resource,) = {each.value.string_value for r in received[0].resource_spans for each in r.resource.attributes
                   if each.key == "service.name"}  # fmt: skip
    assert resource == "sigcat"


def spans(received: list[ExportTraceServiceRequest], name: str) -> list[Any]:
    return [
        span
        for request in received
        for resource in request.resource_spans
        for scope in resource.scope_spans
        for span in scope.spans
        if span.name == name
    ]


def attributes(span: Any) -> dict[str, str]:
    return {each.key: each.value.string_value for each in span.attributes}


@pytest.mark.parametrize(
    "variables",
    [
        {},
        {"OTEL_EXPORTER_OTLP_ENDPOINT": "http://127.0.0.1:1", "OTEL_SDK_DISABLED": "true"},
        {"OTEL_EXPORTER_OTLP_ENDPOINT": "http://127.0.0.1:1", "OTEL_TRACES_EXPORTER": "none"},
    ],
)
def test_nothing_is_loaded_where_no_collector_is_named(variables: dict[str, str]) -> None:
    code = (
        "import sys; from sigcat.cli.serve import application; application()\n"
        "print([name for name in sys.modules if name.startswith(('opentelemetry.sdk', 'opentelemetry.exporter'))])"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env={**os.environ, **variables}
    )
    assert run.stdout == "[]\n"


@pytest.mark.parametrize(
    ("name", "value"), [("OTEL_TRACES_EXPORTER", "zipkin"), ("OTEL_EXPORTER_OTLP_PROTOCOL", "grpc")]
)
def test_what_cannot_be_exported_is_refused(monkeypatch: pytest.MonkeyPatch, name: str, value: str) -> None:
    monkeypatch.setenv("OTEL_EXPORTER_OTLP_TRACES_ENDPOINT", "http://127.0.0.1:1/v1/traces")
    monkeypatch.setenv(name, value)
    with pytest.raises(UsageError, match=name):
        telemetry()


def test_missing_packages_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OTEL_EXPORTER_OTLP_ENDPOINT", "http://127.0.0.1:1")
    monkeypatch.setitem(sys.modules, "opentelemetry.sdk", None)
    with pytest.raises(UsageError, match=r"sigcat\[otel\]"):
        telemetry()
