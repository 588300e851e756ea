"""Files that start a workspace, and files for people: launch file, parameter files, README."""

import json
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock, patch
from xml.etree import ElementTree as ET

import jsonschema_rs
import pytest
import yaml

from scripts import ros2_environment
from tests.adapter.ros2.generated import ECOCONTROL, ecocontrol, files, full, integration, small, storing, write
from tests.needs import ros2

AMENT_FLAKE8 = (
    "--extend-ignore=B902,C816,D100,D101,D102,D103,D104,D105,D106,D107,D203,D212,D404,I202",
    "--import-order-style=google", "--max-line-length=99",
)  # fmt: skip
"""The settings of ament_flake8."""


CASES = Path(__file__).parents[2] / "runs/cases"


def launch_file(made):
    (text,) = (text for name, text in made.items() if name.endswith(".launch.py") and "_container" not in name)
    return text


def parameters(made, node):
    (text,) = (text for name, text in made.items() if name.endswith(f"config/{node}.yaml"))
    return yaml.safe_load(text)[f"/**/{node}"]["ros__parameters"]


def edited(change):
    document = json.loads(ECOCONTROL.read_bytes())
    change(document)
    return files(json.dumps(document).encode())


# -- launch file --------------------------------------------------------------------------------------------------


def test_nodes_are_activated_after_those_that_they_hear():
    assert re.findall(r"^    '(\w+)',$", launch_file(ecocontrol()), re.MULTILINE) == ["eco_control_mpc", "core_acc"]


def test_nodes_that_hear_each_other_are_activated_in_the_order_of_the_set():
    def feed_back(document):
        mpc, topics = (next(each["ROSTopicList"] for each in document["CommunicationList"] if each["RunnableName"] == name)
                       for name in ("EcoControlMpc_Step", "CoreAcc_Step"))  # fmt: skip
        speed = next(topic for topic in mpc if topic["TopicName"] == "vehicle/speed")
        given = next(topic for topic in topics if topic["TopicName"] == "core_acc/cycle50_ms")
        speed["TopicName"] = given["TopicName"]

    assert re.findall(r"^    '(\w+)',$", launch_file(edited(feed_back)), re.MULTILINE) == [
        "core_acc",
        "eco_control_mpc",
    ]


def test_the_namespace_of_the_deployment_is_the_default():
    made = files(integration(ECOCONTROL.parents[2] / "core_acc/function.yaml",
                             deployment={"ros2": {"namespace": "/ego"}}))  # fmt: skip
    assert "'namespace', default_value='ego'" in launch_file(made)


def test_a_start_that_does_not_come_to_its_end_has_a_time():
    """Each end has its reason in the log: a node that ended, that refused, and that was late."""
    text = launch_file(ecocontrol())
    assert "'start_timeout', default_value='60'" in text
    assert text.count("end(f'") == 3
    assert text.count("raise RuntimeError(") == 1


LAUNCH_MODULES = (
    "launch", "launch.actions", "launch.events", "launch.substitutions", "launch_ros.actions", "launch_ros.event_handlers",
    "launch_ros.events.lifecycle", "launch_ros.parameter_descriptions", "launch_ros.substitutions", "lifecycle_msgs.msg",
)  # fmt: skip


@pytest.fixture
def launched():
    """The functions of the launch file, over doubles of launch which keep what they are made with."""
    doubles = {name: MagicMock() for name in LAUNCH_MODULES}
    for name in ("EmitEvent", "LogInfo", "OpaqueFunction", "TimerAction"):
        setattr(doubles["launch.actions"], name, SimpleNamespace)
    doubles["launch.substitutions"].LaunchConfiguration = lambda name: SimpleNamespace(
        perform=lambda context: context.launch_configurations[name]
    )
    functions: dict[str, Any] = {}
    with patch.dict(sys.modules, doubles):
        exec(launch_file(ecocontrol()), functions)
    return SimpleNamespace(**functions)


def context(**configurations):
    return SimpleNamespace(launch_configurations=configurations, is_shutdown=False)


def test_arguments_are_read_before_a_group_that_includes_the_file_takes_them_back(launched):
    at = context(start_timeout="7")
    (timer,) = launched.in_time(at, [])
    at.launch_configurations.clear()
    assert timer.period == 7.0
    (late,) = timer.actions
    (ended,) = late.function(at)
    with pytest.raises(
        RuntimeError, match=r"^all end: eco_control_mpc has not become inactive within 7 s \(start_timeout\)$"
    ):
        ended.function(at)


def test_whoever_ends_while_all_end_ends_nobody_again(launched):
    """An exception is what `ros2 launch` returns 1 for; one while all end, as a user wants, is none."""
    (ending,) = launched.end("core_acc has ended")
    at = context()
    with pytest.raises(RuntimeError, match=r"^all end: core_acc has ended$"):
        ending.function(at)
    at.is_shutdown = True
    assert ending.function(at) is None


def test_a_launch_file_in_xml_includes_the_one_in_python_with_each_of_its_arguments():
    root = ET.fromstring(ecocontrol()["eco_control/launch/eco_control.launch.xml"])
    declared = re.findall(r"^            '(\w+)', default_value", launch_file(ecocontrol()), re.MULTILINE)
    (include,) = root.findall("include")
    assert [each.get("name") for each in root.findall("arg")] == declared
    assert [each.get("value") for each in include] == [f"$(var {name})" for name in declared]


def test_a_launch_file_loads_all_nodes_into_one_container_under_a_lifecycle_manager():
    text = ecocontrol()["eco_control/launch/eco_control_container.launch.py"]
    assert (
        "    ('eco_control_mpc', 'eco_control::EcoControlMpcNode'),\n    ('core_acc', 'eco_control::CoreAccNode'),\n"
        in text
    )
    assert "'bond_timeout': 0.0" in text


def test_a_changelog_says_of_what_each_package_is_made():
    made = ecocontrol()
    head = (
        "^" * 33 + "\nChangelog for package eco_control\n" + "^" * 33 + "\n\n1.0.0 (2025-09-12)\n------------------\n"
    )
    assert made["eco_control/CHANGELOG.rst"].startswith(head)
    assert {"eco_control_interfaces/CHANGELOG.rst", "eco_control_py/CHANGELOG.rst"} <= made.keys()


@pytest.mark.parametrize("workspace", [ecocontrol, full, small, storing])
def test_every_parameter_file_is_valid_by_its_schema(workspace):
    made = workspace()
    names = [name for name in made if "/config/" in name and name.endswith(".yaml")]
    assert names
    for name in names:
        schema = json.loads(made[name.replace(".yaml", ".schema.json")])
        jsonschema_rs.validator_for(schema).validate(yaml.safe_load(made[name]))
        assert made[name].startswith(f"# yaml-language-server: $schema={Path(name).stem}.schema.json\n")


def test_a_value_out_of_range_and_a_name_that_is_none_are_not_valid_by_the_schema():
    schema = jsonschema_rs.validator_for(json.loads(ecocontrol()["eco_control/config/core_acc.schema.json"]))
    values = lambda name, value: {"/ego/core_acc": {"ros__parameters": {name: value}}}  # noqa: E731
    assert schema.is_valid(values("a_lat_max", 8.0))
    assert not schema.is_valid(values("a_lat_max", 8.1))
    assert not schema.is_valid(values("a_lat_mx", 8.0))


def test_files_of_cores_have_a_licence_header_too():
    made = ecocontrol()
    cores = [name for name in made if name.startswith("eco_control/core/")]
    assert cores
    assert all(made[name].startswith("/* Copyright ") for name in cores)


@ros2
@pytest.mark.parametrize("workspace", [ecocontrol, full, small])
def test_the_launch_file_is_as_ament_flake8_wants_it(workspace, tmp_path):
    write({name: text for name, text in workspace().items() if name.endswith(".launch.py")}, tmp_path)
    command = [str(ros2_environment.PYTHON), "-m", "flake8", *AMENT_FLAKE8, str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.stdout, done.returncode) == ("", 0)


# -- parameter files ----------------------------------------------------------------------------------------------


def test_a_parameter_file_has_the_defaults_in_the_types_of_the_node():
    assert parameters(full(), "full") == {
        "k": 1.0, "tab": [1.0, 2.0, 3.0], "cnt": 0, "kind": "B", "scheduling_policy": "other", "storage_folder": "",
    }  # fmt: skip
    assert isinstance(parameters(ecocontrol(), "eco_control_mpc")["veh_m"], float)


def test_a_parameter_file_says_path_unit_and_range():
    text = ecocontrol()["eco_control/config/core_acc.yaml"]
    assert (
        "    # Vehicle.Function.CoreAcc.Parameter.LargestLateralAcceleration [m/s^2]; at least 0.5; at most 8\n" in text
    )


@pytest.mark.parametrize(
    ("kind", "value"),
    [
        ("double", 1e-05), ("double", 1e22), ("double", 0.1), ("integer", -(2**63)), ("bool", True),
        ("string", 'a "b": \\ # \u2028\x85 é'), ("string", "~"), ("string_array", ["no", "1; 'x' <y>"]), ("integer_array", [1, 2]),
    ],
)  # fmt: skip
def test_any_default_is_read_back_as_it_is(kind, value):
    def change(document):
        document["NodePackageList"][0]["Nodes"][0]["Parameters"][0] |= {"Default": value, "Type": kind}

    found = parameters(edited(change), "core_acc")["a_lat_max"]
    assert (found, type(found)) == (value, type(value))


def test_a_list_without_elements_is_left_to_the_default():
    def change(document):
        document["NodePackageList"][0]["Nodes"][0]["Parameters"][0] |= {"Default": [], "Type": "double_array"}

    assert "a_lat_max" not in parameters(edited(change), "core_acc")


READ_BY_RCL = """
import sys
import rclpy
for file in sys.argv[1:]:
    rclpy.init(args=['--ros-args', '--params-file', file])
    rclpy.shutdown()
    print(file)
"""


@ros2
@pytest.mark.parametrize("workspace", [ecocontrol, full, small, storing])
def test_rcl_reads_every_parameter_file(workspace, tmp_path):
    write(workspace(), tmp_path)
    made = sorted(map(str, tmp_path.glob("*/config/*.yaml")))
    command = [str(ros2_environment.PYTHON), "-c", READ_BY_RCL, *made]
    done = subprocess.run(command, env=ros2_environment.variables(), capture_output=True, text=True, check=False)
    assert (done.stdout.split(), done.returncode) == (made, 0), done.stderr


def test_a_parameter_file_without_values_says_that_there_are_none():
    assert parameters(small(), "idle") == {}


# -- README -------------------------------------------------------------------------------------------------------


def picture(made):
    return made["README.md"].partition("```mermaid\n")[2].partition("```")[0].splitlines()


def test_the_picture_has_the_nodes_and_who_feeds_them():
    """A topic is listed once, whatever its subscribers, with those that have the same direction."""
    lines = picture(ecocontrol())
    assert lines[:3] == [
        "flowchart LR", '  outside1(["Brake control unit"]):::outside', '  outside2(["Steering control unit"]):::outside',
    ]  # fmt: skip
    assert {'  core_acc_node(["core_acc"])', '  eco_control_mpc_node(["eco_control_mpc"])'} <= {*lines}
    assert '  outside1 --- topics1["vehicle/chassis/brake/cyl_p"] --> core_acc_node' in lines
    (speed,) = (line for line in lines if "vehicle/speed" in line)
    assert speed.endswith(
        '["vehicle/speed<br>vehicle/adas/cruise_control/speed_set"] --> core_acc_node & eco_control_mpc_node'
    )
    assert any(line.startswith("  eco_control_mpc_node --- ") and line.endswith(" --> core_acc_node") for line in lines)


def test_who_sends_to_the_set_and_hears_it_is_drawn_twice():
    """So no line leads back, through the text of others."""
    lines = picture(ecocontrol())
    before, behind = (line.split("(")[0].strip() for line in lines if "outside of the set" in line)
    assert any(line.startswith(f"  {before} --- ") for line in lines)
    assert any(line.endswith(f" --> {behind}") for line in lines)
    assert not any(line.startswith(f"  {behind} -") or line.endswith(f" --> {before}") for line in lines)


def services(made):
    return [line for line in picture(made) if ".->" in line]


def test_the_picture_has_who_asks_and_who_answers():
    calls = CASES / "methods_of_another_function"
    pair = files(integration(*sorted(calls.glob("*.yaml"))))
    assert services(pair) == ['  client_node -.- services1[["fetch_limit<br>reset"]] -.-> server_node']
    asks, answers = services(full())
    before, behind = (line.split("(")[0].strip() for line in picture(full()) if "outside of the set" in line)
    assert asks == f'  full_node -.- services1[["ask"]] -.-> {behind}'
    assert answers == f'  {before} -.- services2[["do"]] -.-> full_node'


def test_the_table_of_topics_has_types_ends_quality_and_units():
    assert (
        "| `vehicle/speed` | `eco_control_interfaces/msg/Speed` | outside of the set | `core_acc`, `eco_control_mpc` | "
        "best effort, volatile, depth 1 | `speed`: Vehicle.Speed \\[km/h\\] |"
    ) in ecocontrol()["README.md"].splitlines()


def test_every_topic_of_a_node_stands_in_the_table():
    page = ecocontrol()["README.md"]
    document = json.loads(ECOCONTROL.read_bytes())
    topics = {topic["TopicName"] for call in document["CommunicationList"] for topic in call["ROSTopicList"]}
    for node in document["NodePackageList"][0]["Nodes"]:
        for key in ("ErrorTopics", "SafetyReactionTopics", "ModeTopics"):
            topics |= {each["TopicName"] for each in node[key]}
    assert topics == set(re.findall(r"^\| `([\w/]+)` \| `eco_control_interfaces/msg/", page, re.MULTILINE))


def test_words_of_a_document_are_no_markup():
    def change(document):
        document["NodePackageList"][0]["Description"] = "<script> | `x` [y](z)\n# more"
        topic = document["CommunicationList"][0]["ROSTopicList"][0]
        topic["DataMappingList"][0]["FieldList"][0]["ExternalProvider"] = 'A "b" <c>\n  x --> y'

    page = edited(change)["README.md"]
    assert "\n\\&lt;script".replace("\\", "") + "&gt; \\| \\`x\\` \\[y\\](z) # more\n" in page
    assert '["A #34;b#34; #60;c#62; x --#62; y"]' in page


def test_it_says_how_the_code_of_each_function_is_given():
    assert "-DCORE_ACC_CODE=FOLDER" in ecocontrol()["README.md"]
