"""CMakeLists.txt: components, their cores and the code of their functions on the test RTE."""

from collections.abc import Iterable

from sigcat.adapter.autosar_classic.code.plan import ClassicPlan, SwcPlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import cmake_argument

_TEMPLATE = "adapter/autosar_classic/test_rte/CMakeLists.txt.j2"


def cmake(plan: ClassicPlan) -> str:
    """The whole file."""
    languages = "C CXX" if any(swc.core.code.is_cpp for swc in plan.swcs) else "C"
    return rendered(_TEMPLATE, name=plan.name, languages=languages, swcs=plan.swcs, sources=_sources, folders=_folders)


def _sources(swc: SwcPlan) -> list[str]:
    """Arguments for the component, its core and the code of its function."""
    code = swc.core.code
    own = f"swc/{swc.name}.{code.ending} core/{swc.core.source_file}"
    return [own, *_within(swc.core.code_setting, code.sources)]


def _folders(swc: SwcPlan) -> list[str]:
    """Arguments for the folders with headers of the code."""
    code, setting = swc.core.code, swc.core.code_setting
    beside = (path.rpartition("/")[0] for path in (*code.sources, *code.headers))
    return [f'"${{{setting}}}"', *_within(setting, filter(None, dict.fromkeys((*beside, *code.include_folders))))]


def _within(setting: str, paths: Iterable[str]) -> list[str]:
    """Arguments for paths in the folder of the code."""
    return [f'"${{{setting}}}/{cmake_argument(path)}"' for path in paths]
