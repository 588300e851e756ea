"""The documents that are made from functions, each to be read, copied and downloaded."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import NamedTuple
from urllib.parse import quote

from starlette.responses import Response

from sigcat.adapter.core.cores import cores
from sigcat.errors import InputRefused, NotFound
from sigcat.findings import Finding
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.limits import DEFAULT_LIMITS
from sigcat.names import nearest
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Generator, Integrated, Options, Platform
from sigcat.platforms.table import PLATFORMS


class GeneratedDocument(NamedTuple):
    """A document. The findings say why it could not be made."""

    id: str
    """Name in addresses: its view, and below that its file, so that no other view is made to find it."""
    view: str
    """Documents of one view are shown together."""
    file: str
    """Name of the file when it is downloaded."""
    media_type: str
    text: str
    findings: tuple[Finding, ...] = ()
    is_made: bool = True

    @property
    def folder(self) -> str:
        """The folder of the file; empty if it has none."""
        return self.file.rpartition("/")[0]

    @property
    def name(self) -> str:
        """The file without its folder."""
        return self.file.rpartition("/")[2]


JSON = "application/json"
_SHOWN_ELSEWHERE = frozenset(("arxml", "core"))
"""Folders of files with a separate view."""
FUNCTION_JSON = "function-json"
CORE = "core"
_GENERATED = [(platform, generator) for platform in PLATFORMS.values() for generator in platform.generators]
_FIRST_OF_A_TITLE = {generator.title: platform for platform, generator in reversed(_GENERATED)}


def views_of(platform: Platform) -> Mapping[str, str]:
    """The Integration JSON of a platform, then what is generated from it; a title that another one has says of which it is."""
    titles = {
        generator.view or generator.name: generator.title
        if _FIRST_OF_A_TITLE[generator.title] is platform
        else f"{generator.title}, {platform.title}"
        for generator in platform.generators
    }
    return {platform.name: platform.title, **titles}


SET_VIEWS = {CORE: "Core in C", **{k: v for platform in PLATFORMS.values() for k, v in views_of(platform).items()}}
"""The views of a set of functions, by their titles."""
VIEWS = {FUNCTION_JSON: "Function JSON", **SET_VIEWS}
"""Views of one function."""


def documents_of(function: ResolvedFunction, views: Collection[str]) -> tuple[GeneratedDocument, ...]:
    """The documents of a function in some views."""
    own = (_function_json(function.function),) if FUNCTION_JSON in views else ()
    return (*own, *integrations_of((function,), function.name, views))


def integrations_of(
    functions: Sequence[ResolvedFunction], name: str, views: Collection[str]
) -> tuple[GeneratedDocument, ...]:
    """The documents of functions in some views, as without a deployment file. A platform is integrated once for its views."""
    integrated = {p: _integrated(p, functions) for p in PLATFORMS.values() if not views_of(p).keys().isdisjoint(views)}
    return (
        *(document for function in functions if CORE in views for document in _core(function)),
        *(_integration(platform, each, name) for platform, each in integrated.items() if platform.name in views),
        *(
            document
            for platform, each in integrated.items()
            for generator in platform.generators
            if (generator.view or generator.name) in views
            for document in _generated(platform, generator, each, name)
        ),
    )


def document_named(given: str, made: Callable[[Collection[str]], Iterable[GeneratedDocument]]) -> GeneratedDocument:
    """The document that an address or a form names, of those of a view. Raises NotFound with the nearest ones."""
    view = given.partition(".")[0]
    known = {document.id: document for document in (made((view,)) if view in VIEWS else ()) if document.is_made}
    if given not in known:
        raise NotFound(f"Unknown document {given[:100]!r}.", nearest(given[:100], known or VIEWS))
    return known[given]


def attached(document: GeneratedDocument) -> Response:
    """The document as a file to be kept."""
    return attachment(document.text.encode("utf-8", "replace"), document.file, document.media_type)


def attachment(content: bytes, file: str, media_type: str) -> Response:
    """Bytes as a file to be kept."""
    disposition = f"attachment; filename*=UTF-8''{quote(file, safe='')}"
    return Response(content, media_type=media_type, headers={"Content-Disposition": disposition})


def _function_json(function: FunctionJson) -> GeneratedDocument:
    name = f"{function.info.function_name}.json"
    return GeneratedDocument(FUNCTION_JSON, FUNCTION_JSON, name, JSON, _text(to_json(function)))


def _core(function: ResolvedFunction) -> tuple[GeneratedDocument, ...]:
    """Header and source of the core of an adapter."""
    try:
        files, findings = cores((function,))
    except InputRefused as refused:
        name = f"{function.name}_adapter"
        return (GeneratedDocument(f"{CORE}.{name}", CORE, name, "", "", tuple(refused.findings), is_made=False),)
    made = [GeneratedDocument(f"{CORE}.{file.name}", CORE, file.name, "text/plain", _text(file.data)) for file in files]
    return (made[0]._replace(findings=findings), *made[1:])


def _integrated(platform: Platform, functions: Sequence[ResolvedFunction]) -> Integrated | InputRefused:
    """The Integration JSON, once for all that is generated from it, or why there is none."""
    try:
        return integrate(platform, functions)
    except InputRefused as refused:
        return refused


def _integration(platform: Platform, integrated: Integrated | InputRefused, name: str) -> GeneratedDocument:
    document = GeneratedDocument(platform.name, platform.name, f"{name}.{platform.name}.json", JSON, "")
    if isinstance(integrated, InputRefused):
        return document._replace(findings=tuple(integrated.findings), is_made=False)
    return document._replace(text=_text(integrated.document), findings=integrated.findings)


def _generated(
    platform: Platform, generator: Generator, integrated: Integrated | InputRefused, name: str
) -> tuple[GeneratedDocument, ...]:
    view = generator.view or generator.name
    try:
        if isinstance(integrated, InputRefused):
            raise integrated
        files = generator.generate(integrated.document, f"{name}.{platform.name}.json", DEFAULT_LIMITS, Options())
    except InputRefused as refused:
        return (GeneratedDocument(view, view, "", "", "", tuple(refused.findings), is_made=False),)
    return tuple(
        GeneratedDocument(
            f"{view}.{file.name.replace('/', '.')}", view, file.name, generator.media_type, _text(file.data)
        )
        for file in files
        if _SHOWN_ELSEWHERE.isdisjoint(file.name.split("/"))
    )


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")
