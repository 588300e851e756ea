"""Signals and queues that calls consume and provide."""

from collections.abc import Mapping

from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.runnable import Runnable
from tests.adapter.reference.function import Output
from tests.adapter.reference.parts.inputs import Input, Queue
from tests.adapter.reference.parts.time_out import LAST, TimeOut
from tests.adapter.reference.reading.times import nanoseconds
from tests.adapter.reference.reading.transfers import Table, to_catalogue, to_code

Data = Signal | DataQueue


def data_of(runnable: Runnable) -> list[Data]:
    """Signals and queues of a call."""
    found: list[Data] = []
    for contract in runnable.contracts or ():
        found += contract.signals or ()
        found += contract.queues or ()
    return found


def absent_of(runnable: Runnable) -> list[Data]:
    """Optional signals and queues of a call that the vehicle does not have."""
    found: list[Data] = []
    for contract in runnable.contracts or ():
        found += contract.absent_signals or ()
        found += contract.absent_queues or ()
    return found


def port_key(item: Data) -> str:
    """Key by which two inputs are the same signal."""
    return item.vss_path or item.name


def input_of(item: Data, ports: Mapping[str, str], table: Table) -> Input:
    """Inputs of a call."""
    return Input(
        port=ports[port_key(item)],
        names=tuple(name for name in (item.name, item.vss_path) if name),
        variable=item.variable or item.name,
        transfer=to_code(item, table),
        is_immediate=(item.access or "").lower() == "immediate",
        time_out=_time_out(item),
        errors={each.field: each.error for each in errors_set_by(item)},
        queue=_queue(item) if isinstance(item, DataQueue) else None,
    )


def absent_input_of(item: Data, table: Table) -> Input:
    """An input that no one sends."""
    return Input(
        port="",
        names=tuple(name for name in (item.name, item.vss_path) if name),
        variable=item.variable or item.name,
        transfer=to_code(item, table),
        errors={each.field: each.error for each in errors_set_by(item) if each.field == "absent_error"},
        queue=Queue(item.queue_length, False, item.values_per_step or 1, item.count_variable)
        if isinstance(item, DataQueue)
        else None,
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
    """Outputs of a call."""
    queue = _queue(item) if isinstance(item, DataQueue) else None
    return Output(item.name, item.variable or item.name, to_catalogue(item, table), item.range_error, queue)
