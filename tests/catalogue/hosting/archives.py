"""Archives of a small release, good ones and bad ones."""

import io
import tarfile
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path

TOP = "vehicle_signal_specification-5.0"
ROOT_FILE = "spec/VehicleSignalSpecification.vspec"
FILES: Mapping[str, str] = {
    ROOT_FILE: "Vehicle:\n  type: branch\n  description: A vehicle.\n#include Cabin/Cabin.vspec Vehicle\n",
    "spec/Cabin/Cabin.vspec": "Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n  description: Its speed.\n",
    "spec/units.yaml": (
        "km/h:\n  definition: Speed.\n  unit: kilometer per hour\n  quantity: velocity\n"
        "  allowed-datatypes: [numeric]\n"
    ),
    "spec/quantities.yaml": "velocity:\n  definition: Distance in time.\n",
    "overlays/extra.vspec": "Vehicle.IsMoving:\n  type: sensor\n  datatype: boolean\n  description: Whether it moves.\n",
    "LICENSE": "Free.\n",
    "docs/index.md": "# Not kept\n",
}


def member(name: str, content: str | bytes = b"", **fields: object) -> tuple[tarfile.TarInfo, bytes]:
    """A member of a tar archive; `fields` are those of TarInfo, such as type and linkname."""
    data = content.encode() if isinstance(content, str) else content
    info = tarfile.TarInfo(name)
    info.size = len(data)
    for field, value in fields.items():
        setattr(info, field, value)
    return info, data


def tar_bytes(
    extra: Iterable[tuple[tarfile.TarInfo, bytes]] = (), files: Mapping[str, str] = FILES, mode: str = "w:gz"
) -> bytes:
    """A release as GitHub packs it, with further members at its end."""
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode=mode) as tar:  # type: ignore[call-overload]
        for info, data in [*(member(f"{TOP}/{name}", text) for name, text in files.items()), *extra]:
            tar.addfile(info, io.BytesIO(data))
    return buffer.getvalue()


def zip_bytes(extra: Mapping[str | zipfile.ZipInfo, bytes] | None = None, files: Mapping[str, str] = FILES) -> bytes:
    """The same as a zip archive."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(f"{TOP}/{name}", text)
        for info, data in (extra or {}).items():
            archive.writestr(info, data)
    return buffer.getvalue()


def saved(folder: Path, data: bytes) -> Path:
    """The bytes as a file."""
    file = folder / "archive"
    file.write_bytes(data)
    return file


def everything_in(folder: Path) -> list[str]:
    """Paths of all files below a folder."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir())
