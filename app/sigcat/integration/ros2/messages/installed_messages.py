"""Definitions of the messages that a deployment names, from the files of this machine."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sigcat.integration.ros2.messages.message_definitions import named_types, short_name
from sigcat.integration.ros2.settings import Ros2Settings

_MOST_BYTES = 1_000_000
"""Larger files are ignored."""


def with_installed_messages(settings: Ros2Settings, folder: Path, environment: Mapping[str, str]) -> Ros2Settings:
    """Settings with the definition of every message that they name, and of those within, as far as files have them.

    Folders are relative to `folder`. Definitions in the settings go first.
    """
    prefixes = [Path(each) / "share" for each in environment.get("AMENT_PREFIX_PATH", "").split(":") if each]
    folders = [*(folder / each for each in settings.message_folders), *prefixes]
    known = {short_name(name): text for name, text in settings.message_definitions.items()}
    wanted = [short_name(message.type) for message in settings.messages.values()]
    for name in wanted:  # grows by the messages within
        if name not in known and (text := _text(name, folders)) is not None:
            known[name] = text
        wanted += [each for each in named_types(known.get(name, ""), name) if each not in wanted]
    return settings.model_copy(update={"message_definitions": known})


def _text(name: str, folders: Sequence[Path]) -> str | None:
    package, _, message = name.partition("/")
    for folder in folders:
        for path in _places(folder, f"{package}/msg/{message}.msg"):
            if path.is_file() and path.stat().st_size <= _MOST_BYTES:
                return path.read_text(encoding="utf-8", errors="replace")
    return None


def _places(folder: Path, path: str) -> Iterator[Path]:
    """Yield possible places of the file: packages are in the folder, or below it, as in a workspace."""
    yield folder / path
    yield from sorted(folder.glob(f"*/{path}"))
    yield from sorted(folder.glob(f"*/*/{path}"))
