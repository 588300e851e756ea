"""The documentation of sigcat, chapter by chapter."""

from fastapi import APIRouter, Request
from fastapi.responses import FileResponse, Response

from sigcat.api.requests.thread_turns import InThread
from sigcat.data import DOCUMENTATION
from sigcat.errors import NotFound
from sigcat.names import nearest
from sigcat.web.documentation import INDEX, chapter_at, contents, files
from sigcat.web.rendering import page
from sigcat.web.visits import mounted_below

router = APIRouter(route_class=InThread)


@router.get("/docs/{chapter:path}")
def show_chapter(request: Request, chapter: str) -> Response:
    """A chapter with the table of contents; without a name, the index. Other files of the documentation as they are."""
    name = chapter or INDEX
    if name not in files():
        raise NotFound(f"Unknown chapter {name[:100]!r}.", nearest(name[:100], files()))
    if not name.endswith(".md"):
        return FileResponse(DOCUMENTATION / name)
    shown = chapter_at(name, mounted_below(request).rstrip("/"))
    return page(request, "chapter.html", name=name, chapter=shown, contents=contents())
