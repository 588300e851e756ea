"""Signals and queues that calls consume and provide."""

from collections.abc import Mapping

from sigcat.adapter.model.function import Output
from sigcat.adapter.model.parts.inputs import Input, Queue
from sigcat.adapter.model.parts.time_out import LAST, TimeOut
from sigcat.adapter.model.reading.times import nanoseconds
from sigcat.adapter.model.reading.transfers import Table, to_catalogue, to_code
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.runnable import Runnable

Data = Signal | DataQueue


def data_of(runnable: Runnable) -> list[Data]:
    """Signals and queues of a call."""
    found: list[Data] = []
    for contract in runnable.contracts or ():
        found += contract.signals or ()
        found += contract.queues or ()
    return found


def port_key(item: Data) -> str:
    """What makes two inputs the same signal."""
    return item.vss_path or item.name


def input_of(item: Data, ports: Mapping[str, str], table: Table) -> Input:
    """What a call consumes."""
    time_out = _time_out(item)
    return Input(
        port=ports[port_key(item)],
        names=tuple(name for name in (item.name, item.vss_path) if name),
        variable=item.variable or item.name,
        transfer=to_code(item, table),
        is_immediate=(item.access or "").lower() == "immediate",
        time_out=time_out,
        time_out_error=item.timeout_error if time_out else None,
        range_error=item.range_error,
        e2e_error=item.e2e_error,
        queue=_queue(item) if isinstance(item, DataQueue) else None,
    )


def _time_out(item: Data) -> TimeOut | None:
    longest = nanoseconds(item.timeout)
    if longest is None:
        return None
    is_first = item.timeout_start == "First"
    return TimeOut(longest, is_first, item.timeout_recovery or 1, item.timeout_value or LAST)


def _queue(item: DataQueue) -> Queue:
    return Queue(
        item.queue_length,
        item.overflow == "DropNewest",
        item.values_per_step or 1,
        item.count_variable,
        item.overflow_error,
    )


def output_of(item: Data, table: Table) -> Output:
    """What a call provides."""
    queue = _queue(item) if isinstance(item, DataQueue) else None
    return Output(item.name, item.variable or item.name, to_catalogue(item, table), item.range_error, queue)
