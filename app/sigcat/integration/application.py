"""Parts that every platform derives alike from a set of functions: responsible team, name, date, components."""

import datetime as dt
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.errors import UsageError
from sigcat.function.document.text import Text, optional
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, MetaInfo
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment

DEFAULT_VERSION = "1.0.0"
"""Version of a document whose deployment states none."""


class Application(NamedTuple):
    """A set of functions, and what their documents say of it: as the deployment has it, or else as they say."""

    functions: tuple[ResolvedFunction, ...]
    """By name."""
    name: str
    description: Text
    responsible: Text
    authority: Text
    author: Text
    date: dt.date | None
    """The latest of the functions' dates."""
    version: str | None
    """As the deployment states it: functions have their own versions."""
    safety_manager: Text | None
    """Sender of safety conditions."""
    mode_manager: Text | None
    """Sender of modes."""
    paths: Mapping[str, str]
    """VSS paths of signals that name none, by `Function.Signal`."""

    @property
    def wholes(self) -> tuple[FunctionJson, ...]:
        """The functions without the files that they are read from."""
        return tuple(each.function for each in self.functions)

    @property
    def provenance(self) -> tuple[dict[str, Any], ...] | None:
        """Origins of the functions, as each states it; None if none does."""
        stated = (each.provenance for each in self.wholes)
        return tuple(each.model_dump(mode="json") for each in stated if each) or None


def application(functions: Sequence[ResolvedFunction], deployment: Deployment = NO_DEPLOYMENT) -> Application:
    """The application of a function or a set. Raises UsageError if there is none, or one twice."""
    if not functions:
        raise UsageError("No function to integrate. Name at least one.")
    ordered = tuple(sorted(functions, key=lambda function: function.name))
    wholes = [function.function for function in ordered]
    infos = [function.info for function in wholes]
    refuse_doubles(functions)
    return Application(
        functions=ordered,
        name=deployment.name or " and ".join(info.function_name for info in infos),
        description=optional(deployment.description) or joined((info.description for info in infos), " "),
        responsible=optional(deployment.responsible) or joined(info.function_responsible for info in infos),
        authority=optional(deployment.authority) or joined(function.meta.authority for function in wholes),
        author=optional(deployment.author) or joined(function.meta.schema_author for function in wholes),
        date=deployment.date or max(filter(None, map(_date, wholes)), default=None),
        version=deployment.version,
        safety_manager=optional(deployment.safety_manager),
        mode_manager=optional(deployment.mode_manager),
        paths=deployment.paths,
    )


def meta_of(app: Application, about: str) -> MetaInfo:
    """The persons responsible for a document about the application."""
    return MetaInfo(
        authority=app.authority or None,
        schema_author=app.author or None,
        date=app.date.strftime("%d.%m.%Y") if app.date else None,
        schema_version=DEFAULT_VERSION,
        schema_description=Text(about),
    )


def info_of(app: Application, version: str | None) -> FunctionInfo:
    """The application as Function JSON describes a function."""
    return FunctionInfo(
        function_name=app.name,
        function_responsible=app.responsible,
        description=app.description,
        version=version,
    )


def joined(texts: Iterable[Text | None], separator: str = "; ") -> Text:
    """Texts that are there, each once. Names of organizations have commas, so that these do not separate them."""
    return Text(separator.join(dict.fromkeys(text.raw for text in texts if text)))


def refuse_doubles(functions: Sequence[ResolvedFunction]) -> None:
    """Raise UsageError if a function is given twice."""
    first: dict[str, ResolvedFunction] = {}
    for function in functions:
        other = first.setdefault(function.name, function)
        if other is not function:
            files = tuple(dict.fromkeys((other.document.name, function.document.name)))
            where = f"in {' and in '.join(files)}" if len(files) > 1 else f"named twice, as {files[0]}"
            raise UsageError(f"{function.name} is {where}: name one, or remove one from the project")


def _date(function: FunctionJson) -> dt.date | None:
    """The date of a function; None if there is none, or no such day."""
    match = re.fullmatch(r"(\d{2}).(\d{2}).(\d{4})", function.meta.date or "")
    try:
        return dt.date(int(match[3]), int(match[2]), int(match[1])) if match else None
    except ValueError:
        return None
