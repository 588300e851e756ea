"""Several paths in one argument, such as TREE+OVERLAY+OVERLAY."""

from pathlib import Path


def split_paths(text: str, sign: str, folder: Path = Path()) -> list[str]:
    """The paths that a sign joins. A path may have the sign in it: the longest one that exists counts."""
    parts = text.split(sign)
    paths = []
    while parts:
        longer = (count for count in range(len(parts), 1, -1) if (folder / sign.join(parts[:count])).exists())
        count = next(longer, 1)
        paths.append(sign.join(parts[:count]))
        parts = parts[count:]
    return paths
