"""The main function of a node's own executable."""

from sigcat.adapter.ros2.cpp.names import copyright_line
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import c_header, c_string


def main_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source. Two threads beside the one that receives: one answers, one changes the state."""
    return f"""{copyright_line(workspace)}

#include <cstdlib>
#include <exception>
#include <memory>

#include {c_header(f"{workspace.name}/{node.stem}.hpp")}
#include "rclcpp/rclcpp.hpp"

int main(int argc, char * argv[])
{{
  int result = EXIT_SUCCESS;
  try {{
    rclcpp::init(argc, argv);
    const auto node = std::make_shared<{workspace.name}::{node.type}>(rclcpp::NodeOptions());
    // One thread answers, one changes the state. The node receives in a thread of its own.
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
    executor.add_node(node->get_node_base_interface());
    executor.spin();
  }} catch (const std::exception & error) {{
    RCLCPP_FATAL(rclcpp::get_logger({c_string(node.name)}), "%s", error.what());
    result = EXIT_FAILURE;
  }}
  rclcpp::shutdown();
  return result;
}}
"""
