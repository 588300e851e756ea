"""CMakeLists.txt: components, their cores and the code of their functions on the test RTE."""

from sigcat.adapter.autosar_classic.code.plan import ClassicPlan, SwcPlan
from sigcat.adapter.text_filters import cmake_argument, comment


def cmake(plan: ClassicPlan) -> str:
    """The whole file."""
    languages = "C CXX" if any(swc.core.code.is_cpp for swc in plan.swcs) else "C"
    components = "".join(_component(swc) for swc in plan.swcs)
    sources = " ".join(f"test_rte/Rte_{swc.name}.c" for swc in plan.swcs)
    objects = " ".join(f"$<TARGET_OBJECTS:swc_{swc.name}>" for swc in plan.swcs)
    return f"""# {comment(plan.name)} on the test RTE of sigcat, at a desk. An ECU is built by its integrator's project.
cmake_minimum_required(VERSION 3.16)
project(classic LANGUAGES {languages})
set(CMAKE_C_STANDARD 99)
if(NOT DEFINED CMAKE_C_EXTENSIONS)
  set(CMAKE_C_EXTENSIONS OFF)
endif()
set(CMAKE_CXX_STANDARD 17)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
add_compile_options(-ffp-contract=off)
{components}
add_executable(test_rte
  test_rte/main.c test_rte/os.c test_rte/services.c test_rte/trace.c test_rte/values.c test_rte/rte_tables.c
  {sources}
  {objects})
target_include_directories(test_rte PRIVATE test_rte contract core test_rte/include {_folders(plan)})
target_link_libraries(test_rte PRIVATE m)
"""


def _folders(plan: ClassicPlan) -> str:
    return " ".join(_include(swc) for swc in plan.swcs)


def _include(swc: SwcPlan) -> str:
    code = swc.core.code
    beside = (path.rpartition("/")[0] for path in (*code.sources, *code.headers))
    folders = dict.fromkeys((*beside, *code.include_folders))
    base = f"${{{swc.core.code_setting}}}"
    return " ".join([f'"{base}"', *(f'"{base}/{cmake_argument(folder)}"' for folder in folders if folder)])


def _component(swc: SwcPlan) -> str:
    code = swc.core.code
    base = f"${{{swc.core.code_setting}}}"
    sources = "".join(f'\n  "{base}/{cmake_argument(path)}"' for path in code.sources)
    macros = [f'"{cmake_argument(each)}"' for each in code.definitions]
    defined = f"\ntarget_compile_definitions(swc_{swc.name} PRIVATE {' '.join(macros)})" if macros else ""
    return f"""
set({swc.core.code_setting} "" CACHE PATH "Where the code of {cmake_argument(swc.core.function)} is")
add_library(swc_{swc.name} OBJECT swc/{swc.name}.{code.ending} core/{swc.core.source_file}{sources})
target_include_directories(swc_{swc.name} PRIVATE contract core test_rte/include {_include(swc)}){defined}
"""
