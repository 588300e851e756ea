"""Functions that may have to do with those that are deployed: of all others, nothing is read."""

from collections.abc import Sequence

from sqlalchemy import Connection

from sigcat.registry.compatibility.member import Member
from sigcat.registry.published import Published
from sigcat.registry.users import versions_with


def concerned(
    connection: Connection, deployed: Sequence[Member], replaced: Sequence[Member], field: Sequence[Published]
) -> tuple[Published, ...]:
    """The versions of a field with which a deployment may conflict.

    They exchange something with the deployed functions, or with the versions that these replace. All versions of such a
    function are in question: a vehicle has one of them. Orders of calls and errors lead to any function.
    """
    if any(each.dependencies for each in deployed):
        return tuple(field)
    elements = frozenset[str]().union(*(each.elements for each in (*deployed, *replaced)))
    versions = versions_with(connection, sorted(elements))
    names = {each.name for each in field if each.id in versions}
    return tuple(each for each in field if each.name in names)
