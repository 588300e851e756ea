"""An editor that speaks the Language Server Protocol with a server over its standard input and output."""

import json
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

Json = Any


class Editor:
    """A client: it sends requests, and keeps the diagnostics that the server publishes in between."""

    def __init__(self, process: "subprocess.Popen[bytes]", folder: Path) -> None:
        self._process = process
        self._number = 0
        self._version = 0
        self.folder = folder
        self.texts: dict[Path, str] = {}
        self.diagnostics: dict[str, list[Json]] = {}
        self.messages: list[str] = []

    def start(self) -> Json:
        """Introduce the editor; the capabilities of the server."""
        found = self.ask("initialize", {"processId": None, "rootUri": self.folder.as_uri(), "capabilities": {}})
        self.tell("initialized", {})
        return found["capabilities"]

    def open(self, path: Path, text: str | None = None) -> list[Json]:
        """Open a file, with another text than that on the disk if one is given; its diagnostics."""
        self.texts[path] = path.read_text(encoding="utf-8") if text is None else text
        item = {"uri": path.as_uri(), "languageId": "yaml", "version": self._next(), "text": self.texts[path]}
        self.tell("textDocument/didOpen", {"textDocument": item})
        return self._published(path)

    def change(self, path: Path, text: str) -> list[Json]:
        """Replace the text of an open file, as one key press does; its diagnostics."""
        self.texts[path] = text
        document = {"uri": path.as_uri(), "version": self._next()}
        self.tell("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": text}]})
        return self._published(path)

    def edit(self, path: Path, changes: list[Json]) -> list[Json]:
        """Change parts of an open file, each in the text after those before; its diagnostics."""
        document = {"uri": path.as_uri(), "version": self._next()}
        self.tell("textDocument/didChange", {"textDocument": document, "contentChanges": changes})
        return self._published(path)

    def close(self, path: Path) -> None:
        """Close a file, with what was not saved."""
        del self.texts[path]
        self.tell("textDocument/didClose", {"textDocument": {"uri": path.as_uri()}})

    def at(self, path: Path, text: str, offset: int = 0) -> Json:
        """The place of a text in an open file."""
        index = self.texts[path].index(text) + offset
        before = self.texts[path][:index]
        position = {"line": before.count("\n"), "character": len(before) - (before.rfind("\n") + 1)}
        return {"textDocument": {"uri": path.as_uri()}, "position": position}

    def ask(self, method: str, params: Mapping[str, Json]) -> Json:
        """Send a request; its result. Raises ValueError with the message of the server."""
        self._number += 1
        self._send({"id": self._number, "method": method, "params": params})
        while True:
            message = self._next_message()
            if message.get("id") == self._number and "method" not in message:
                if "error" in message:
                    raise ValueError(message["error"]["message"])
                return message.get("result")

    def tell(self, method: str, params: Mapping[str, Json]) -> None:
        """Send a notification."""
        self._send({"method": method, "params": params})

    def stop(self) -> int:
        """End the server; its exit status."""
        self.ask("shutdown", {})
        self.tell("exit", {})
        return self._process.wait(60)

    def _next(self) -> int:
        self._version += 1
        return self._version

    def _published(self, path: Path) -> list[Json]:
        """Diagnostics of the version that was sent last."""
        published = "textDocument/publishDiagnostics", path.as_uri(), self._version
        while True:
            message = self._next_message()
            params = message.get("params") or {}
            if (message.get("method"), params.get("uri"), params.get("version")) == published:
                return self.diagnostics[path.as_uri()]

    def _next_message(self) -> Json:
        message = self._receive()
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
        elif message.get("method") == "window/showMessage":
            self.messages.append(message["params"]["message"])
        return message

    def _send(self, message: Mapping[str, Json]) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        assert self._process.stdin is not None
        self._process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        self._process.stdin.flush()

    def _receive(self) -> Json:
        output = self._process.stdout
        assert output is not None
        length = 0
        while (line := output.readline()) not in (b"\r\n", b""):
            name, _, value = line.partition(b":")
            length = int(value) if name.lower() == b"content-length" else length
        if not length:
            raise EOFError("the language server has ended")
        return json.loads(output.read(length))


@contextmanager
def editor(folder: Path, *options: str) -> Iterator[Editor]:
    """An editor with a server for a folder."""
    command = [sys.executable, "-m", "sigcat.cli", "lsp", "--stdio", *options]
    with subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        client = Editor(process, folder)
        client.start()
        yield client
        try:
            client.stop()
        finally:
            process.kill()
