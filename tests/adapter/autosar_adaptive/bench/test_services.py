"""Two processes, one of which offers what the other one uses: events, fields, methods, over SOME/IP on loopback."""

import signal
import sys
from collections.abc import Mapping
from pathlib import Path

from tests.adapter.autosar_adaptive.own_network import Network, Program, own_network
from tests.needs import c_compiler
from tests.processes import is_stopped
from tests.waiting import wait_until

pytestmark = [own_network, c_compiler]


def pair(net: Network, built: Mapping[str, Path], *mode: str) -> tuple[Program, Program]:
    """A sender that offers, and a receiver that has found it."""
    sender = net.start([built["sender"], *mode]).tells("ready").do("mode 0", "offer").tells("done offer")
    receiver = net.start([built["receiver"]]).tells_in_any_order("ready", "found 1")
    return sender, receiver


def subscribed(receiver: Program) -> Program:
    """The receiver, when all its subscriptions are confirmed, in whichever order."""
    receiver.do("subscribe")
    awaited = {f"{name} is subscribed" for name in ("Speed", "Track", "Image", "Mode")}
    while awaited:
        awaited.discard(receiver.next_line())
    return receiver


def test_events_of_every_datatype_arrive(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    sender.do("speed 12.5", "track Nürburg").tells("done track")
    receiver.tells("speed 12.5", "track Nürburg 1 -2 3 0.5")
    sender.quit()
    receiver.quit()


def test_an_event_that_is_longer_than_a_datagram_arrives_in_segments(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    sender.do("image 1396", "image 1397", "image 200000", "speed 1")
    receiver.tells("image 1396 whole", "image 1397 whole", "image 200000 whole")
    receiver.quit()
    sender.quit()


def test_no_event_is_lost_or_overtakes_another_one(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    for _ in range(10):
        sender.do("speeds 100").tells("done speeds")
        receiver.tells(*(f"speed {n}" for n in range(100)))
    assert [line for line in receiver.told if line.startswith("speed")] == [f"speed {n}" for n in range(100)] * 10


def test_who_subscribes_late_is_sent_the_value_of_a_field(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    sender.do("mode 1").tells("done mode")
    receiver.do("subscribe").tells("mode 1")
    sender.do("mode 0")
    receiver.tells("mode 0")
    another = net.start([built["receiver"]]).tells("found 1").do("subscribe")
    another.tells("mode 0")


def test_a_field_can_be_asked_for(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    sender.do("mode 1").tells("done mode")
    receiver.do("get").tells("got 1")


def test_a_service_without_the_value_of_its_field_is_not_offered(net: Network, built: Mapping[str, Path]) -> None:
    sender = net.start([built["sender"]]).tells("ready").do("offer").tells("refused offer")
    sender.do("speed 1").tells("refused speed")
    sender.do("mode 0", "offer").tells("done offer")


def test_methods_are_answered(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    receiver.do("add 40 2").tells("sum 42")
    receiver.do("reset").tells("reset")
    sender.tells("reset")


def test_application_errors_of_methods_arrive_by_name(net: Network, built: Mapping[str, Path]) -> None:
    _, receiver = pair(net, built)
    receiver.do("add -1 1").tells("add failed: The mode excludes the call, or the function is not initialized. 0")
    receiver.do("add -1 -1").tells("add failed: An argument has a number that its enumeration does not name. 0")
    receiver.do("add 1 -1").tells("add failed: The other side answered with an error. 1")


def test_a_skeleton_that_polls_answers_when_it_is_told_to(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built, "poll")
    sender.do("process").tells("refused process")
    receiver.do("add 1 1").tells("add timed out", "done add")
    sender.do("process").tells("done process")
    receiver.do("add 2 2")
    answer = ""
    while answer != "done process":  # the request is on its way
        answer = sender.do("process").next_line()
    receiver.tells("sum 4")


def test_what_is_no_longer_offered_is_lost_at_once_and_found_again(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    sender.do("stop")
    receiver.tells("found 0")
    receiver.do("add 1 1").tells("add failed: The service is not available. 0")
    sender.do("mode 1", "offer")
    receiver.tells("found 1", "mode 1")
    sender.do("speed 7")
    receiver.tells("speed 7")


def test_the_last_event_before_the_end_of_an_offer_arrives(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    receiver.process.send_signal(signal.SIGSTOP)
    wait_until(lambda: is_stopped(receiver.process.pid), "it has stopped")  # and finds both at once when it continues
    sender.do("speed 8", "stop").tells("done speed", "done stop")
    receiver.process.send_signal(signal.SIGCONT)
    receiver.tells("speed 8")
    receiver.tells("found 0")


def test_after_unsubscribing_nothing_arrives(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver).do("unsubscribe").tells("done unsubscribe")
    sender.do("speed 1", "mode 1", "speed 2").tells("done speed", "done mode", "done speed")
    receiver.do("get").tells("got 1", "done get")
    assert "speed 1" not in receiver.told
    subscribed(receiver)
    sender.do("speed 3")
    receiver.tells("speed 3")
    assert "speed 2" not in receiver.told


def test_each_process_has_the_instance_that_its_manifest_names(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    rear_receiver = net.start([built["receiver"]], BENCH_PROCESS="RearReceiver").tells("ready")
    rear_sender = net.start([built["sender"]], BENCH_PROCESS="RearSender").tells("ready")
    subscribed(receiver)
    rear_sender.do("mode 1", "offer").tells("done offer")
    rear_receiver.tells("found 1")
    subscribed(rear_receiver)
    sender.do("speed 1").tells("done speed")
    rear_sender.do("speed 2").tells("done speed")
    receiver.tells("speed 1")
    rear_receiver.tells("speed 2")
    sender.do("speed 3", "stop").tells("done stop")
    receiver.tells("speed 3", "found 0")
    assert "speed 2" not in receiver.told
    rear_sender.do("speed 4").tells("done speed")
    rear_receiver.tells("speed 4")
    assert not {"speed 1", "speed 3", "found 0"} & set(rear_receiver.told)


def test_a_search_for_any_instance_finds_all_of_them(net: Network, built: Mapping[str, Path]) -> None:
    receiver = net.start([built["receiver"], "any"]).tells("ready")
    sender = net.start([built["sender"]]).tells("ready")
    sender.do("mode 0", "offer").tells("done offer")
    receiver.tells("found 1")
    rear = net.start([built["sender"]], BENCH_PROCESS="RearSender").tells("ready")
    rear.do("mode 1", "offer").tells("done offer")
    receiver.tells("found 2")
    sender.do("stop")
    receiver.tells("found 1")


def test_an_address_that_is_in_use_is_refused(net: Network, built: Mapping[str, Path]) -> None:
    net.start([built["sender"]], SIGCAT_BENCH_ADDRESS="127.0.0.9").tells("ready")
    net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS="127.0.0.9").tells("The network cannot be used.")
    net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS="192.0.2.1").tells("The network cannot be used.")


_ON_ALL_ADDRESSES = """
import socket
receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
receiver.bind(("0.0.0.0", 30490))
print("ready", flush=True)
receiver.recv(1)
"""
"""As vsomeip receives service discovery."""


def test_another_implementation_may_receive_the_group_on_all_addresses(net: Network, built: Mapping[str, Path]) -> None:
    sender = net.start([built["sender"]]).tells("ready")
    net.start([sys.executable, "-c", _ON_ALL_ADDRESSES]).tells("ready")
    sender.do("mode 0", "offer").tells("done offer")
    net.start([built["receiver"]]).tells_in_any_order("ready", "found 1")
