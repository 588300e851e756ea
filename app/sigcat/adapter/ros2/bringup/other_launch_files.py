"""Further launch files: in XML, and with all nodes in one container."""

from sigcat.adapter.ros2.bringup.graph import in_order_of_activation
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.function.document.text_filters import comment_rows, python_string, xml_text

_WIDEST = 99


def xml_launch_file(workspace: WorkspacePlan) -> str:
    """The text of `launch/NAME.launch.xml`, which includes the launch file in Python with its arguments."""
    return _XML.format(
        name=xml_text(workspace.name),
        namespace=xml_text(workspace.namespace.strip("/")),
    )


_XML = """<?xml version="1.0"?>
<launch>
  <arg name="namespace" default="{namespace}" description="Namespace of the nodes."/>
  <arg name="config" default="$(find-pkg-share {name})/config" description="Folder with a file of parameters for each node."/>
  <arg name="use_sim_time" default="false" description="Whether time is that of /clock."/>
  <arg name="lock_step" default="false" description="Whether time is given by the service ~/step of each node."/>
  <arg name="log_level" default="info" description="Lowest level that is logged."/>
  <arg name="start_timeout" default="60" description="Seconds after which all end if a node is not active."/>
  <include file="$(find-pkg-share {name})/launch/{name}.launch.py">
    <arg name="namespace" value="$(var namespace)"/>
    <arg name="config" value="$(var config)"/>
    <arg name="use_sim_time" value="$(var use_sim_time)"/>
    <arg name="lock_step" value="$(var lock_step)"/>
    <arg name="log_level" value="$(var log_level)"/>
    <arg name="start_timeout" value="$(var start_timeout)"/>
  </include>
</launch>
"""


def container_launch_file(workspace: WorkspacePlan) -> str:
    """The text of `launch/NAME_container.launch.py`: one process for all nodes."""
    nodes = "".join(
        f"    ({python_string(node.name)}, {python_string(f'{workspace.name}::{node.type}')}),\n"
        for node in in_order_of_activation(workspace)
    )
    return _CONTAINER.format(
        head="\n".join(comment_rows(rights(workspace.package), "#", _WIDEST)),
        name=python_string(workspace.name),
        container=python_string(f"{workspace.name}_container"),
        nodes=nodes,
        namespace=python_string(workspace.namespace.strip("/")),
    )


_CONTAINER = '''{head}

"""
Load the nodes of this package into one container, each with separate threads.

A lifecycle manager configures all of them, then activates them in this order. It is that of Nav2
(package nav2_lifecycle_manager), which gets no heartbeats (bonds) from these nodes. With
`manager:=false`, another manager does it, such as that of the whole system.
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare

PACKAGE = {name}
NODES = (  # in the order of activation
{nodes})


def generate_launch_description():
    """Declare the arguments, load the nodes, and start their lifecycle manager."""
    container = ComposableNodeContainer(
        package='rclcpp_components',
        executable='component_container_isolated',
        arguments=['--use_multi_threaded_executor'],
        name={container},
        namespace=LaunchConfiguration('namespace'),
        composable_node_descriptions=[component(*each) for each in NODES],
        ros_arguments=['--log-level', LaunchConfiguration('log_level')],
        output='screen',
    )
    return LaunchDescription([*arguments(), container, manager()])


def arguments():
    """Declare the arguments of the launch."""
    configuration = PathJoinSubstitution([FindPackageShare(PACKAGE), 'config'])
    return [
        DeclareLaunchArgument(
            'namespace', default_value={namespace}, description='Namespace of the nodes.'),
        DeclareLaunchArgument(
            'config', default_value=configuration,
            description='Folder with a file of parameters for each node, NODE.yaml.'),
        DeclareLaunchArgument(
            'use_sim_time', default_value='false', choices=['true', 'false'],
            description='Whether time is that of /clock.'),
        DeclareLaunchArgument(
            'log_level', default_value='info', description='Lowest level that is logged.'),
        DeclareLaunchArgument(
            'manager', default_value='true', choices=['true', 'false'],
            description='Whether the lifecycle manager of Nav2 brings the nodes to life.'),
    ]


def component(name, plugin):
    """Load a node with its file of parameters."""
    return ComposableNode(
        package=PACKAGE,
        plugin=plugin,
        name=name,
        namespace=LaunchConfiguration('namespace'),
        parameters=[
            PathJoinSubstitution([LaunchConfiguration('config'), f'{{name}}.yaml']),
            {{'use_sim_time': use_sim_time()}},
        ],
    )


def manager():
    """Start the lifecycle manager; without a time for bonds, it waits for none."""
    return Node(
        package='nav2_lifecycle_manager',
        executable='lifecycle_manager',
        name={container} + '_manager',
        namespace=LaunchConfiguration('namespace'),
        parameters=[{{
            'node_names': [name for name, _ in NODES],
            'autostart': True,
            'bond_timeout': 0.0,
            'use_sim_time': use_sim_time(),
        }}],
        condition=IfCondition(LaunchConfiguration('manager')),
        output='screen',
    )


def use_sim_time():
    """Give the argument as the type that the parameter has."""
    return ParameterValue(LaunchConfiguration('use_sim_time'), value_type=bool)
'''
