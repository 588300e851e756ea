"""CMakeLists.txt of the package."""

from collections.abc import Sequence

from sigcat.adapter.ros2.cpp.names import bridge_source
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import cmake_argument, cmake_word
from sigcat.names import snake_case


def cmake(workspace: WorkspacePlan, support: Sequence[str]) -> str:
    """CMakeLists.txt. `support` are sources that all nodes share."""
    sources = "".join(f"\n  src/{name}" for name in support)
    others = [
        each
        for each in workspace.message_packages
        if each not in ("builtin_interfaces", "diagnostic_msgs", "rcl_interfaces")
    ]
    parts = [_HEAD.format(
        name=workspace.name, interfaces=workspace.interfaces, sources=sources,
        found="".join(f"find_package({each} REQUIRED)\n" for each in others),
        targets="".join(f"  ${{{each}_TARGETS}}\n" for each in others),
    )]  # fmt: skip
    parts += [_node(node, workspace) for node in workspace.nodes]
    return "\n".join([*parts, _TAIL.format(exported=_exported(workspace), tests=_tests(workspace, support))])


_HEAD = """cmake_minimum_required(VERSION 3.16)
project({name} LANGUAGES C CXX)

if(NOT CMAKE_C_STANDARD)
  set(CMAKE_C_STANDARD 99)
endif()
if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()
set(CMAKE_CXX_STANDARD_REQUIRED ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_package(ament_cmake REQUIRED)
find_package(builtin_interfaces REQUIRED)
find_package(diagnostic_msgs REQUIRED)
find_package({interfaces} REQUIRED)
{found}find_package(rcl_interfaces REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
find_package(rclcpp_lifecycle REQUIRED)
find_package(Threads REQUIRED)

# What all nodes share: clocks, topics that are counted, diagnostics, storage.
add_library({name}_support STATIC{sources}
)
set_target_properties({name}_support PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories({name}_support PUBLIC
  "$<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>"
  "$<INSTALL_INTERFACE:include/${{PROJECT_NAME}}>")
target_compile_options({name}_support PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
target_link_libraries({name}_support PUBLIC
  ${{builtin_interfaces_TARGETS}}
  ${{diagnostic_msgs_TARGETS}}
  ${{{interfaces}_TARGETS}}
{targets}  ${{rcl_interfaces_TARGETS}}
  rclcpp::rclcpp
  rclcpp_components::component
  rclcpp_lifecycle::rclcpp_lifecycle
  Threads::Threads
)
"""


def _exported(workspace: WorkspacePlan) -> str:
    """Packages whose headers those of the nodes include."""
    own = {"builtin_interfaces", "diagnostic_msgs", "rcl_interfaces", "rclcpp", "rclcpp_components", "rclcpp_lifecycle"}
    return "\n  ".join(sorted({*own, "Threads", workspace.interfaces, *workspace.message_packages}))


def _node(node: NodePlan, workspace: WorkspacePlan) -> str:
    folder = cmake_argument(snake_case(node.core.function))
    core = [f"core/{name}" for name in (node.core.source_file, bridge_source(node))]
    code, setting = node.core.code, node.core.code_setting
    sources = "".join(f'\n  "${{{setting}}}/{cmake_argument(source)}"' for source in code.sources)
    own = "".join(f"\n  {name}" for name in core)
    folders = "".join(
        f'\n  "$<BUILD_INTERFACE:${{{setting}}}/{cmake_argument(each)}>"' for each in code.include_folders
    )
    macros = "".join(f' "{cmake_argument(each)}"' for each in code.definitions)
    defined = f"target_compile_definitions({node.core_library} PUBLIC{macros})\n" if macros else ""
    return _NODE.format(
        function=cmake_argument(node.core.function), setting=setting, package=cmake_argument(workspace.name), name=node.name, stem=node.stem, core=node.core_library, component=node.component_library,
        type=cmake_argument(node.type), executable=node.executable, sources=" ".join(map(cmake_word, code.sources)), files=own + sources, folder=folder,
        folders=folders, defined=defined,
    )  # fmt: skip


_NODE = """# {function}: the core with the code of the function, the node, and an executable of its own.
set({setting} "${{CMAKE_CURRENT_SOURCE_DIR}}/code/{folder}"
  CACHE PATH "Folder of the code of {function}")
foreach(source {sources})
  if(NOT EXISTS "${{{setting}}}/${{source}}")
    message(FATAL_ERROR
      "The code of {function} is not found: ${{{setting}}}/${{source}}. "
      "Put it into {package}/code/{folder}, or set {setting} to its folder.")
  endif()
endforeach()
add_library({core} SHARED{files}
)
target_include_directories({core} PUBLIC
  "$<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/core>"
  "$<BUILD_INTERFACE:${{{setting}}}>"{folders})
{defined}# Results are those of every other platform: no multiplication is joined with an addition.
target_compile_options({core} PRIVATE -ffp-contract=off)
# Each source has names and macros of its own, also where others are joined for a faster build.
set_target_properties({core} PROPERTIES UNITY_BUILD OFF)
# What the code lacks is told when it is linked.
target_link_options({core} PRIVATE "LINKER:-z,defs")
target_link_libraries({core} PRIVATE m)

add_library({component} SHARED src/{stem}.cpp)
target_compile_options({component} PRIVATE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
target_link_libraries({component} PUBLIC {package}_support PRIVATE {core})
rclcpp_components_register_nodes({component} "{package}::{type}")

add_executable({executable} src/{name}_main.cpp)
target_link_libraries({executable} PRIVATE {component})

install(TARGETS {core} {component} EXPORT export_${{PROJECT_NAME}}
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
install(TARGETS {executable} RUNTIME DESTINATION lib/${{PROJECT_NAME}})
"""


def _tests(workspace: WorkspacePlan, support: Sequence[str]) -> str:
    nodes = "".join(
        f"""
  ament_add_ros_isolated_gtest(test_{node.stem} test/test_{node.stem}.cpp)
  target_link_libraries(test_{node.stem} {node.component_library} ${{lifecycle_msgs_TARGETS}})"""
        for node in workspace.nodes
    )
    return nodes + (_STORAGE_TEST if "storage.cpp" in support else "")


_STORAGE_TEST = """
  ament_add_gtest(test_storage test/test_storage.cpp)
  target_link_libraries(test_storage ${PROJECT_NAME}_support)"""


_TAIL = """# For packages that link a node or derive from its class.
install(TARGETS ${{PROJECT_NAME}}_support EXPORT export_${{PROJECT_NAME}}
  ARCHIVE DESTINATION lib
)
install(DIRECTORY include/ DESTINATION include/${{PROJECT_NAME}})
ament_export_targets(export_${{PROJECT_NAME}} HAS_LIBRARY_TARGET)
ament_export_dependencies(
  {exported}
)

install(DIRECTORY launch config DESTINATION share/${{PROJECT_NAME}})

if(BUILD_TESTING)
  # Cores are C of every platform, with rules of their own, and code is that of the functions.
  file(GLOB_RECURSE not_linted CONFIGURE_DEPENDS core/?* code/?*)
  set(AMENT_LINT_AUTO_FILE_EXCLUDE ${{not_linted}})
  find_package(ament_lint_auto REQUIRED)
  ament_lint_auto_find_test_dependencies()
  find_package(ament_cmake_gtest REQUIRED)
  find_package(ament_cmake_ros REQUIRED)
  find_package(launch_testing_ament_cmake REQUIRED)
  find_package(lifecycle_msgs REQUIRED){tests}
  add_launch_test(test/test_launch.py
    RUNNER "${{ament_cmake_ros_DIR}}/run_test_isolated.py")
endif()

ament_package()
"""
