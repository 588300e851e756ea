"""From Integration JSON to a workspace of ROS 2 packages."""

from sigcat import codes
from sigcat.adapter.files import GeneratedFile, within
from sigcat.adapter.placed_findings import placed_in
from sigcat.adapter.ros2.bringup.bringup_files import bringup_files
from sigcat.adapter.ros2.cpp.cpp_files import cpp_files
from sigcat.adapter.ros2.interfaces.interface_files import interface_files
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.adapter.ros2.planned_workspace import derive
from sigcat.adapter.ros2.python.python_files import python_files
from sigcat.adapter.source_cores import files_of, source_cores
from sigcat.adapter.source_functions import source_functions
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.function.document.text_filters import block_comment
from sigcat.integration.ros2.document import read_integration
from sigcat.integration.ros2.releases import DEFAULT_RELEASE
from sigcat.limits import Limits


@collector_paused()
def generate(data: bytes, name: str, limits: Limits, release: str | None) -> tuple[GeneratedFile, ...]:
    """The packages of a set. The same document gives the same bytes.

    Raises InputRefused if the document cannot be used, or a core cannot be generated.
    """
    model = read_integration(data, name, limits)
    functions = source_functions(model.functions, data, name, limits, codes.NOT_WRITABLE_AS_ROS2, "ros2")
    cores = source_cores(functions)
    with placed_in(data, name, limits):
        workspace = derive(model, cores, release or DEFAULT_RELEASE)
    (interfaces,) = model.interface_packages or ()
    made = (
        *bringup_files(workspace, model),
        *interface_files(interfaces),
        *within(workspace.name, cpp_files(workspace)),
        *python_files(workspace),
        *within(f"{workspace.name}/core", files_of(cores)),
    )
    return tuple(_licensed(file, workspace) for file in made)


def _licensed(file: GeneratedFile, workspace: WorkspacePlan) -> GeneratedFile:
    """A file, with whose it is if it is of a core: on other platforms, what is around it says so."""
    if not file.name.startswith(f"{workspace.name}/core/"):
        return file
    return file._replace(data=f"{block_comment(rights(workspace.package))}\n".encode() + file.data)
