"""package.xml, format 3 (REP 149)."""

from collections.abc import Iterable

from sigcat.adapter.templates import rendered
from sigcat.function.document.text import Text, composed
from sigcat.integration.ros2.model import Package


def rights(package: Package) -> Text:
    """Copyright and license of the files of a package, in one line."""
    return composed("Copyright ", package.maintainer, ". License: ", package.license, ".")


def package_xml(package: Package, name: str, depends: Iterable[tuple[str, str]], build_type: str) -> str:
    """The description of a package of this name. `depends` are tags and packages: `("exec_depend", "launch_ros")`."""
    return rendered("adapter/ros2/package.xml.j2", package=package, name=name, depends=depends, build_type=build_type)
