"""Answers of thousands of nodes: a few are made at once, in threads, and clients take turns."""

import asyncio
from collections.abc import Callable, Iterable
from typing import ParamSpec, TypeVar

from fastapi import Request

from sigcat.api.requests.thread_turns import in_thread, to_the_end
from sigcat.api.work.turns import Turns
from sigcat.catalogue.model.catalogue import Node

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")
_MANY = 500
"""Nodes that take some milliseconds: others can wait for as long."""


async def in_turn(
    request: Request,
    nodes: Iterable[Node],
    depth: int,
    function: Callable[_Arguments, _Result],
    *arguments: _Arguments.args,
    **options: _Arguments.kwargs,
) -> _Result:
    """Return the function's result from a thread; many nodes down to `depth` have separate turns."""
    if not has_more(nodes, depth, _MANY):
        return await in_thread(request, function, *arguments, **options)
    turns: Turns = request.app.state.reading_turns
    return await to_the_end(request, turns, "long-answers", lambda: asyncio.to_thread(function, *arguments, **options))


def has_more(nodes: Iterable[Node], depth: int, limit: int) -> bool:
    """Whether nodes and those below them, down to a depth, are more than a limit."""
    level = list(nodes)
    count = len(level)
    for _ in range(depth):
        if count > limit or not level:
            break
        level = [child for each in level for child in each.children]
        count += len(level)
    return count > limit
