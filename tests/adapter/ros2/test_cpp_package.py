"""The package of nodes in C++, as text: what is built and run of it is with the tests that need real ROS 2."""

import json
import re
from pathlib import Path

import pytest

from sigcat.adapter.ros2.cpp.node.parameters import AS
from sigcat.errors import InputRefused
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2 import generated

SETS = (generated.ecocontrol, generated.full, generated.small, generated.storing)
CPP = (".hpp", ".cpp")


def source(made, node):
    """The source of a node."""
    (found,) = (text for name, text in made.items() if name.endswith(f"/src/{node}_node.cpp"))
    return found


def body(text, head):
    """A function of a source, without its braces."""
    return text.partition(f"::{head}(")[2].partition("\n{\n")[2].partition("\n}\n")[0]


@pytest.mark.parametrize("made", SETS)
def test_lines_fit_the_page_of_ros(made):
    """No line of C++ is wider than 100 columns, unless it is a path or a name that cannot be broken."""
    for name, text in made().items():
        if name.endswith(CPP) and "/core/" not in name:
            wide = [line for line in text.split("\n") if len(line) > 100 and not line.startswith("#include")]
            assert wide == [], name


@pytest.mark.parametrize("made", SETS)
def test_the_same_document_gives_the_same_bytes(made):
    """Nothing of a run, a clock or a hash is in the files."""
    assert made.__wrapped__() == made.__wrapped__()


def test_sets_with_a_function_of_one_name_install_nothing_under_the_same_name():
    """Their libraries share a folder; executables and files of each package have a folder of their own."""
    sets = [
        generated.files(generated.integration(FULL / "function.yaml", deployment={"name": name}))
        for name in ("One", "Other")
    ]
    texts = ["".join(text for name, text in made.items() if name.endswith("CMakeLists.txt")) for made in sets]
    libraries = [{name for name, _ in re.findall(r"add_library\((\w+) (SHARED|STATIC)", text)} for text in texts]
    assert [len(names) for names in libraries] == [3, 3]
    assert libraries[0].isdisjoint(libraries[1])
    folders = [re.findall(r"install\(TARGETS \w+_node RUNTIME DESTINATION (\S+)\)", text) for text in texts]
    assert folders == [["lib/${PROJECT_NAME}"]] * 2


def test_each_value_is_traced_to_its_path_and_unit():
    """At the place where a message meets the core, the reader finds the catalogue's path and unit."""
    text = source(generated.ecocontrol(), "core_acc")
    assert "// Vehicle.Speed [km/h]\n        CoreAcc_Adapter_Receive_EgoVehSpd(" in text
    assert (
        "// Vehicle.ADAS.EcoControl.AccelerationRequest [m/s^2]\n    message.acceleration_request = out.AccReq;" in text
    )


@pytest.mark.parametrize(("made", "node"), [(generated.ecocontrol, "core_acc"), (generated.full, "full")])
def test_subscriptions_only_store(made, node):
    """A callback locks, hands its values over and wakes the calls: it neither calls the function nor sends."""
    text = body(source(made(), node), "subscribe_all")
    assert text.count("_Receive_") >= 10
    assert not re.search(r"_Run_|_SetInput_|publish\(|_NextCall\(", text)


def test_each_node_terminates_its_core_in_one_place_and_once_for_each_init():
    """Cleanup, shutdown, errors and the destructor go the same way, which asks whether there was a good Init."""
    for made, node in ((generated.ecocontrol, "core_acc"), (generated.full, "full")):
        text = source(made(), node)
        assert len(re.findall(r"_Adapter_Terminate\(", text)) == 1
        assert "if (!is_initialized_) {\n    return;" in body(text, "terminate")
        for end in ("on_cleanup", "on_shutdown", "on_error"):
            assert "terminate();" in body(text, end)


def test_under_the_lock_of_the_core_diagnostics_are_only_copied():
    """The calls' thread waits for the lock: nothing is allocated while it is held."""
    locked = body(source(generated.ecocontrol(), "core_acc"), "tell").partition("  }\n")[0]
    assert "error = core_->adapter.error;" in locked
    assert "push_back" not in locked


def test_what_the_function_itself_publishes_is_not_subscribed_to():
    """Another call takes it from the core, at once and without a message."""
    text = source(generated.full(), "full")
    assert "Full_Adapter_Receive_AccBack(&core_->adapter, out.Acc, clock_->now());" in body(text, "publish")
    assert "AccBack" not in body(text, "subscribe_all")


def test_a_queue_sends_a_message_for_each_of_its_values():
    """As many as the core has in this step."""
    assert "for (uint32_t i = 0; i < out.Many.count; ++i) {" in body(source(generated.full(), "full"), "publish")


def test_an_enumeration_is_sent_as_text_and_as_number():
    """The two fields agree; the number of a received message is used."""
    text = source(generated.full(), "full")
    assert (
        "message.gear_out = symbol_text(kGearOutSymbols, out.GearOut);\n    message.gear_out_number = out.GearOut;"
        in text
    )
    assert "Full_Adapter_Receive_Gear(&core_->adapter, message.gear_number, clock_->now());" in text


def test_a_method_that_is_offered_waits_for_the_call_that_runs_and_tells_whether_it_answered():
    """An excluded or refused request does not return an answer with zeros."""
    text = body(source(generated.full(), "full"), "answer_do_")
    assert "lock_guard<std::mutex> call(call_mutex_);" in text
    assert "response.success = reply == SIGCAT_OK;" in text


def test_a_function_with_globals_has_one_node_in_a_process():
    """The second one is refused, with the reason; others may be loaded as often as one likes."""
    made = generated.ecocontrol()
    assert "a process can have one node of it" in source(made, "core_acc")
    assert "is_held" not in source(made, "eco_control_mpc")


@pytest.mark.parametrize(
    ("release", "quality"), [("jazzy", "rclcpp::ServicesQoS()"), ("humble", "rmw_qos_profile_services_default")]
)
def test_the_release_decides_what_a_service_takes(release, quality):
    """Jazzy warns about functions that Humble needs."""
    made = generated.files(generated.ECOCONTROL.read_bytes(), release)
    assert f"{quality}, answering_);" in source(made, "core_acc")


def test_only_the_newest_diagnostics_wait_to_be_sent():
    """In both languages, as with `diagnostic_updater`: each message has all statuses."""
    made = generated.ecocontrol()
    assert '*this, "/diagnostics", rclcpp::QoS(rclcpp::KeepLast(1)));' in source(made, "core_acc")
    module = made["eco_control_py/eco_control_py/support/function_node.py"]
    assert "quality = QoSProfile(depth=1)\n        self._diagnostics = self.create_publisher(DiagnosticArray" in module


def test_the_launch_test_leaves_the_nodes_and_the_files_of_the_user_alone():
    """It has a separate domain, and a separate folder for stored values."""
    made = generated.ecocontrol()
    settings = made["eco_control/CMakeLists.txt"]
    assert 'add_launch_test(test/test_launch.py\n    RUNNER "${ament_cmake_ros_DIR}/run_test_isolated.py")' in settings
    assert "SetEnvironmentVariable('ROS_HOME', HOME.name)," in made["eco_control/test/test_launch.py"]


def test_parts_that_no_node_uses_are_left_out():
    """Nothing watches deadlines where none is declared."""
    names = {name.rpartition("/")[2] for name in generated.storing()}
    assert "watch.hpp" not in names
    assert {"clock.hpp", "topics.hpp", "storage.hpp"} <= names
    assert "watch.cpp" not in generated.storing()[next(n for n in generated.storing() if n.endswith("CMakeLists.txt") and "_interfaces" not in n)]  # fmt: skip


def test_a_policy_that_the_deployment_gives_is_the_default_of_its_parameter():
    """In both languages, and in the file of parameters."""
    made = generated.files(
        generated.integration(FULL / "function.yaml", deployment={"ros2": {"schedulingPolicy": "fifo"}})
    )
    assert 'declare_parameter<std::string>(\n    "scheduling_policy", "fifo",' in source(made, "full")
    assert "    policy = 'fifo'\n" in made["full_py/full_py/full_node.py"]
    assert "    scheduling_policy: fifo\n" in made["full/config/full.yaml"]


def test_a_node_has_only_the_settings_that_do_something():
    assert re.findall(r'"(\w+_(?:policy|folder))"', source(generated.small(), "idle")) == []
    assert set(re.findall(r'"(\w+_(?:policy|folder))"', source(generated.full(), "full"))) == {
        "scheduling_policy", "storage_folder",
    }  # fmt: skip


def test_cmake_says_where_it_looked_for_the_code():
    """The folder of a function's code is a setting; without the code, configuring stops with both ways to give it."""
    text = generated.ecocontrol()["eco_control/CMakeLists.txt"]
    assert 'set(CORE_ACC_CODE "${CMAKE_CURRENT_SOURCE_DIR}/code/core_acc"' in text
    assert '"Put it into eco_control/code/core_acc, or set CORE_ACC_CODE to its folder.")' in text
    assert "-ffp-contract=off" in text
    assert "set_target_properties(eco_control_core_acc_core PROPERTIES UNITY_BUILD OFF)" in text


def test_a_function_with_two_nodes_is_refused_since_its_core_is_one_object():
    document = json.loads(generated.ECOCONTROL.read_bytes())
    nodes = document["NodePackageList"][0]["Nodes"]
    nodes[1]["FunctionName"] = nodes[0]["FunctionName"]
    with pytest.raises(InputRefused) as refused:
        generated.files(json.dumps(document).encode())
    assert {finding.rule for finding in refused.value.findings} == {"N219"}
    assert all(finding.pointer.startswith("/NodePackageList/0/Nodes/1/") for finding in refused.value.findings)


def test_a_queue_that_shares_its_message_is_refused():
    """It sends as many messages as it has values; other fields of the message would be sent as often."""
    document = generated.integration(FULL / "function.yaml", deployment={"ros2": {"topics": "function"}})
    with pytest.raises(InputRefused) as refused:
        generated.files(document)
    (finding,) = refused.value.findings
    assert "The queue Many must travel alone" in finding.message
    assert "`signal`" in (finding.fix or "")


READING = """\
function: Reader
description: Reads an enumeration.
responsible: Us
code: {{signature: globals, headers: [reader.h]}}
components:
  - name: Reader
    runnables:
      - interface: Step
        symbol: reader_step
        data:
          - {{path: Vehicle.Level, role: consumed, variable: level, datatype: uint8, values: {values}, provider: Outside, init: V0}}
define:
  data:
    Vehicle.Level: {{datatype: string, allowed: {texts}, asil: QM, description: A level.}}
  scheduling:
    Step: {{description: Runs., cycleTime: 20, scheduling: Preemptive, asil: QM}}
"""


def with_texts(count, tmp_path):
    """The workspace of a function that reads an enumeration of so many texts, sent as text alone."""
    numbers = {f"V{number}": number for number in range(count)}
    function = tmp_path / "reader.yaml"
    function.write_text(READING.format(values=json.dumps(numbers), texts=json.dumps([*numbers])))
    return generated.files(generated.integration(function, deployment={"ros2": {"enumerations": "text"}}))


@pytest.mark.parametrize(("count", "nameless"), [(140, 255), (255, 255), (3, 255)])
def test_a_text_that_is_no_value_becomes_a_number_that_is_none(count, nameless, tmp_path):
    made = with_texts(count, tmp_path)
    assert f"message.level, {nameless})" in source(made, "reader")
    module = next(text for name, text in made.items() if name.endswith("reader_node.py"))
    assert f"}}.get(message.level, {nameless})" in module


def test_an_enumeration_that_leaves_no_number_free_is_refused_with_what_to_do(tmp_path):
    with pytest.raises(InputRefused) as refused:
        with_texts(256, tmp_path)
    (finding,) = refused.value.findings
    assert "must have an unused number" in finding.message
    assert "`number`" in finding.fix


def test_every_learned_number_has_a_line_in_what_is_stored():
    """Only what is learned is stored beside the counts: calibration comes from parameters."""
    text = source(generated.full(), "full")
    assert 'stored.Cnt.is_there = storage.read("Cnt", stored.Cnt.value);' in text
    assert 'storage.read("K"' not in text


def test_methods_are_answered_between_calls():
    """A node that is late with its calls gives up the lock after each of them: whoever waits for an answer gets it."""
    text = source(generated.ecocontrol(), "core_acc")
    once = (
        "{\n      const std::lock_guard<std::mutex> call(call_mutex_);\n      run_due_call();\n    }\n    supervise();"
    )
    assert once in text


@pytest.mark.parametrize("type_", ["bool", "integer", "double", "string"])
def test_parameters_of_each_type_are_read_as_rclcpp_gives_them(type_):
    """The names of rclcpp: `as_int`, but `as_integer_array`."""
    subset = (Path(__file__).parent / "rclcpp_subset/include/rclcpp/parameter.hpp").read_text()
    for each in (type_, f"{type_}_array"):
        assert f" {AS[each]}() const" in subset


def test_a_node_names_messages_where_it_includes_one():
    """A node that only receives includes them in its source, one that does neither has no such namespace."""
    made = generated.small()
    headers = {name: text for name, text in made.items() if name.endswith("_node.hpp")}
    assert {name.rpartition("/")[2]: "namespace msg =" in text for name, text in headers.items()} == {
        name.rpartition("/")[2]: '#include "small_interfaces/msg/' in text for name, text in headers.items()
    }
    assert "namespace msg =" in source(made, "sink") + source(made, "echo")


def test_a_function_without_sources_has_no_loop_over_them():
    """ament_lint_cmake refuses `foreach(source )`."""
    cmake = next(text for name, text in generated.small().items() if name == "small/CMakeLists.txt")
    assert "foreach(source )" not in cmake
    assert "foreach(source CoreAcc.c" in generated.ecocontrol()["eco_control/CMakeLists.txt"]


def test_colcon_checks_every_package_with_the_linters_of_ros():
    """Without that of copyrights: a generated file has no year."""
    made = generated.ecocontrol()
    for package in ("eco_control", "eco_control_interfaces"):
        assert "ament_lint_auto_find_test_dependencies()" in made[f"{package}/CMakeLists.txt"]
        linters = {"ament_lint_auto", "ament_lint_common"}
        assert all(f"<test_depend>{each}</test_depend>" in made[f"{package}/package.xml"] for each in linters)
    before = made["eco_control/CMakeLists.txt"].partition("ament_lint_auto_find_test_dependencies()")[0]
    assert "set(ament_cmake_copyright_FOUND TRUE)" in before
