"""Tests of the package, which `colcon test` runs: the life of each node, its parameters, lock-step, what it keeps."""

from sigcat.adapter.ros2.cpp.layout import spaced, text
from sigcat.adapter.ros2.cpp.names import copyright_line, header_of
from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import c_header, c_string, docstring_text, python_string


def node_test(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source of a node's tests."""
    return spaced([
        copyright_line(workspace),
        _includes(node, workspace),
        f"namespace srv = {workspace.interfaces}::srv;\nusing {workspace.name}::{node.type};\nusing lifecycle_msgs::msg::State;",
        _fixture(node),
        _life(node),
        _life_with_errors(node),
        *([_parameters(node)] if _ranged(node) else []),
        _lock_step(node),
        *([_stored(node)] if node.is_stored else []),
    ]) + "\n"  # fmt: skip


def _includes(node: NodePlan, workspace: WorkspacePlan) -> str:
    headers = [f"{workspace.name}/{node.stem}.hpp", header_of(node.step_service), "lifecycle_msgs/msg/state.hpp"]
    headers += ["rclcpp/rclcpp.hpp", *([f"{workspace.name}/storage.hpp"] if node.is_stored else [])]
    standard = ["chrono", "filesystem", "fstream", "future", "memory", "string", "thread"]
    return spaced([
        "#include <gtest/gtest.h>\n#include <unistd.h>",
        "\n".join(f"#include <{each}>" for each in standard),
        "\n".join(f"#include {c_header(each)}" for each in sorted(headers)),
    ])  # fmt: skip


def _fixture(node: NodePlan) -> str:
    folder = """    options.append_parameter_override("storage_folder", folder_.string());
""" if node.is_stored else ""  # fmt: skip
    return f"""class {node.type}Test : public ::testing::Test
{{
protected:
  static void SetUpTestSuite() {{rclcpp::init(0, nullptr);}}
  static void TearDownTestSuite() {{rclcpp::shutdown();}}

  void SetUp() override {{std::filesystem::remove_all(folder_);}}
  void TearDown() override {{std::filesystem::remove_all(folder_);}}

  std::shared_ptr<{node.type}> make_node() const
  {{
    rclcpp::NodeOptions options;
    options.append_parameter_override("lock_step", true);
{folder}    return std::make_shared<{node.type}>(options);
  }}

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
    ({c_string(f"test_{node.stem}_")} + std::to_string(getpid()));
}};"""


def _life(node: NodePlan) -> str:
    file = _stored_file(node)
    kept = f"""
  EXPECT_TRUE(std::filesystem::exists({file}));""" if node.is_stored else ""  # fmt: skip
    return f"""TEST_F({node.type}Test, GoesThroughItsLife)
{{
  const auto node = make_node();
  EXPECT_EQ(node->get_current_state().id(), State::PRIMARY_STATE_UNCONFIGURED);
  EXPECT_EQ(node->configure().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->activate().id(), State::PRIMARY_STATE_ACTIVE);
  EXPECT_EQ(node->deactivate().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->activate().id(), State::PRIMARY_STATE_ACTIVE);
  EXPECT_EQ(node->deactivate().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->cleanup().id(), State::PRIMARY_STATE_UNCONFIGURED);{kept}
  EXPECT_EQ(node->configure().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->shutdown().id(), State::PRIMARY_STATE_FINALIZED);
}}"""


def _stored_file(node: NodePlan) -> str:
    return f"""{node.package}::storage_file(
        folder_.string(), {c_string(f"/{node.name}")},
        node->get_node_base_interface()->get_context()->get_domain_id())"""


def _life_with_errors(node: NodePlan) -> str:
    return f"""TEST_F({node.type}Test, StaysWhereATransitionDoesNotBegin)
{{
  const auto node = make_node();
  EXPECT_EQ(node->activate().id(), State::PRIMARY_STATE_UNCONFIGURED);
  EXPECT_EQ(node->cleanup().id(), State::PRIMARY_STATE_UNCONFIGURED);
  EXPECT_EQ(node->configure().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->configure().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_EQ(node->deactivate().id(), State::PRIMARY_STATE_INACTIVE);
}}"""


def _ranged(node: NodePlan) -> list[NodeParameter]:
    return [each for each in node.settable if not each.is_read_only and each.high is not None]


def _parameters(node: NodePlan) -> str:
    checks = [_refused(each) for each in _ranged(node)]
    return f"""TEST_F({node.type}Test, RefusesParametersOutOfRange)
{{
  const auto node = make_node();
{text(checks)}
}}"""


def _refused(parameter: NodeParameter) -> str:
    assert parameter.high is not None
    beyond = f"{parameter.high + 1}" if parameter.type == "double" else f"int64_t{{{int(parameter.high) + 1}}}"
    beyond = beyond if "." in beyond or "int64" in beyond else f"{beyond}.0"
    name = c_string(parameter.name)
    return f"""  const auto {parameter.name}_before = node->get_parameter({name});
  EXPECT_FALSE(node->set_parameter(rclcpp::Parameter({name}, {beyond})).successful);
  EXPECT_EQ(node->get_parameter({name}), {parameter.name}_before);"""


def _lock_step(node: NodePlan) -> str:
    cycles = [step.cycle for step in node.steps if step.cycle]
    return _LOCK_STEP.format(type=node.type, service=c_string(f"/{node.name}/step"), cycle=min(cycles, default=10**7))


_LOCK_STEP = """TEST_F({type}Test, RunsInLockStep)
{{
  const auto node = make_node();
  const auto caller = std::make_shared<rclcpp::Node>("caller");
  const auto client = caller->create_client<srv::Step>({service});
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 3);
  executor.add_node(node->get_node_base_interface());
  executor.add_node(caller->get_node_base_interface());
  std::thread spinning([&executor] {{executor.spin();}});
  const auto step = [&client](uint64_t time) {{
      const auto request = std::make_shared<srv::Step::Request>();
      request->time = time;
      std::promise<srv::Step::Response> answered;
      auto answer = answered.get_future();
      client->async_send_request(
        request, [&answered](rclcpp::Client<srv::Step>::SharedFuture future) {{
          answered.set_value(*future.get());
        }});
      return answer.get();
    }};
  node->configure();
  while (!client->service_is_ready()) {{
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }}
  EXPECT_FALSE(step(0).success);  // not active
  node->activate();
  uint64_t sent = 0;
  for (uint64_t time = 0; time < 20; ++time) {{
    const srv::Step::Response response = step((time + 1) * {cycle}U);
    EXPECT_TRUE(response.success) << response.message;
    EXPECT_EQ(response.received, 0U);
    EXPECT_GE(response.sent, sent);
    sent = response.sent;
  }}
  executor.cancel();
  spinning.join();
  node->shutdown();
}}"""


def _stored(node: NodePlan) -> str:
    return f"""TEST_F({node.type}Test, StartsWithoutABrokenFile)
{{
  const auto node = make_node();
  const auto path = {_stored_file(node)};
  std::filesystem::create_directories(folder_);
  std::ofstream(path) << "nothing that it wrote\\n";
  EXPECT_EQ(node->configure().id(), State::PRIMARY_STATE_INACTIVE);
  EXPECT_TRUE(std::filesystem::exists(path.string() + ".broken"));
  EXPECT_EQ(node->cleanup().id(), State::PRIMARY_STATE_UNCONFIGURED);
  std::ifstream file(path);
  std::string line;
  EXPECT_TRUE(std::getline(file, line));
  EXPECT_EQ(line, "sigcat 1");
}}"""


def launch_test(workspace: WorkspacePlan) -> str:
    """The launch file brings every node to its active state."""
    nodes = ", ".join(python_string(f"{workspace.namespace.rstrip('/')}/{node.name}") for node in workspace.nodes)
    return _LAUNCH.format(
        package=docstring_text(workspace.name),
        name=python_string(workspace.name),
        launch=python_string(f"launch/{workspace.name}.launch.py"),
        nodes=nodes,
    )


_LAUNCH = '''"""The launch file brings every node of {package} to its active state."""

import os
from tempfile import TemporaryDirectory
import time
import unittest

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, SetEnvironmentVariable
from launch.launch_description_sources import PythonLaunchDescriptionSource
import launch_testing
from launch_testing.actions import ReadyToTest
from launch_testing.asserts import assertExitCodes
from lifecycle_msgs.msg import State
from lifecycle_msgs.srv import GetState
import pytest
import rclpy

NODES = ({nodes},)
LAUNCH = {launch}
HOME = TemporaryDirectory()
"""Where the nodes keep what they store: not where those of the user do."""


@pytest.mark.launch_test
def generate_test_description():
    """Launch all nodes."""
    path = os.path.join(get_package_share_directory({name}), LAUNCH)
    source = PythonLaunchDescriptionSource(path)
    return LaunchDescription([
        SetEnvironmentVariable('ROS_HOME', HOME.name),
        IncludeLaunchDescription(source),
        ReadyToTest(),
    ])


class TestNodes(unittest.TestCase):
    """While the nodes run."""

    def setUp(self):
        """Make a node that asks."""
        rclpy.init()
        self.node = rclpy.create_node('test_launch')

    def tearDown(self):
        """Drop it."""
        self.node.destroy_node()
        rclpy.shutdown()

    def test_all_become_active(self):
        """Every node is active within half a minute."""
        end = time.monotonic() + 30.0
        waiting = set(NODES)
        while waiting and time.monotonic() < end:
            waiting = {{name for name in waiting if self.state(name) != State.PRIMARY_STATE_ACTIVE}}
        self.assertEqual(waiting, set())

    def state(self, name):
        """Return the state of a node, or None if it does not answer."""
        client = self.node.create_client(GetState, f'{{name}}/get_state')
        if not client.wait_for_service(timeout_sec=1.0):
            return None
        future = client.call_async(GetState.Request())
        rclpy.spin_until_future_complete(self.node, future, timeout_sec=1.0)
        return future.result().current_state.id if future.done() else None


@launch_testing.post_shutdown_test()
class TestShutdown(unittest.TestCase):
    """After the nodes have ended."""

    def test_exit_codes(self, proc_info):
        """Every process has ended well."""
        assertExitCodes(proc_info)
'''
