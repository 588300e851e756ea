"""Metrics for Prometheus: requests by route template, so that each route has one series.

Several workers keep their figures in the folder that PROMETHEUS_MULTIPROC_DIR names, and each answers with the total.
"""

import os
import platform
from collections.abc import Callable, Iterable
from functools import partial
from http import HTTPMethod
from pathlib import Path

from fastapi import APIRouter, Request
from fastapi.responses import Response
from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, generate_latest
from prometheus_client.core import GaugeMetricFamily, InfoMetricFamily
from prometheus_client.exposition import CONTENT_TYPE_LATEST
from prometheus_client.multiprocess import MultiProcessCollector
from prometheus_client.registry import Collector

from sigcat import __version__
from sigcat.api.middleware.process_metrics import MemoryTotal, ProcessTotals, this_process, workers_in
from sigcat.api.requests.thread_turns import InThread
from sigcat.api.work.queue import WorkQueue
from sigcat.catalogue.hosting.library import Library
from sigcat.function.hosting import FunctionLibrary

router = APIRouter(route_class=InThread)

SHARED_FOLDER = "PROMETHEUS_MULTIPROC_DIR"
_METHODS = frozenset(HTTPMethod)
_SECONDS = (0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60)


class Metrics:
    """Counts of one service; a process may have several, as tests do."""

    def __init__(self, library: Library, functions: FunctionLibrary, work: WorkQueue, exports: WorkQueue) -> None:
        self.registry = CollectorRegistry()
        """All that `/metrics` shows."""
        folder = os.environ.get(SHARED_FOLDER)
        own = CollectorRegistry() if folder else self.registry
        if folder:
            MultiProcessCollector(self.registry)  # type: ignore[no-untyped-call]
        processes = partial(workers_in, Path(folder)) if folder else this_process
        self._requests = Counter(
            "sigcat_requests", "Requests that were answered.", ("method", "route", "status"), registry=own
        )
        self._series: dict[tuple[str, str, int], tuple[Counter, Histogram]] = {}
        """Counters and histograms in use: looking them up costs as much as counting."""
        self._seconds = Histogram(
            "sigcat_request_seconds", "From the first byte of a request to the last of its answer.", ("route",),
            buckets=_SECONDS, registry=own,
        )  # fmt: skip
        gauge = partial(Gauge, registry=own, multiprocess_mode="livesum")
        self._connections = gauge("sigcat_connections", "Connections that are open.")
        self._gauges: dict[Gauge, Callable[[], int]] = {
            gauge("sigcat_heavy_pending", "Heavy work under way or waiting."): lambda: work.pending,
            gauge("sigcat_exports_pending", "Exports under way or waiting."): lambda: exports.pending,
        }
        for collector in (_Hosted(library, functions), _Build(), ProcessTotals(processes), MemoryTotal(processes)):
            self.registry.register(collector)

    def watch_connections(self, count: Callable[[], int]) -> None:
        """Show how many connections there are, once there is a server that has them."""
        self._gauges[self._connections] = count

    def refresh(self) -> None:
        """Set the gauges to their present values."""
        for gauge, value in self._gauges.items():
            gauge.set(value())

    def count(self, method: str, route: str, status: int, seconds: float) -> None:
        """Note one answered request. Methods that HTTP does not have are one: a client must not invent series."""
        series = self._series.get((method, route, status))
        if series is None:
            known = method if method in _METHODS else "(other)"
            series = self._requests.labels(known, route, str(status)), self._seconds.labels(route)
            if known == method:  # what a client invents is not remembered
                self._series[method, route, status] = series
        series[0].inc()
        series[1].observe(seconds)


class _Build(Collector):
    """The build that runs."""

    def collect(self) -> Iterable[InfoMetricFamily]:
        """Its version, and that of Python."""
        versions = {"version": __version__, "python": platform.python_version()}
        yield InfoMetricFamily("sigcat_build", "The version of sigcat and of Python.", versions)


class _Hosted(Collector):
    """Hosted catalogues and functions, as they are when they are asked for."""

    def __init__(self, library: Library, functions: FunctionLibrary) -> None:
        self._library = library
        self._functions = functions

    def collect(self) -> Iterable[GaugeMetricFamily]:
        """Nodes and errors of each catalogue, and errors of a refused newer state."""
        nodes = GaugeMetricFamily("sigcat_catalogue_nodes", "Nodes of a catalogue.", labels=("catalogue", "digest"))
        rejected = GaugeMetricFamily(
            "sigcat_catalogue_rejected", "1 if a newer state of the files has errors.", labels=("catalogue",)
        )
        errors = GaugeMetricFamily(
            "sigcat_catalogue_errors", "Errors in the state that is served.", labels=("catalogue",)
        )
        for hosted in self._library:
            wrong = sum(finding.severity == "error" for finding in hosted.catalogue.findings)
            errors.add_metric((hosted.source.id,), wrong)
            nodes.add_metric((hosted.source.id, hosted.catalogue.digest), len(hosted.catalogue.nodes))
            rejected.add_metric((hosted.source.id,), float(bool(hosted.rejected)))
        functions = GaugeMetricFamily(
            "sigcat_function_rejected", "1 if a newer state of the file has errors.", labels=("function",)
        )
        for file in self._functions.files:
            if not file.is_shipped:
                functions.add_metric((file.id,), float(bool(file.rejected)))
        return nodes, errors, rejected, functions


@router.get("/metrics", include_in_schema=False)
def get_metrics(request: Request) -> Response:
    """Every figure, in the text format of Prometheus."""
    metrics: Metrics = request.app.state.metrics
    metrics.refresh()
    return Response(generate_latest(metrics.registry), headers={"Content-Type": CONTENT_TYPE_LATEST})
