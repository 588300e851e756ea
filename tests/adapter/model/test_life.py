"""Section 1: life."""

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.schedule import NEVER
from tests.adapter.written import call, function, mode_interface, output, parameter, reaction, signal, step


def init(**fields):
    return call("Init", "Init", **fields)


def test_init_is_called_once_with_everything_written_and_parameters_are_written_once_more():
    document = function(init(), step(signal("Speed", InitValue=3), parameter("Gain", InitValue=2), reaction("Stop")))
    run = Driven(document, F_Init=lambda variables: variables.update(gain=0, speed=-1))
    run.start()
    assert run.called == ["F_Init"]
    assert run.seen[0] == {"speed": 3.0, "gain": 2.0, "stop": 0}
    assert run.variables["gain"] == 2.0
    assert run.variables["speed"] == -1


def test_a_failed_init_makes_no_call_publishes_nothing_and_makes_reactions_active():
    run = Driven(function(init(SuccessValue=0), step(reaction("Stop"))), F_Init=lambda _: 1)
    assert not run.adapter.init()
    run.adapter.start(0)
    assert run.adapter.next_call(10**9) is None
    assert run.adapter.publish == frozenset()
    assert run.adapter.out["Stop"] == 1


def test_init_is_good_with_its_success_value_and_where_there_is_no_init():
    assert Driven(function(init(SuccessValue=7), step()), F_Init=lambda _: 7).adapter.init()
    assert Driven(function(step())).adapter.init()


def test_no_call_is_due_before_init_and_before_start():
    run = Driven(function(step()))
    assert run.adapter.next_call(0) is None
    run.adapter.start(0)
    assert run.adapter.next_call(0) is None
    run.adapter.init()
    assert run.adapter.next_call(0) is None
    assert run.adapter.next_time() == NEVER


def test_the_first_start_publishes_reactions_and_mode_out():
    document = function(step(reaction("Stop")), modes=(mode_interface("Out", "OFF", "ON", Values=[]),))
    run = Driven(document)
    run.variables["mode_out"] = 11
    run.start()
    assert run.published() == {"Stop", "F_Mode_Out"}
    assert run.adapter.out["F_Mode_Out"] == 11
    run.adapter.start(5)
    assert run.published() == set()


def test_a_later_start_drops_what_was_due_before_it_and_keeps_the_grid():
    run = Driven(function(step())).start()
    run.steps(0, 10)
    run.adapter.start(50 * 10**6)
    assert run.adapter.running.calls["F_Step"].activations.dropped == 3
    run.steps(50, 60)
    assert run.adapter.running.calls["F_Step"].activations.missed == 0


def test_terminate_is_called_once_and_ends_the_calls():
    run = Driven(function(step(), call("Terminate", "Shutdown"))).start()
    run.adapter.terminate(1)
    run.adapter.terminate(2)
    assert run.called == ["F_Terminate"]
    assert run.step(100) is None


def test_terminate_is_not_called_after_a_failed_init():
    run = Driven(function(init(SuccessValue=0), step(), call("Terminate", "Shutdown")), F_Init=lambda _: 5)
    run.adapter.init()
    run.adapter.terminate(1)
    assert run.called == ["F_Init"]


def test_init_anew_clears_all_the_time_too():
    run = Driven(function(step(signal("Speed", InitValue=1)))).start(1000)
    run.receive("Speed", 5.0, 1000)
    run.steps(1000)
    run.adapter.terminate(2000 * 10**6)
    run.start(0)
    run.steps(0)
    assert run.seen[-1]["speed"] == 1.0


def test_what_is_sent_has_a_value_from_the_beginning():
    document = function(step(output("A", InitValue=4), output("B", Default=5), output("C")))
    run = Driven(document).start()
    assert run.adapter.out == {"A": 4.0, "B": 5.0, "C": 0.0}


def test_hooks_run_before_and_after_the_call():
    document = function(step(PreProcessing=["first", "second"], PostProcessing=["last"], Symbol="work"))
    run = Driven(document).start()
    run.steps(0)
    assert run.called == ["first", "second", "work", "last"]
