"""Hashes of messages, by rosidl: run by the Python of ROS 2 with folders of packages; JSON on standard output."""

import json
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path

from rosidl_adapter.msg import convert_msg_to_idl  # type: ignore[import-not-found]
from rosidl_generator_type_description import generate_type_hash  # type: ignore[import-not-found]


def hashes(package: Path, files: Iterable[Path], output: Path) -> dict[str, str]:
    """Return the hashes of messages of a package by name."""
    names = [
        convert_msg_to_idl(package, package.name, file.relative_to(package), output / "msg").name for file in files
    ]
    arguments = output / "arguments.json"
    arguments.write_text(
        json.dumps({
            "package_name": package.name, "output_dir": str(output), "idl_tuples": [f"{output}:msg/{name}" for name in names],
            "include_paths": [],
        })
    )  # fmt: skip
    generate_type_hash(str(arguments))
    made = (json.loads(file.read_text())["type_hashes"] for file in output.rglob("*.json") if file != arguments)
    return {each["type_name"].rpartition("/")[2]: each["hash_string"] for types in made for each in types}


def main() -> None:
    """Write the hashes of all packages. A message that several packages have in the same words is read once."""
    known: dict[tuple[str, bytes], str] = {}
    answers = []
    for package in (Path(name).absolute() for name in sys.argv[1:]):
        messages = {file: (file.stem, file.read_bytes()) for file in sorted((package / "msg").glob("*.msg"))}
        with tempfile.TemporaryDirectory() as output:
            found = hashes(package, [file for file, key in messages.items() if key not in known], Path(output))
        known |= {key: found[key[0]] for key in messages.values() if key not in known}
        answers.append({key[0]: known[key] for key in messages.values()})
    json.dump(answers, sys.stdout)


main()
