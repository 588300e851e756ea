"""
A function as a lifecycle node.

Configuring initializes the function; while the node is active, its own thread runs the
calls; whatever ends it, terminates the function once. Subscriptions only hand values over.
"""

from concurrent.futures import ThreadPoolExecutor
import os
from pathlib import Path
from signal import set_wakeup_fd, SIGINT, signal, SIGTERM
from socket import socket, socketpair
import sys
from threading import Lock, Thread
from time import monotonic_ns
import traceback
from typing import Any, Callable, Dict, List, Optional, Tuple

from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticArray
from rcl_interfaces.msg import ParameterDescriptor
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.clock import Clock as RosClock
from rclpy.clock import ClockType
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.logging import get_logger
from rclpy.qos import QoSProfile
from rclpy.signals import SignalHandlerOptions
from rclpy.task import Future

from . import diagnostics, storage
from .clock import Clock, LockStepClock, SimulatedClock, SteadyClock
from .core import Core, NO_CALL
from .executor import spin_node
from .parameters import ANY, Limits, Parameters
from .stored_text import BrokenFile
from .topics import Topics
from .watch import Watch

PATIENCE = 10.0
"""Seconds for which `~/step` waits for messages."""


class FunctionNode(LifecycleNode):
    """Behaviour of all nodes. A subclass for each function converts its messages."""

    PERIOD = 1.0
    """Seconds between two messages of the diagnostics."""

    priority: Optional[int] = None
    """Priority of the thread that runs the calls; None, without a policy, if no call has one."""

    policy = 'other'
    """Default of the parameter `scheduling_policy`."""

    def __init__(self, name: str, core: Core, step_service: Any, **options: Any) -> None:
        """Declare parameters; topics come when the node is configured."""
        super().__init__(name, **options)
        self._core = core
        self.core_lock = Lock()
        self.failure = Future()
        self._call_lock = Lock()
        self._publishing = Lock()
        self._is_initialized = False
        self._is_active = False
        self._is_in_lock_step = False
        self._watch: Optional[Watch] = None
        self._methods: Optional[ThreadPoolExecutor] = None
        self._core_clock: Any = SteadyClock(self)
        self._thread: Optional[Thread] = None
        self._step_service = step_service
        self._entities: List[Callable[[], Any]] = []
        self._topics = Topics(self)
        self._function_parameters = Parameters(self, core, self.core_lock, self.core_parameters)
        self._times = [diagnostics.CallTimes() for _ in core.calls]
        self._scheduling_problem = ''
        self._told_states: List[int] = []
        self._answers_group = MutuallyExclusiveCallbackGroup()
        self._diagnostics_group = MutuallyExclusiveCallbackGroup()
        self._is_stored = bool(core.errors or core.learned)
        self._storage: Optional[storage.Storage] = None
        self._function_parameters.declare_settings(
            self.policy, self.priority, is_stored=self._is_stored)
        self.declare_function_parameters()
        self._function_parameters.take_changes()
        quality = QoSProfile(depth=1)
        self._diagnostics = self.create_publisher(DiagnosticArray, '/diagnostics', quality)
        self._refuse_unknown_transitions()

    # -- of the function ----------------------------------------------------------------

    def declare_function_parameters(self) -> None:
        """Declare the parameters of the function."""

    def core_parameters(self, value_of: Callable[[str], Any]) -> Dict[str, Any]:
        """Answer the parameters of the core, from those of the node."""
        return {}

    def create_topics(self) -> None:
        """Create subscriptions, publishers, services and clients."""

    def send(self, out: Any, publish: Any, stamp: Time) -> None:
        """Send what the core wants to be sent."""

    # -- life ---------------------------------------------------------------------------

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Initialize the function with what was stored."""
        stored = self._load()
        cycle = (stored.get('ignition_cycle', 0) + 1) % 2 ** 32
        stored.update(self._function_parameters.given(stored))
        self._times = [diagnostics.CallTimes() for _ in self._core.calls]
        with self.core_lock:
            self._is_initialized = self._core.init(stored, cycle)
        if not self._is_initialized:
            self.get_logger().error(f'The initialization of {self._core.function} has failed')
            return TransitionCallbackReturn.FAILURE
        self._core_clock = self._make_clock()
        self._topics.keeps_all = self._is_in_lock_step
        self.create_topics()
        if self._is_in_lock_step:
            service = self.create_service(self._step_service, '~/step', self._on_step)
            self._entities.append(lambda: self.destroy_service(service))
        timer = self.create_timer(
            self.PERIOD, self._tick, callback_group=self._diagnostics_group,
            clock=RosClock(clock_type=ClockType.STEADY_TIME),
        )
        self._entities.append(lambda: self.destroy_timer(timer))
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start the clocks and the calls."""
        result = super().on_activate(state)
        if result == TransitionCallbackReturn.SUCCESS:
            self._start_calls()
        return result

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the calls; values are still taken."""
        self._stop()
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Terminate the function."""
        self._end()
        return super().on_cleanup(state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the calls and terminate the function, if it was initialized."""
        self._end()
        return super().on_shutdown(state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the calls and terminate the function; the node can be configured again."""
        self._end()
        return TransitionCallbackReturn.SUCCESS

    def destroy_node(self) -> None:
        """Terminate the function, if this has not been done, and give its core back."""
        self._end()
        super().destroy_node()
        self._core.close()

    def prepare_end(self) -> None:
        """Do what needs the context, which ends next."""

    def _start_calls(self) -> None:
        self._core_clock.start()
        if self._is_in_lock_step:
            self._start()
            self._is_active = True
            return
        self._is_active = True
        if any(call.longest is not None for call in self._core.calls):
            self._watch = Watch(self._supervise)
        self._thread = Thread(target=self._run, name=self.get_name(), daemon=True)
        self._thread.start()

    def _start(self) -> None:
        with self.core_lock:
            self._core.start(self._core_clock.now())
        self._publish()

    def _stop(self) -> None:
        self._is_active = False
        self._core_clock.stop()
        if self._thread is not None:
            self._thread.join()
            self._thread = None
        if self._watch is not None:
            self._watch.stop()
            self._watch = None

    def _end(self) -> None:
        """Terminate the function once for each good initialization, and store what it keeps."""
        self._stop()
        if not self._is_initialized:
            return
        self._is_initialized = False
        if self._methods is not None:
            self._methods.shutdown()
            self._methods = None
        with self._call_lock, self.core_lock:
            self._core.terminate(self._core_clock.now())
        if self._storage is not None:
            self._store(self._storage)
        for destroy in self._entities:
            destroy()
        self._entities.clear()
        self._topics.clear()
        self._core_clock.close()

    def _make_clock(self) -> Clock:
        self._is_in_lock_step = bool(self._function_parameters.value('lock_step'))
        if self._is_in_lock_step:
            return LockStepClock(self)
        if self._function_parameters.value('use_sim_time'):
            return SimulatedClock(self)
        return SteadyClock(self)

    def _refuse_unknown_transitions(self) -> None:
        """
        Answer a transition that the state does not have with `success: false`.

        rclpy raises an exception instead, which ends the executor (ros2/rclpy#1209).
        """
        change = self._service_change_state
        handle = change.callback

        def guarded(request: Any, response: Any) -> Any:
            asked = request.transition
            known = [(each[0], each[1]) for each in self._state_machine.available_transitions]
            if any(asked.label == name if asked.label else asked.id == number
                   for number, name in known):
                return handle(request, response)
            self.get_logger().warning(
                f'Transition {asked.label or asked.id} is not possible in this state'
            )
            response.success = False
            return response

        change.callback = guarded

    # -- calls --------------------------------------------------------------------------

    def _run(self) -> None:
        """Run what is due until the clock is stopped."""
        self._scheduling_problem = self._schedule_thread()
        try:
            due = 1  # simulated time is 0 until it is known
            if self._core_clock.wait_until(due):
                self._start()
            while self._core_clock.wait_until(due):
                if self._core_clock.has_gone_back():
                    self.get_logger().warning('The time has gone back: the clocks start again')
                    self._start()
                self._run_due_calls()
                with self.core_lock:
                    due = self._core.next_time()
        except Exception:
            if self.context.ok():
                self._scheduling_problem = 'the calls have ended: see the log'
                self.get_logger().fatal(f'The calls have ended: {traceback.format_exc()}')

    def _run_due_calls(self) -> None:
        while not self._core_clock.is_stopped:
            with self._call_lock:
                with self.core_lock:
                    call = self._core.next_call(self._core_clock.now())
                if call == NO_CALL:
                    break
                self._run_call(call)
        self._supervise()

    def _supervise(self) -> None:
        with self.core_lock:
            self._core.supervise(self._core_clock.now())
        self._publish()

    def _run_call(self, call: int) -> None:
        begin = monotonic_ns()
        stamp = self._core_clock.stamp()
        with self.core_lock:
            self._core.set_input(call, self._core_clock.now())
            self._core.begin(call, self._core_clock.now())
        self._publish(stamp)
        logic = self._run_watched(call)
        with self.core_lock:
            self._core.get_output(call, self._core_clock.now())
        self._times[call - 1].add(monotonic_ns() - begin - logic, logic)
        self._publish(stamp)

    def _run_watched(self, call: int) -> int:
        """Run a call, and answer how many nanoseconds it took."""
        begin = monotonic_ns()
        if self._watch is None:
            self._core.run(call)
        else:
            self._watch.begin(self._core.calls[call - 1].longest)
            self._core.run(call)
            self._watch.end()
        return monotonic_ns() - begin

    def _publish(self, stamp: Optional[Time] = None) -> None:
        """Send the published values, in the order of the core."""
        with self._publishing:
            with self.core_lock:
                out, publish = self._core.out(), self._core.publish()
                self._core.published()
                states = [each.state for each in self._core.error_status()]
            if any(publish):
                self.send(out, publish, stamp or self._core_clock.stamp())
            is_changed, self._told_states = states != self._told_states, states
        if is_changed and self._is_initialized:
            self._tell()

    def _schedule_thread(self) -> str:
        """Ask for the policy that the parameter names, and answer the problem, if any."""
        if self.priority is None:
            return ''
        policy = self._function_parameters.value('scheduling_policy')
        if policy == 'other':
            return ''
        policies = {'fifo': os.SCHED_FIFO, 'rr': os.SCHED_RR}
        try:
            os.sched_setscheduler(0, policies[policy], os.sched_param(self.priority))
        except OSError as error:
            problem = f'scheduling_policy {policy} is refused: {error.strerror}'
            self.get_logger().warning(problem)
            return problem
        return ''

    # -- topics and services ------------------------------------------------------------

    def take(
        self, message: Any, topic: str, quality: QoSProfile,
        receive: Callable[[Any, int], None], *, wakes: bool = False,
    ) -> None:
        """Subscribe to a topic whose messages `receive` hands over to the core."""
        def store(value: Any) -> None:
            try:
                self.hand_over(receive, value, wakes=wakes)
            except Exception as error:
                self.get_logger().fatal(f'A message was not taken: {error}')

        self._topics.subscribe(message, topic, quality, store)

    def give(self, message: Any, topic: str, quality: QoSProfile) -> Callable[[Any], None]:
        """Advertise a topic, and answer what sends a message on it while the node is active."""
        return self._topics.advertise(message, topic, quality)

    def hand_over(
        self, receive: Callable[[Any, int], None], value: Any, *, wakes: bool = False
    ) -> None:
        """Give a value to the core, which another node or a call of the function has sent."""
        with self.core_lock:
            receive(value, self._core_clock.now())
        if wakes:
            self._core_clock.wake()

    def offer(self, service: Any, name: str, serve: Callable[[Any, Any], Any]) -> None:
        """
        Offer a method, which runs while no call does.

        It waits for the call in a thread of the methods: the executor takes messages meanwhile.
        """
        if self._methods is None:
            self._methods = ThreadPoolExecutor(max_workers=1)
        made = self.create_service(service, name, lambda request, response: (request, response))
        submit, send = self._methods.submit, made.send_response

        def answer(asked: Tuple[Any, Any], header: Any) -> None:
            try:
                with self._call_lock:
                    response = serve(*asked)
                send(response, header)
            except Exception as error:
                self.failure.set_exception(error)

        made.send_response = lambda asked, header: submit(answer, asked, header)
        self._entities.append(lambda: self.destroy_service(made))

    def use(self, service: Any, name: str) -> Any:
        """Create a client of a method."""
        client = self.create_client(service, name, callback_group=self._answers_group)
        self._entities.append(lambda: self.destroy_client(client))
        return client

    def ask(
        self, client: Any, request: Any, answered: Callable[[Optional[Any], int], None]
    ) -> None:
        """Send a request, and hand the answer over; None if no node offers the method."""
        def answer(response: Optional[Any]) -> None:
            with self.core_lock:
                answered(response, self._core_clock.now())
            self._core_clock.wake()

        def take(asked: Future) -> None:
            try:
                answer(asked.result())
            except Exception as error:
                # An exception of a task ends some releases' executor of events: ros2/rclpy#1641.
                self.failure.set_exception(error)

        if client.service_is_ready():
            client.call_async(request).add_done_callback(take)
        else:
            answer(None)

    def _on_step(self, request: Any, response: Any) -> Any:
        """Take messages, run what is due now, and set the time."""
        has_come = self._topics.wait_for_received(request.received, PATIENCE)
        response.success = has_come and self._is_active
        if not has_come:
            response.message = 'not as many messages have come'
        elif not self._is_active:
            response.message = 'the node is not active'
        elif not request.only_wait:
            self._run_due_calls()
            self._core_clock.set_time(request.time)
            with self.core_lock:
                response.next = self._core.next_time()
        response.received, response.sent = self._topics.received, self._topics.sent
        return response

    # -- parameters ---------------------------------------------------------------------

    def declare(
        self, name: str, default: Any, descriptor: ParameterDescriptor, limits: Limits = ANY,
    ) -> None:
        """Declare a parameter of the function."""
        self._function_parameters.declare(name, default, descriptor, limits)

    # -- storage ------------------------------------------------------------------------

    def _make_storage(self) -> storage.Storage:
        folder = self._function_parameters.value('storage_folder')
        path = Path(folder) if folder else storage.default_folder(self._core.package)
        name, domain = self.get_fully_qualified_name(), self.context.get_domain_id()
        return storage.Storage(storage.file_of(path, name, domain), self._core)

    def _load(self) -> Dict[str, Any]:
        if not self._is_stored:
            return {}
        self._storage = self._make_storage()
        try:
            return self._storage.load()
        except BrokenFile as error:
            self._leave_aside(self._storage, error)
        return {}

    def _leave_aside(self, kept: storage.Storage, error: BrokenFile) -> None:
        how = 'is left aside'
        try:
            kept.set_aside()
        except OSError as reason:
            how = f'is not used, and cannot be left aside ({reason.strerror})'
        self.get_logger().error(f'{kept.path} {how}: {error}')

    def _store(self, kept: storage.Storage) -> None:
        try:
            kept.save()
        except OSError as error:
            self.get_logger().error(f'{kept.path} cannot be written: {error}')

    # -- diagnostics --------------------------------------------------------------------

    def _tick(self) -> None:
        self._topics.tick(self.PERIOD)
        self._tell()

    def _tell(self) -> None:
        """Say how errors, topics and calls are, if anybody listens."""
        if self._diagnostics.get_subscription_count() == 0:
            return
        node, core = self.get_fully_qualified_name().strip('/'), self._core
        with self.core_lock:
            errors, calls = core.error_status(), core.call_counts()
        statuses = [diagnostics.error_status(node, *each) for each in zip(core.errors, errors)]
        statuses += [
            diagnostics.call_status(node, *each) for each in zip(core.calls, calls, self._times)
        ]
        if self.priority is not None or self._scheduling_problem:
            statuses.append(diagnostics.scheduling_status(node, self._scheduling_problem))
        excluded = [times.is_excluded(count.dropped) for count, times in zip(calls, self._times)]
        has_calls = self._is_active and not (excluded and all(excluded))
        statuses += self._topics.statuses(node, has_calls=has_calls)
        stamp = self.get_clock().now().to_msg()
        self._diagnostics.publish(diagnostics.diagnostic_array(stamp, statuses))


def spin(make: Callable[[], FunctionNode], args: Optional[List[str]] = None) -> None:
    """Run a node until it is interrupted."""
    # A thread takes the signals. As an exception, an interrupt would come anywhere: in the
    # middle of an executor of events it aborts the process. A handler of rclpy ends the context
    # before the node has told that it ends.
    reader, writer = socketpair()
    writer.setblocking(False)
    set_wakeup_fd(writer.fileno(), warn_on_full_buffer=False)
    for number in (SIGINT, SIGTERM):
        signal(number, lambda number, frame: None)
    try:
        rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)
        node = make()
    except Exception as error:  # of settings that it refuses
        get_logger(Path(sys.argv[0]).name).fatal(f'the node does not start: {error}')
        rclpy.try_shutdown()
        set_wakeup_fd(-1)
        sys.exit(1)
    Thread(target=_end_on_signal, args=(node, reader), daemon=True).start()
    try:
        spin_node(node, node.failure)
    except ExternalShutdownException:
        pass
    except Exception:
        if node.context.ok():  # otherwise it is the end of the context, which is noticed anywhere
            raise
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
        set_wakeup_fd(-1)
        for each in (reader, writer):  # stay open: another thread may just take a further signal
            each.detach()


def _end_on_signal(node: FunctionNode, reader: socket) -> None:
    reader.recv(1)
    node.prepare_end()
    if not node.failure.done():
        node.failure.set_result(None)
