"""package.xml, format 3 (REP 149)."""

import re
from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr

from sigcat.integration.ros2.model import Package

_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot have, however they are written."""


def package_xml(package: Package, name: str, depends: Iterable[tuple[str, str]], build_type: str) -> str:
    """The description of a package of this name. `depends` are tags and packages: `("exec_depend", "launch_ros")`."""
    dependencies = "".join(f"  <{tag}>{escape(other)}</{tag}>\n" for tag, other in depends)
    return f"""<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{name}</name>
  <version>{package.version}</version>
  <description>{_text(package.description)}</description>
  <maintainer email={quoteattr(package.email)}>{_text(package.maintainer)}</maintainer>
  <license>{_text(package.license)}</license>

{dependencies}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""


def _text(text: str) -> str:
    return escape(" ".join(_NOT_IN_XML.sub(" ", text).split()))
