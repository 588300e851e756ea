"""The language server: requests of an editor over standard input and output."""

import asyncio
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path
from pygls.workspace import PositionCodec, ServerTextPosition, TextDocument

from sigcat import __version__
from sigcat.errors import SigcatError, UsageError
from sigcat.findings import Finding
from sigcat.lsp.completion import Kind, Proposal, proposals_at
from sigcat.lsp.definition import definition_places, reference_places
from sigcat.lsp.hover import hover_text
from sigcat.lsp.places import Place, Word, word_at
from sigcat.lsp.quick_fixes import QuickFix, every_fix, quick_fixes
from sigcat.lsp.rename import renamed
from sigcat.lsp.warm_project import FindProject, WarmProject
from sigcat.names import last_name
from sigcat.open_files import read_bytes
from sigcat.real_path import near_path
from sigcat.rules.linting.options import LintResult

Result = TypeVar("Result")
_SEVERITIES = {
    "error": types.DiagnosticSeverity.Error,
    "warning": types.DiagnosticSeverity.Warning,
    "info": types.DiagnosticSeverity.Information,
}
_KINDS: dict[Kind, types.CompletionItemKind] = {
    "branch": types.CompletionItemKind.Module,
    "signal": types.CompletionItemKind.Field,
    "attribute": types.CompletionItemKind.Property,
    "unit": types.CompletionItemKind.Unit,
    "datatype": types.CompletionItemKind.TypeParameter,
    "value": types.CompletionItemKind.EnumMember,
    "rule": types.CompletionItemKind.Constant,
    "variable": types.CompletionItemKind.Variable,
}
_FIX_ALL = f"{types.CodeActionKind.SourceFixAll.value}.sigcat"


class SigcatServer(LanguageServer):
    """A server for one folder. One thread does all work, so that a project needs no locks."""

    def __init__(self, find_project: FindProject) -> None:
        super().__init__("sigcat", __version__)
        self._find_project = find_project
        self.project = WarmProject(Path.cwd(), find_project)
        self.results: dict[str, tuple[int | None, LintResult]] = {}
        """The version and the result of the last lint of each document."""
        self._running: set[str] = set()
        self._worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="sigcat")

    def use_folder(self, folder: Path) -> None:
        """Work in a folder, as a command that is started there does."""
        os.chdir(folder)
        self.project = WarmProject(folder, self._find_project)

    async def work(self, function: Callable[..., Result], *arguments: Any) -> Result:
        """Return what a function returns, with the texts of the editor in place of files."""
        return await self._in_worker(self.project.with_texts, function, arguments)

    async def look_up(self, function: Callable[..., Result], *arguments: Any) -> Result:
        """Return what a function returns, with the texts of the editor as they could be read last."""
        return await self._in_worker(self.project.with_sound_texts, function, arguments)

    async def _in_worker(
        self, with_texts: Callable[[Callable[[], Result]], Result], function: Callable[..., Result], arguments: Any
    ) -> Result:
        loop = asyncio.get_running_loop()
        return await loop.run_in_executor(self._worker, lambda: with_texts(lambda: function(*arguments)))

    def take(self, document: TextDocument) -> None:
        """Take the text of a document."""
        self.project.open(path_of(document.uri), document.source.encode("utf-8", "surrogatepass"))

    async def check(self, uri: str) -> None:
        """Lint a document and publish what is found. Changes during a lint are linted after it, all at once."""
        if uri in self._running:
            return
        self._running.add(uri)
        try:
            while uri in self.workspace.text_documents:
                document = self.workspace.text_documents[uri]
                version = document.version
                result = await self.work(self._lint, path_of(uri))
                if uri not in self.workspace.text_documents or document.version == version:
                    break
        finally:
            self._running.discard(uri)
        if uri in self.workspace.text_documents:
            self.results[uri] = (version, result)
            found = [finding for finding in result.findings if finding.file == str(path_of(uri))]
            diagnostics = [_diagnostic(finding, document) for finding in found]
            self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, diagnostics, version))

    async def check_all(self) -> None:
        """Lint every open document: files that they depend on have changed."""
        for uri in tuple(self.workspace.text_documents):
            await self.check(uri)

    def _lint(self, path: Path) -> LintResult:
        try:
            return self.project.lint(path)
        except SigcatError as error:  # nothing could be linted
            return LintResult((Finding("", "error", str(error), str(path), 1),), (str(path),))

    def place(self, uri: str, position: types.Position) -> tuple[Path, list[str], int, int]:
        """Return the file, the lines, the line and the column of a position; an empty line for a file that cannot be read."""
        document = self.workspace.get_text_document(uri)
        try:
            lines = document.source.split("\n")
        except (OSError, UnicodeError):  # it is not open, and not on the disk
            return path_of(uri), [""], 0, 0
        at = document.position_codec.position_from_client_units(lines, position)
        return path_of(uri), lines, min(at.line, len(lines) - 1), at.character

    def location(self, place: Place) -> types.Location:
        """Return a place as the editor counts: in code units of its encoding."""
        file = place.file.absolute()
        uri = from_fs_path(str(file)) or ""
        return types.Location(uri, self.range(uri, file, place))

    def range(self, uri: str, file: Path, place: Place) -> types.Range:
        """Return the range of a place. A file that is not open is read."""
        document = self.workspace.text_documents.get(uri)
        text = document.source if document is not None else _text_of(file)
        return _range(text.split("\n"), self.workspace.position_codec, place)


def path_of(uri: str) -> Path:
    """Return the path of a document, as a user in the folder of the project names it."""
    return near_path(Path(to_fs_path(uri) or uri))


def _text_of(file: Path) -> str:
    try:
        return read_bytes(file).decode("utf-8-sig", "replace")
    except OSError:
        return ""


def _range(lines: list[str], codec: PositionCodec, place: Place) -> types.Range:
    ends = (ServerTextPosition(min(place.line, len(lines) - 1), column) for column in (place.start, place.end))
    start, end = (codec.position_to_client_units(lines, each) for each in ends)
    return types.Range(start, end)


def _diagnostic(finding: Finding, document: TextDocument) -> types.Diagnostic:
    lines = document.source.split("\n")
    line, column = max(finding.line - 1, 0), max(finding.column - 1, 0)
    text = lines[line] if line < len(lines) else ""
    end = word_at(text, column).end if column else len(text.rstrip())
    advice = f" {finding.fix}" if finding.fix else ""
    place = Place(Path(finding.file), line, column, max(end, min(column + 1, len(text))))
    return types.Diagnostic(
        _range(lines, document.position_codec, place),
        f"{finding.message}{advice}",
        severity=_SEVERITIES[finding.severity],
        code=finding.rule or None,
        source="sigcat",
    )


def _item(proposal: Proposal, range_: types.Range) -> types.CompletionItem:
    kind = _KINDS[proposal.kind]
    edit = types.TextEdit(range_, proposal.text)
    is_path = proposal.kind in ("branch", "signal")
    label = last_name(proposal.label) if is_path else proposal.label
    detail = f"{proposal.label} · {proposal.detail}" if is_path else proposal.detail
    return types.CompletionItem(label, kind=kind, detail=detail, filter_text=proposal.text, text_edit=edit)


def _action(fix: QuickFix, document: TextDocument, kind: str, given: Iterable[types.Diagnostic]) -> types.CodeAction:
    start, end = (_position_at(document, offset) for offset in (fix.start, fix.end))
    edit = types.WorkspaceEdit(changes={document.uri: [types.TextEdit(types.Range(start, end), fix.text)]})
    settled = {finding.rule for finding in fix.findings}
    about = [each for each in given if each.code in settled]
    return types.CodeAction(fix.title, kind=kind, diagnostics=about, edit=edit, is_preferred=fix.is_safe)


def _position_at(document: TextDocument, offset: int) -> types.Position:
    before = document.source[:offset].split("\n")
    lines = document.source.split("\n")
    return document.position_codec.position_to_client_units(lines, ServerTextPosition(len(before) - 1, len(before[-1])))


def make_server(find_project: FindProject) -> SigcatServer:
    """Return a server with all that it answers."""
    server = SigcatServer(find_project)
    _answer_documents(server)
    _answer_look_ups(server)
    _answer_edits(server)
    return server


def _answer_documents(server: SigcatServer) -> None:
    @server.feature(types.INITIALIZE)
    def initialize(params: types.InitializeParams) -> None:
        folders = params.workspace_folders or ()
        uri = folders[0].uri if folders else params.root_uri
        folder = to_fs_path(uri) if uri else None
        if folder and Path(folder).is_dir():
            server.use_folder(Path(folder))

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    async def opened(params: types.DidOpenTextDocumentParams) -> None:
        server.take(server.workspace.get_text_document(params.text_document.uri))
        await server.check(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    async def changed(params: types.DidChangeTextDocumentParams) -> None:
        server.take(server.workspace.get_text_document(params.text_document.uri))
        await server.check(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    async def saved(_: types.DidSaveTextDocumentParams) -> None:
        await server.check_all()

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    async def files_changed(_: types.DidChangeWatchedFilesParams) -> None:
        await server.check_all()

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: types.DidCloseTextDocumentParams) -> None:
        uri = params.text_document.uri
        server.project.close(path_of(uri))
        server.results.pop(uri, None)
        server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))


def _answer_look_ups(server: SigcatServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(params: types.HoverParams) -> types.Hover | None:
        path, lines, line, column = server.place(params.text_document.uri, params.position)
        word = word_at(lines[line], column)
        text = await server.look_up(_or_nothing, "", hover_text, server.project, path, lines, line, word)
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, text)) if text else None

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: types.DefinitionParams) -> list[types.Location]:
        return await server.look_up(_locations, server, params, definition_places)

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    async def references(params: types.ReferenceParams) -> list[types.Location]:
        return await server.look_up(_locations, server, params, reference_places)

    triggers = types.CompletionOptions(trigger_characters=[".", ":", " ", "[", '"'])

    @server.feature(types.TEXT_DOCUMENT_COMPLETION, triggers)
    async def completion(params: types.CompletionParams) -> types.CompletionList:
        path, lines, line, column = server.place(params.text_document.uri, params.position)
        none: list[Proposal] = []
        found = await server.look_up(_or_nothing, none, proposals_at, server.project, path, lines, line, column)
        codec = server.workspace.position_codec
        items = [_item(each, _range(lines, codec, Place(path, line, each.start, column))) for each in found]
        return types.CompletionList(is_incomplete=True, items=items)


def _locations(
    server: SigcatServer,
    params: types.DefinitionParams | types.ReferenceParams,
    find: Callable[[WarmProject, Path, list[str], int, Word], list[Place]],
) -> list[types.Location]:
    path, lines, line, column = server.place(params.text_document.uri, params.position)
    none: list[Place] = []
    found = _or_nothing(none, find, server.project, path, lines, line, word_at(lines[line], column))
    return [server.location(place) for place in found]


def _or_nothing(nothing: Result, function: Callable[..., Result], *arguments: Any) -> Result:
    """Return what a function returns; nothing where the project cannot be read, which a diagnostic says."""
    try:
        return function(*arguments)
    except SigcatError:
        return nothing


def _answer_edits(server: SigcatServer) -> None:
    kinds = types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix, _FIX_ALL])

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, kinds)
    async def code_action(params: types.CodeActionParams) -> list[types.CodeAction]:
        document = server.workspace.get_text_document(params.text_document.uri)
        version, result = server.results.get(document.uri, (None, None))
        if result is None or version != document.version:
            return []
        return await server.work(_actions, document, result, params)

    @server.feature(types.TEXT_DOCUMENT_RENAME)
    async def rename(params: types.RenameParams) -> types.WorkspaceEdit:
        path, lines, line, column = server.place(params.text_document.uri, params.position)
        word = word_at(lines[line], column)
        return await server.work(_renaming, server, path, line, word, params.new_name)


def _actions(document: TextDocument, result: LintResult, params: types.CodeActionParams) -> list[types.CodeAction]:
    path, first, last = path_of(document.uri), params.range.start.line + 1, params.range.end.line + 1
    chosen = [each for each in result.findings if each.file == str(path) and first <= each.line <= last]
    given = params.context.diagnostics
    text = document.source
    fixes = [
        _action(fix, document, types.CodeActionKind.QuickFix, given) for fix in quick_fixes(result, path, text, chosen)
    ]
    return [*fixes, *(_action(fix, document, _FIX_ALL, given) for fix in every_fix(result, path, text))]


def _renaming(server: SigcatServer, path: Path, line: int, word: Word, name: str) -> types.WorkspaceEdit:
    from pygls.exceptions import JsonRpcInvalidParams

    changes: dict[str, list[types.TextEdit]] = {}
    try:
        for change in renamed(server.project, path, line, word, name):
            location = server.location(change.place)
            changes.setdefault(location.uri, []).append(types.TextEdit(location.range, change.text))
    except (UsageError, SigcatError) as error:
        raise JsonRpcInvalidParams(str(error)) from None
    return types.WorkspaceEdit(changes=changes)
