"""package.xml, format 3 (REP 149)."""

from collections.abc import Iterable

from sigcat.function.document.text import Text, composed
from sigcat.function.document.text_filters import xml_text
from sigcat.integration.ros2.model import Package


def rights(package: Package) -> Text:
    """Copyright and license of the files of a package, in one line."""
    return composed("Copyright ", package.maintainer, ". License: ", package.license, ".")


def package_xml(package: Package, name: str, depends: Iterable[tuple[str, str]], build_type: str) -> str:
    """The description of a package of this name. `depends` are tags and packages: `("exec_depend", "launch_ros")`."""
    dependencies = "".join(f"  <{tag}>{xml_text(other)}</{tag}>\n" for tag, other in depends)
    return f"""<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{xml_text(name)}</name>
  <version>{xml_text(package.version)}</version>
  <description>{xml_text(package.description)}</description>
  <maintainer email="{xml_text(package.email)}">{xml_text(package.maintainer)}</maintainer>
  <license>{xml_text(package.license)}</license>

{dependencies}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""
