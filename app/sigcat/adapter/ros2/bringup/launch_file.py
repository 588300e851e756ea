"""The launch file: starts every node, and brings the set through its transitions."""

from sigcat.adapter.ros2.bringup.graph import in_order_of_activation
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.function.document.text_filters import comment_rows, python_string

_WIDEST = 99


def launch_file(workspace: WorkspacePlan) -> str:
    """The text of `launch/NAME.launch.py`."""
    return _TEXT.format(
        head="\n".join(comment_rows(rights(workspace.package), "#", _WIDEST)),
        name=python_string(workspace.name),
        nodes="".join(f"    {python_string(node.name)},\n" for node in in_order_of_activation(workspace)),
        namespace=python_string(workspace.namespace.strip("/")),
    )


_TEXT = '''{head}

"""
Start the nodes of this package and bring them through their transitions.

All of them are configured before the first one is activated, so that nothing is missed. Each
is activated after those that it hears. If a node ends, cannot be configured or activated, or has
not been so in time, all end, and the reason is logged.
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, OpaqueFunction
from launch.actions import RegisterEventHandler, TimerAction
from launch.events import matches_action
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare
from lifecycle_msgs.msg import Transition

PACKAGE = {name}
NODES = (  # in the order of activation
{nodes})


def generate_launch_description():
    """Declare the arguments, start the nodes, and let each transition follow the one before."""
    nodes = [lifecycle_node(name) for name in NODES]
    steps = [
        *((node, Transition.TRANSITION_CONFIGURE) for node in nodes),
        *((node, Transition.TRANSITION_ACTIVATE) for node in nodes),
    ]
    reached = []
    followed = [after(*step, reached, change(*following))
                for step, following in zip(steps, steps[1:])]
    failed = [handler for name, node in zip(NODES, nodes) for handler in on_failure(name, node)]
    return LaunchDescription([
        *arguments(), *followed, after(*steps[-1], reached), *failed,
        OpaqueFunction(function=in_time, args=[reached]), *nodes, change(*steps[0])])


def arguments():
    """Declare what the launch can be told."""
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
            'lock_step', default_value='false', choices=['true', 'false'],
            description='Whether time is given by the service ~/step of each node, for tests.'),
        DeclareLaunchArgument(
            'log_level', default_value='info', description='Lowest level that is logged.'),
        DeclareLaunchArgument(
            'start_timeout', default_value='60',
            description='Seconds after which all end if a node has not been activated.'),
    ]


def lifecycle_node(name):
    """Start a node with its file of parameters."""
    return LifecycleNode(
        package=PACKAGE,
        executable=f'{{name}}_node',
        name=name,
        namespace=LaunchConfiguration('namespace'),
        parameters=[
            PathJoinSubstitution([LaunchConfiguration('config'), f'{{name}}.yaml']),
            {{each: ParameterValue(LaunchConfiguration(each), value_type=bool)
             for each in ('use_sim_time', 'lock_step')}},
        ],
        ros_arguments=['--log-level', LaunchConfiguration('log_level')],
        output='screen',
        on_exit=end(f'{{name}} has ended'),
    )


def end(reason):
    """End all with an error, and say why, unless they end already."""
    def ending(context):
        if not context.is_shutdown:
            # An error ends all, and lets `ros2 launch` return 1: no event of launch does.
            raise RuntimeError(f'all end: {{reason}}')

    return [OpaqueFunction(function=ending)]


def change(node, transition):
    """Ask a node for a transition."""
    return EmitEvent(event=ChangeState(
        lifecycle_node_matcher=matches_action(node), transition_id=transition))


def after(node, transition, reached, *actions):
    """Count a transition that a node has made, and do what follows it."""
    start, goal = {{
        Transition.TRANSITION_CONFIGURE: ('configuring', 'inactive'),
        Transition.TRANSITION_ACTIVATE: ('activating', 'active'),
    }}[transition]
    return RegisterEventHandler(OnStateTransition(
        target_lifecycle_node=node, start_state=start, goal_state=goal, handle_once=True,
        entities=[OpaqueFunction(function=lambda _: reached.append(goal)), *actions]))


def in_time(context, reached):
    """End all if a node has not been configured or activated after the time for that."""
    # Read now: the arguments of a group that includes this file end with the group.
    seconds = LaunchConfiguration('start_timeout').perform(context)

    def late(_):
        if len(reached) == 2 * len(NODES):
            return None
        goals = [(name, goal) for goal in ('inactive', 'active') for name in NODES]
        name, goal = goals[len(reached)]
        return end(f'{{name}} has not become {{goal}} within {{seconds}} s (start_timeout)')

    return [TimerAction(period=float(seconds), actions=[OpaqueFunction(function=late)])]


def on_failure(name, node):
    """End all if a node refuses to be configured or activated."""
    for start, goal in (
        ('configuring', 'unconfigured'), ('activating', 'inactive'),
        ('configuring', 'errorprocessing'), ('activating', 'errorprocessing'),
    ):
        yield RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=node, start_state=start, goal_state=goal,
            entities=end(f'{{name}} went from {{start}} to {{goal}}')))
'''
