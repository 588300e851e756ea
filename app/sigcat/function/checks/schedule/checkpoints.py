"""The graph of the logical supervision: calls that may follow each other."""

from sigcat import codes
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.code import Checkpoint
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import Located, runnables
from sigcat.names import did_you_mean


def check_checkpoints(function: FunctionJson) -> Problems:
    """Every problem of the graph."""
    calls = {located.runnable.name: located for located in runnables(function)}
    graph = {name: located.runnable.checkpoint for name, located in calls.items() if located.runnable.checkpoint}
    watchdogs = ((located, located.runnable.watchdog) for located in calls.values())
    supervised = [located for located, watchdog in watchdogs if watchdog and watchdog.logical]
    unknown = list(_unknown(graph, calls))
    yield from unknown
    if not unknown:
        yield from _unreached(graph, calls)
    yield from _in_words(supervised, is_drawn=bool(graph))
    if graph and not supervised:
        name = next(iter(graph))
        message = f"A call must be under logical supervision for its checkpoint to be watched; no call of {function.info.function_name} is."
        fix = "Add `logicalSupervision` with its error to a call, or remove the checkpoints."
        at, subject = (*calls[name].pointer, "Checkpoint"), Subject("scheduling", name)
        yield Problem(codes.CHECKPOINT_UNSUPERVISED, at, message, fix, subject)


def _unknown(graph: dict[str, Checkpoint], calls: dict[str, Located]) -> Problems:
    last_names = [name.rpartition("_")[2] for name in calls]
    for name, checkpoint in graph.items():
        for index, following in enumerate(checkpoint.next or ()):
            if following not in graph:
                is_call = following in calls
                what = "a call with a checkpoint" if is_call else "a call of the function"
                message = f"After {name} must follow {what}, not {following!r}."
                near = did_you_mean(following, calls) or did_you_mean(following, last_names)
                fix = "Give that call a `checkpoint`." if is_call else near
                at, subject = (*calls[name].pointer, "Checkpoint", "Next", index), Subject("scheduling", name)
                yield Problem(codes.CHECKPOINT_UNKNOWN, at, message, fix, subject, Subject("scheduling", following))


def _unreached(graph: dict[str, Checkpoint], calls: dict[str, Located]) -> Problems:
    """Checkpoints that no sequence reaches, as none begins there and none leads there."""
    reached = {name for name, checkpoint in graph.items() if checkpoint.initial}
    if graph and not reached:
        name = next(iter(graph))
        message = "A sequence must begin with a checkpoint; none is initial."
        fix = "Write `initial: true` at the first call."
        at, subject = (*calls[name].pointer, "Checkpoint"), Subject("scheduling", name)
        yield Problem(codes.CHECKPOINT_UNREACHED, at, message, fix, subject)
        return
    waiting = list(reached)
    while waiting:
        following = set(graph[waiting.pop()].next or ()) - reached
        reached |= following
        waiting.extend(following)
    for name in (name for name in graph if name not in reached):
        message = f"The checkpoint {name} must follow one that a sequence reaches; none leads to it."
        fix = "Add it to `next` of the call before it, or write `initial: true`."
        at, subject = (*calls[name].pointer, "Checkpoint"), Subject("scheduling", name)
        yield Problem(codes.CHECKPOINT_UNREACHED, at, message, fix, subject)


def _in_words(supervised: list[Located], *, is_drawn: bool) -> Problems:
    """A logical supervision that only people can read."""
    for located in supervised if not is_drawn else ():
        call = located.runnable
        message = f"The logical supervision of {call.name} is only text: no program can check it."
        fix = "Give the calls a `checkpoint` each, with the calls that may follow."
        at = (*located.pointer, "Watchdog", "LogicalSupervision")
        yield Problem(codes.SUPERVISION_IN_WORDS, at, message, fix, Subject("scheduling", call.name))
