"""Names of catalogues on pages, where several may have one title."""

from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import choice_of


def title_in(library: Library, hosted: Hosted) -> str:
    """Its title, with its id where another catalogue of the library has the same title."""
    titles = {each.source.id: each.source.title for each in library}
    own = titles.get(choice_of(hosted.source.id).base)
    is_shared = list(titles.values()).count(own or "") > 1
    return f"{hosted.source.title} ({hosted.source.id})" if is_shared else hosted.source.title
