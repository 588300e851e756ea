"""Headers in C++ of a folder of messages and services, by rosidl: run by the Python of ROS 2, with a package, its folder, and where to write."""

import json
import sys
from pathlib import Path

from ament_index_python import get_package_share_directory  # type: ignore[import-not-found]
from rosidl_adapter.msg import convert_msg_to_idl  # type: ignore[import-not-found]
from rosidl_adapter.srv import convert_srv_to_idl  # type: ignore[import-not-found]
from rosidl_generator_cpp import generate_cpp  # type: ignore[import-not-found]


def main(package: str, source: Path, output: Path) -> None:
    """Write the headers."""
    idl = [
        f"{output / 'idl'}:{kind}/{convert(source, package, file.relative_to(source), output / 'idl' / kind).name}"
        for kind, convert in (("msg", convert_msg_to_idl), ("srv", convert_srv_to_idl))
        for file in sorted((source / kind).glob(f"*.{kind}"))
    ]
    arguments = output / "arguments.json"
    arguments.write_text(
        json.dumps({
            "package_name": package, "output_dir": str(output / package), "idl_tuples": idl,
            "template_dir": f"{get_package_share_directory('rosidl_generator_cpp')}/resource",
            "ros_interface_dependencies": [], "target_dependencies": [], "type_description_tuples": [],
        })
    )  # fmt: skip
    generate_cpp(str(arguments))
    macro = f"ROSIDL_GENERATOR_CPP_PUBLIC_{package}"
    (output / package / "msg/rosidl_generator_cpp__visibility_control.hpp").write_text(f"#define {macro}\n")


main(sys.argv[1], Path(sys.argv[2]).absolute(), Path(sys.argv[3]).absolute())
