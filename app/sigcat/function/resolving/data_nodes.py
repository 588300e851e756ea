"""The node of the catalogue that a path of a declaration means."""

from sigcat import codes
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.definition import PROPERTY, SIGNALS, STRUCT
from sigcat.catalogue.model.interfaces import category_of
from sigcat.catalogue.near_signals import is_to_be_chosen
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.resolving.context import Context
from sigcat.names import did_you_mean, last_name, parent_path, with_article


def data_node(path: str, at: Pointer, context: Context) -> Node | None:
    """The signal or parameter at a path; None, with a problem, if there is none."""
    node = context.data(path)
    if node is None:
        context.problems.append(_unknown(path, at, context))
        return None
    return data_of(node, at, context)


def data_of(node: Node, at: Pointer, context: Context) -> Node | None:
    """The node, if it is a signal or parameter; None, with a problem, if it is not."""
    path = node.path
    subject = Subject("data", path)
    if not node.is_leaf or node.type not in SIGNALS or category_of(node.path) != "data":
        message, fix = f"{path!r} must be a data interface, not {_kind_of(node)}.", _instead(node)
        context.report(codes.SIGNAL_HOLDS_NO_VALUE, at, message, fix, subject)
        return None
    deprecation = node.values.get("deprecation")
    if deprecation:
        context.report(codes.SIGNAL_DEPRECATED, at, f"{path!r} is deprecated: {deprecation}", subject=subject)
    return node


def _unknown(path: str, at: Pointer, context: Context) -> Problem:
    instance = context.instances.get(path)
    if instance:
        message, fix = f"{path!r} must name an instance.", f"Name one, such as {instance!r}."
    else:
        message = f"The catalogue has no signal {path!r}."
        fix = _moved(path, context) or _defined(path, context) or proposed(path, context)
        fix = fix or "Define it under `define`, or pass the overlay that defines it with `-l OVERLAY`."
    return Problem(codes.SIGNAL_UNKNOWN, at, message, fix, Subject("data", path))


def _moved(path: str, context: Context) -> str:
    """A sentence that names the signal whose `fka` has the path; empty if none has."""
    now = next((node.path for node in context.catalogue.nodes.values() if path in (node.values.get("fka") or ())), "")
    return f"It is {now!r} now, as the `fka` there says. `sigcat migrate` renames it in all files." if now else ""


def proposed(path: str, context: Context) -> str:
    """A sentence that proposes the signals that an unknown path may mean; or nothing."""
    return context.meant(path) or _spelled_alike(path, context)


def _spelled_alike(path: str, context: Context) -> str:
    if is_to_be_chosen(path):
        return ""
    signals = [node.path for node in context.catalogue.nodes.values() if node.type in SIGNALS]
    return did_you_mean(path, signals) or did_you_mean(path, context.own_parameters)


def _defined(name: str, context: Context) -> str:
    """The whole path of a signal that the file defines, where its last name is given."""
    paths = (node.path for node in context.definitions.nodes if last_name(node.path) == name)
    path = next((path for path in paths if category_of(path) == "data"), "")
    return f"Name it by its path, {path!r}." if path else ""


def _kind_of(node: Node) -> str:
    if node.type == PROPERTY:
        return "a property of a struct"
    if not node.is_leaf:
        return "a struct" if node.type == STRUCT else "a branch"
    return with_article(f"{category_of(node.path)} interface".replace("_", " "))


def _instead(node: Node) -> str:
    if node.type in (STRUCT, PROPERTY):
        struct = node.path if node.type == STRUCT else parent_path(node.path)
        return f"Define a signal with the datatype {struct!r}, and name that."
    if node.is_leaf:
        return "List it under `errors`, `safetyReactions` or `modes`."
    leaves = [leaf.path for leaf in node.walk() if leaf.is_leaf][:3]
    return f"Name a signal below it, such as {', '.join(map(repr, leaves))}." if leaves else ""
