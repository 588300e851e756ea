"""The package in Python: its text, and its cores without ROS."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from scripts import ros2_environment
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2 import generated
from tests.adapter.ros2.python_nodes import STRICT, build_core
from tests.needs import CPP_COMPILERS, c_compiler, cmake, ros2

SETS = (generated.ecocontrol, generated.full, generated.small, generated.storing)
CLASS = Path(__file__).parents[2] / "runs/cases/members_of_a_class"


def module(made, name):
    """A module of the package."""
    (found,) = (text for file, text in made.items() if file.endswith(f"_py/{name}.py"))
    return found


@pytest.mark.parametrize("made", SETS)
def test_every_module_can_be_read_and_fits_the_page_of_ros(made):
    for name, text in made().items():
        if name.endswith(".py"):
            compile(text, name, "exec")
            assert [line for line in text.split("\n") if len(line) > 99 and "# noqa: E501" not in line] == [], name


@pytest.mark.parametrize("made", SETS)
def test_the_same_document_gives_the_same_bytes(made):
    assert made.__wrapped__() == made.__wrapped__()


def test_each_value_is_traced_to_its_path_and_unit():
    made = generated.ecocontrol()
    assert '"""Take Vehicle.Speed [km/h]."""\n' in module(made, "core_acc_core")
    assert "# Vehicle.Speed [km/h]\n        self.core.receive_ego_veh_spd(message.speed, t)" in module(
        made, "core_acc_node"
    )


def test_both_releases_differ_in_what_rclpy_tells_of_events_and_messages_alone():
    jazzy, humble = (generated.files(generated.ECOCONTROL.read_bytes(), release) for release in ("jazzy", "humble"))
    support = "eco_control_py/eco_control_py/support"
    differing = [name for name in jazzy if name.startswith("eco_control_py/") and jazzy[name] != humble[name]]
    events, message_info = (f"{support}/{name}.py" for name in ("events", "message_info"))
    assert sorted(differing) == [events, message_info]
    assert humble[events] == jazzy[events].replace("rclpy.event_handler", "rclpy.qos_event")
    assert "def callback(message: Any) -> None" in humble[message_info]


def test_what_the_modules_import_is_in_the_description_of_the_package():
    made = generated.ecocontrol()
    text = "\n".join(text for name, text in made.items() if name.startswith("eco_control_py/eco_control_py/"))
    imported = set(re.findall(r"^\s*(?:from|import) ([a-z]\w*)", text, re.MULTILINE)) - set(sys.stdlib_module_names)
    named = set(re.findall(r"<exec_depend>(\w[\w-]*)<", made["eco_control_py/package.xml"]))
    assert {"cffi": "python3-cffi"}.get("cffi") in named
    assert imported - {"cffi"} == named - {"python3-cffi", "eco_control"}


@ros2
@pytest.mark.parametrize("linter", ["ament_flake8", "ament_pep257"])
def test_the_linters_of_ros_find_nothing(linter, tmp_path):
    for number, made in enumerate(SETS):
        generated.write({name: text for name, text in made().items() if "_py/" in name}, tmp_path / str(number))
    command = [str(ros2_environment.ENVIRONMENT / "bin" / linter), str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-3000:]


# -- cores --------------------------------------------------------------------------------------------------------


def ran(made, package, library, script, folder):
    """Return the output of a script that has the package of a core, but no ROS."""
    generated.write({name: text for name, text in made.items() if name.startswith(f"{package}/")}, folder)
    code = f"from pathlib import Path\nlibrary = Path({str(library)!r})\n{script}"
    command = [str(ros2_environment.PYTHON), "-c", code]
    variables = {"PYTHONPATH": str(folder / package), "PATH": "/usr/bin"}
    return subprocess.run(command, env=variables, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def full(tmp_path_factory):
    """The core that uses everything, compiled; a warning is an error."""
    folder = tmp_path_factory.mktemp("full")
    generated.write({name: text for name, text in generated.full().items() if "/core/" in name}, folder)
    build_core(folder / "full/core", "Full", FULL, folder / "libfull_core.so")
    return folder / "libfull_core.so"


LIVES = """
from full_py.full_core import FullCore
core = FullCore(library)
assert core.init()
core.start(0)
core.receive_place({'Latitude': 48.5, 'Longitude': 9.25, 'Kind': 1, 'Values': [1, 2, 3]}, 0)
core.receive_arr([1, 2, 3, 4, 5], 0)
core.receive_list_(7, 0)
print(core.run_due(5_000_000))
print(core.method_do(a=4), core.request_ask()[1])
core.answer_ask(1, True, {'r': 2.5}, 0)
print(core.out().gear_out, core.out().many, core.out().place_out['Values'])
for values in ([], [1] * 4, [1] * 6):
    try:
        core.receive_arr(values, 0)
    except ValueError as error:
        print(error)
print(core.set_parameters({'K': 11.0}), core.set_parameters({'K': 10.0}))
core.terminate(5_000_000)
stored = core.stored()
print(stored['Cnt'], stored['ignition_cycle'], core.init(stored, 2))
"""


@ros2
@c_compiler
def test_a_core_lives_without_ros(full, tmp_path):
    done = ran(generated.full(), "full_py", full, LIVES, tmp_path)
    assert done.stdout.splitlines() == [
        "['Full_Step', 'Full_EventStep']",
        "(0, {'r': 4.0}) {'a': 0.0}",
        "0 [] [0, 0, 0]",
        "there must be 5 elements, not 0",
        "there must be 5 elements, not 4",
        "there must be 5 elements, not 6",
        "False True",
        "{'value': 1, 'is_there': True} 1 True",
    ], done.stderr  # fmt: skip


SETTINGS = """
from types import SimpleNamespace
from full_py.support.parameters import Parameters
def settings(priority, is_stored):
    found = {}
    node = SimpleNamespace(
        declare_parameter=lambda name, default, descriptor: found.update({name: SimpleNamespace(value=default)}),
        get_parameter=lambda name: found[name], add_post_set_parameters_callback=None)
    made = Parameters(node, SimpleNamespace(package='full'), None, None)
    made.declare_settings('other', priority, is_stored=is_stored)
    return list(found)
print(settings(None, False))
print(settings(11, True))
"""


@ros2
@c_compiler
def test_a_node_has_only_the_settings_that_do_something(full, tmp_path):
    done = ran(generated.full(), "full_py", full, SETTINGS, tmp_path)
    assert done.stdout.splitlines() == [
        "['lock_step']", "['lock_step', 'storage_folder', 'scheduling_policy']",
    ], done.stderr  # fmt: skip


STORES = """
from full_py.full_core import FullCore
from full_py.support.storage import Storage
core = FullCore(library)
core.init(None, 4)
core.start(0)
core.run_due(5_000_000)
core.terminate(5_000_000)
Storage(Path('kept/full.txt'), core).save()
print(Storage(Path('kept/full.txt'), core).load()['Cnt'])
print([line for line in Path('kept/full.txt').read_text().splitlines() if '.' not in line])
"""


@ros2
@c_compiler
def test_what_a_function_has_learned_is_stored_and_read_back(full, tmp_path):
    done = ran(generated.full(), "full_py", full, f"import os\nos.chdir({str(tmp_path)!r})\n{STORES}", tmp_path)
    assert done.stdout.splitlines() == [
        "{'value': 1, 'is_there': True}", "['sigcat 1', 'Cnt: 1', 'ignition_cycle: 4']",
    ], done.stderr  # fmt: skip


REFUSED = """
from full_py.full_core import FullCore
from full_py.support.core import LayoutError
def refused(**changed):
    try:
        type('Changed', (FullCore,), changed)(library)
    except LayoutError as error:
        return str(error).removeprefix(f'{library} ')
print(refused(digest='0'))
print(refused(declarations=FullCore.declarations.replace('uint16_t occurrences;', 'uint32_t occurrences;')))
print(refused(function='Empty', declarations='const char *Empty_Bridge_Digest(void);'))
print(refused())
"""


@ros2
@c_compiler
def test_a_library_that_does_not_fit_is_refused_before_anything_is_read(full, tmp_path):
    done = ran(generated.full(), "full_py", full, REFUSED, tmp_path)
    assert done.stdout.splitlines() == [
        "was generated from another Full: build it again",
        "has another layout than this machine: build it again",
        "does not have the core of Empty",
        "None",
    ], done.stderr  # fmt: skip


ONCE = """
from full_py.full_core import FullCore
first = FullCore(library)
try:
    FullCore(library)
except RuntimeError as error:
    print(error)
first.close()
FullCore(library).close()
"""


@ros2
@c_compiler
def test_where_the_data_of_a_function_is_global_there_is_one_core_in_a_process(full, tmp_path):
    done = ran(generated.full(), "full_py", full, ONCE, tmp_path)
    assert done.stdout == "Full: there can be no further one in this process\n", done.stderr


TWICE = """
from demo_py.demo_core import DemoCore
cores = [DemoCore(library), DemoCore(library)]
for number, core in enumerate(cores):
    assert core.init()
    core.start(0)
    core.receive_speed(10.0 * number, 0)
    print(core.run_due(0))
    core.close()
"""


@ros2
@cmake
def test_the_core_of_a_class_has_as_many_objects_as_are_wanted(tmp_path):
    made = generated.files(generated.integration(CLASS / "function.yaml"))
    generated.write(made, tmp_path)
    core, library = tmp_path / "demo/core", tmp_path / "libdemo_core.so"
    helper = tmp_path / "helper.o"
    subprocess.run(["gcc", "-c", "-fPIC", CLASS / "helper.c", "-o", helper], check=True)
    sources = [*core.glob("*.cpp"), core / "sigcat_core.c", CLASS / "controller.cpp", helper]
    flags = ["-std=c++17", "-shared", "-fPIC", *STRICT, f"-I{core}", f"-I{CLASS}"]
    subprocess.run([*CPP_COMPILERS[0], *flags, *sources, "-o", library], check=True)
    done = ran(made, "demo_py", library, TWICE, tmp_path)
    assert done.stdout == "['Demo_Step']\n['Demo_Step']\n", done.stderr
