"""Traces of requests for OpenTelemetry, where its variables in the environment name a collector; FastAPI makes the spans.

Without them nothing of the SDK is imported, and requests pay nothing.
"""

import os
from collections.abc import Mapping
from importlib.util import find_spec

from fastapi.telemetry import TelemetryConfig
from opentelemetry.trace import format_trace_id, get_current_span

from sigcat.errors import UsageError

_ENDPOINTS = ("OTEL_EXPORTER_OTLP_TRACES_ENDPOINT", "OTEL_EXPORTER_OTLP_ENDPOINT")
_PROTOCOLS = ("OTEL_EXPORTER_OTLP_TRACES_PROTOCOL", "OTEL_EXPORTER_OTLP_PROTOCOL")
_PROTOCOL = "http/protobuf"
_NEEDED = ("opentelemetry.sdk", "opentelemetry.exporter.otlp.proto.http")


def telemetry() -> TelemetryConfig:
    """Configure the traces of FastAPI; metrics and the log are the service's own. Raises UsageError for unsupported settings."""
    is_traced = _names_collector(os.environ)
    if is_traced:
        _check(os.environ)
        if "service.name=" not in os.environ.get("OTEL_RESOURCE_ATTRIBUTES", ""):
            os.environ.setdefault("OTEL_SERVICE_NAME", "sigcat")
    return {"tracing": is_traced, "metrics": False, "logs": False, "auto_configure": is_traced}


def name_span(method: str, route: str, request_id: str) -> str:
    """Name the span of a request after its route, and return the id of its trace; nothing if it is not traced."""
    span = get_current_span()
    if not span.is_recording():
        return ""
    span.update_name(f"{method} {route}")
    span.set_attributes({"http.route": route, "sigcat.request_id": request_id})
    return format_trace_id(span.get_span_context().trace_id)


def _names_collector(environment: Mapping[str, str]) -> bool:
    is_disabled = environment.get("OTEL_SDK_DISABLED", "").lower() == "true"
    is_off = environment.get("OTEL_TRACES_EXPORTER", "").strip().lower() == "none"
    return not (is_disabled or is_off) and any(environment.get(name) for name in _ENDPOINTS)


def _check(environment: Mapping[str, str]) -> None:
    exporter = environment.get("OTEL_TRACES_EXPORTER") or "otlp"
    protocol = next((environment[name] for name in _PROTOCOLS if environment.get(name)), _PROTOCOL)
    if exporter.strip().lower() != "otlp":
        raise UsageError(f"OTEL_TRACES_EXPORTER must be `otlp` or `none`, not {exporter[:100]!r}.")
    if protocol != _PROTOCOL:
        raise UsageError(f"OTEL_EXPORTER_OTLP_PROTOCOL must be `{_PROTOCOL}`, not {protocol[:100]!r}.")
    if not all(map(_is_installed, _NEEDED)):
        raise UsageError("Traces need the extra `otel`: run `pip install 'sigcat[otel]'`.")


def _is_installed(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ModuleNotFoundError:
        return False
