"""Projects of CMake are built, and not built again for nothing."""

import re
import shutil

import pytest

from sigcat.players.cmake import build
from sigcat.players.commands import BuildFails
from tests import needs

pytestmark = needs.cmake
PROJECT = "cmake_minimum_required(VERSION 3.16)\nproject(one LANGUAGES C)\nadd_executable(one one.c)\n"


@pytest.fixture
def project(tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(PROJECT)
    (tmp_path / "one.c").write_text("int main(void) { return 0; }\n")
    build(tmp_path, tmp_path / "build", {"A": 1})
    return tmp_path


def built_at(project):
    return [(project / "build" / name).stat().st_mtime_ns for name in ("one", "CMakeCache.txt")]


def test_what_did_not_change_is_neither_configured_nor_built_again(project):
    before = built_at(project)
    build(project, project / "build", {"A": 1})
    assert built_at(project) == before


def test_other_settings_configure_it_anew(project):
    build(project, project / "build", {"A": 2})
    assert "A:UNINITIALIZED=2" in (project / "build/CMakeCache.txt").read_text()


def test_settings_that_failed_do_not_stay_in_the_folder(project):
    with pytest.raises(BuildFails):
        build(project, project / "build", {"CMAKE_C_COMPILER": "/no/compiler"})
    build(project, project / "build", {"A": 1})
    assert "/no/compiler" not in (project / "build/CMakeCache.txt").read_text()


def test_a_folder_whose_configuring_was_cut_off_is_configured_anew(project):
    cache = project / "build/CMakeCache.txt"
    (project / "CMakeLists.txt").write_text("message(FATAL_ERROR cut)\n")
    with pytest.raises(BuildFails):
        build(project, project / "build", {"A": 2})
    cache.unlink()  # as if it had ended before it wrote that
    (project / "CMakeLists.txt").write_text(PROJECT)
    build(project, project / "build", {"A": 1})
    assert "A:UNINITIALIZED=1" in cache.read_text()


def test_a_copy_of_a_folder_is_built_where_it_is(project, tmp_path_factory):
    copy = tmp_path_factory.mktemp("copy") / "project"
    shutil.copytree(project, copy)
    build(copy, copy / "build", {"A": 1})
    assert str(copy) in (copy / "build/CMakeCache.txt").read_text()


def test_what_the_compiler_says_is_told(project):
    (project / "one.c").write_text("int main(void) { return nothing; }\n")
    with pytest.raises(BuildFails) as failed:
        build(project, project / "build", {"A": 1})
    assert re.search(r"one\.c:1:25: error: .*nothing", failed.value.first_error)
    assert "In function" in str(failed.value).splitlines()[1]


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({"CMakeLists.txt": PROJECT + 'message(FATAL_ERROR "no such board")\n'}, r"^CMake Error at .*: no such board$"),
        ({"one.c": "int brake(void);\nint main(void) { return brake(); }\n"}, "undefined reference to [`']brake'"),
        ({"one.c": '#include "gone.h"\n'}, r"one\.c:1:10: fatal error: gone\.h: No such file"),
    ],
    ids=["configuring", "linking", "including"],
)
def test_the_first_error_is_the_line_that_says_what_is_wrong(files, said, project):
    for name, text in files.items():
        (project / name).write_text(text)
    with pytest.raises(BuildFails) as failed:
        build(project, project / "build", {"A": 1})
    assert re.search(said, failed.value.first_error)
