"""CMakeLists.txt: components, their cores and the code of their functions on the test RTE."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.plan import ClassicPlan, SwcPlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import cmake_argument

_TEMPLATE = "adapter/autosar_classic/test_rte/CMakeLists.txt.j2"


class _Component(NamedTuple):
    """A component with the code of its function; `setting` is the variable that names the folder of the code."""

    name: str
    function: str
    setting: str
    sources: Sequence[str]
    folders: Sequence[str]
    definitions: Sequence[str]


def cmake(plan: ClassicPlan) -> str:
    """The whole file."""
    languages = "C CXX" if any(swc.core.code.is_cpp for swc in plan.swcs) else "C"
    return rendered(_TEMPLATE, name=plan.name, languages=languages, components=[_component(swc) for swc in plan.swcs])


def _component(swc: SwcPlan) -> _Component:
    code, setting = swc.core.code, swc.core.code_setting
    beside = (path.rpartition("/")[0] for path in (*code.sources, *code.headers))
    folders = dict.fromkeys((*beside, *code.include_folders))
    return _Component(
        swc.name,
        swc.core.function,
        setting,
        [f"swc/{swc.name}.{code.ending} core/{swc.core.source_file}", *_within(setting, code.sources)],
        [f'"${{{setting}}}"', *_within(setting, filter(None, folders))],
        code.definitions,
    )


def _within(setting: str, paths: Iterable[str]) -> list[str]:
    """Arguments for paths in the folder of the code."""
    return [f'"${{{setting}}}/{cmake_argument(path)}"' for path in paths]
