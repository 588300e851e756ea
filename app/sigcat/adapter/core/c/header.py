"""The header: types, members of the adapter, and what the platform calls."""

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.text.layout import c_lines
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.adapter.core.plan import CorePlan
from sigcat.function.document.text import Text, composed


def header(scope: Scope) -> Lines:
    """The whole header."""
    return c_lines(
        "adapter/core/c/header.h.j2", p=scope.prefix, m=scope.macro, plan=scope.plan, about=about(scope.plan)
    )


def about(plan: CorePlan) -> Text:
    """The first sentence of both files."""
    version = f" {plan.version}" if plan.version else ""
    return composed(f"Adapter of {plan.function}{version}: ", plan.description)
