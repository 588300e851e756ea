"""A node of which another callback refuses parameters; it prints what its core has after each change.

A program for the interpreter that has rclpy. With the argument `humble`, rclpy has no more than that of Humble.
"""

import sys
from typing import Any

import rclpy
import rclpy.node
from eco_control_py.core_acc_node import CoreAccNode
from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter


class Node(CoreAccNode):  # type: ignore[misc]  # generated where the test runs
    """CoreAcc, with a callback that accepts less than its core does."""

    def declare_function_parameters(self) -> None:
        """Add the callback as early as a node can: rclpy calls the first one last."""
        super().declare_function_parameters()
        self.add_on_set_parameters_callback(
            lambda changes: SetParametersResult(successful=all(each.value < 5.0 for each in changes))
        )


if "humble" in sys.argv:
    del rclpy.node.Node.add_post_set_parameters_callback
rclpy.init()
node = Node()
parameters: Any = node._function_parameters
given: list[dict[str, Any]] = [{"a_lat_max": 3.0}]
set_parameters = parameters._core.set_parameters


def kept(values: dict[str, Any]) -> bool:
    """Keep what the core is given."""
    given.append(values)
    return bool(set_parameters(values))


parameters._core.set_parameters = kept
for value in (6.0, 4.0):
    (result,) = node.set_parameters([Parameter("a_lat_max", value=value)])
    print(value, result.successful, *given[-1].values())
