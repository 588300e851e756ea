"""CMake files of the applications."""

from collections.abc import Iterable
from textwrap import indent

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, ExecutablePlan
from sigcat.function.document.text_filters import cmake_argument, comment


def root_cmake(application: ApplicationPlan, *, bench: bool) -> str:
    """CMakeLists.txt of all."""
    return project_cmake(application.namespace[-1], application.components, application.executables, bench=bench)


def project_cmake(
    name: str, components: Iterable[ComponentPlan], executables: Iterable[ExecutablePlan], *, bench: bool
) -> str:
    """CMakeLists.txt of some of it. Without `bench` it does not know of any, whatever else is in its folder."""
    settings = "".join(
        f'set({component.core.code_setting} "" CACHE PATH "Folder of the code of {cmake_argument(component.core.function)}")\n'
        for component in components
    )
    folders = "".join(f"add_subdirectory({executable.name})\n" for executable in executables)
    return f"""cmake_minimum_required(VERSION 3.16)
project({name} LANGUAGES C CXX)

set(CMAKE_C_STANDARD 99)
set(CMAKE_CXX_STANDARD 17 CACHE STRING "14 or later")
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

{settings}
# The platform: packages, and targets that bring its headers and libraries. What its generator makes of arxml/ is one of them.
set(PLATFORM_PACKAGES "" CACHE STRING "Packages of the vendor, for find_package")
set(PLATFORM_TARGETS "" CACHE STRING "Targets of the vendor, and of what is generated from arxml/")

find_package(Threads REQUIRED)
{_PLATFORM_OR_BENCH if bench else _PLATFORM}
add_library(application STATIC application/call_thread.cpp application/clock.cpp application/watch.cpp)
target_include_directories(application PUBLIC "${{CMAKE_CURRENT_SOURCE_DIR}}")
target_link_libraries(application PUBLIC ${{PLATFORM_TARGETS}} Threads::Threads)

{_CLOCK_OR_PLAYER if bench else _CLOCK}{folders}"""


_PLATFORM = """foreach(package IN LISTS PLATFORM_PACKAGES)
  find_package(${package} REQUIRED)
endforeach()
"""
_CLOCK = """target_sources(application PRIVATE application/make_clock.cpp)
"""
_PLATFORM_OR_BENCH = f"""include(CMakeDependentOption)
cmake_dependent_option(BENCH "Use the bench runtime instead of a vendor's platform" ON "NOT PLATFORM_TARGETS" OFF)
if(BENCH)
  add_subdirectory(bench)
  add_subdirectory(generated)
  set(PLATFORM_TARGETS generated_services)
else()
{indent(_PLATFORM, "  ")}endif()
"""
_CLOCK_OR_PLAYER = f"""if(BENCH)
  add_subdirectory(player)
else()
{indent(_CLOCK, "  ")}endif()
"""


def executable_cmake(executable: ExecutablePlan) -> str:
    """CMakeLists.txt of an executable."""
    cores = "".join(_core(component) for component in executable.components)
    sources = "".join(f"\n  {component.stem}_adapter.cpp" for component in executable.components)
    libraries = " ".join(f"{component.stem}_core" for component in executable.components)
    return f"""{cores}add_executable({executable.name}
  main.cpp{sources}
)
target_link_libraries({executable.name} PRIVATE application {libraries})
"""


def _core(component: ComponentPlan) -> str:
    code = component.core.code
    setting = component.core.code_setting
    sources = "".join(f'\n  "${{{setting}}}/{cmake_argument(source)}"' for source in code.sources)
    folders = "".join(f' "${{{setting}}}/{cmake_argument(folder)}"' for folder in code.include_folders)
    macros = "".join(f' "{cmake_argument(each)}"' for each in code.definitions)
    defined = f"target_compile_definitions({component.stem}_core PUBLIC{macros})\n" if macros else ""
    return f"""# The core of {comment(component.core.function)}, with its code.
add_library({component.stem}_core STATIC
  "${{PROJECT_SOURCE_DIR}}/core/{cmake_argument(component.core.source_file)}"{sources}
)
target_include_directories({component.stem}_core PUBLIC "${{PROJECT_SOURCE_DIR}}" "${{{setting}}}"{folders})
{defined}target_compile_options({component.stem}_core PRIVATE -ffp-contract=off)
# Each source of the function has names and macros of its own, also where others are joined for a faster build.
set_target_properties({component.stem}_core PROPERTIES UNITY_BUILD OFF)

"""
