"""Tests of the package, which `colcon test` runs: linters, cores without ROS, nodes in lock-step."""

from sigcat.adapter.core.c.lines import Line, Lines, joined, lines
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.ros2.python.core_module import core_type
from sigcat.adapter.ros2.python.names import between, docstring, sorted_imports
from sigcat.adapter.ros2.python.package import core_stem, package_name

FLAKE8_TEST = """from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8() -> None:
    code, errors = main_with_errors(argv=[])
    assert code == 0, '\\n'.join(errors)
"""
CONFTEST = """import os

from domain_coordinator import domain_id
import pytest


@pytest.fixture(scope='session', autouse=True)
def domain():
    \"\"\"Keep the nodes of tests apart from all others, unless ROS_DOMAIN_ID says where they are.\"\"\"
    if 'ROS_DOMAIN_ID' in os.environ:
        yield
        return
    with domain_id() as number:
        os.environ['ROS_DOMAIN_ID'] = str(number)
        yield


def pytest_collection_modifyitems(items) -> None:
    \"\"\"Run linters first: they fork, which the threads of ROS do not survive.\"\"\"
    items.sort(key=lambda item: item.get_closest_marker('linter') is None)
"""
PEP257_TEST = """from ament_pep257.main import main
import pytest


@pytest.mark.pep257
@pytest.mark.linter
def test_pep257() -> None:
    assert main(argv=['.', 'test']) == 0
"""
_CORE_TESTS = """
@pytest.fixture
def core():
    made = CORE_TYPE()
    yield made
    made.close()


def test_it_is_initialized_runs_and_is_terminated(core) -> None:
    assert core.init()
    core.start(0)
    ran = core.run_due(0) + core.run_due(10 ** 9)
    assert set(ran) <= {call.interface for call in core.calls}
    core.published()
    core.terminate(10 ** 9)
    assert core.run_due(2 * 10 ** 9) == []


def test_it_goes_on_with_what_was_stored(core) -> None:
    assert core.init(None, 1)
    stored = core.stored()
    assert core.init(stored, 2)
    assert core.stored()['ignition_cycle'] == 2


def test_a_library_of_another_generation_is_refused() -> None:
    class Other(CORE_TYPE):
        digest = 'of another declaration'

    with pytest.raises(LayoutError):
        Other()
"""
_NODE_TESTS = """
@pytest.fixture
def node(tmp_path):
    rclpy.init()
    settings = [
        Parameter('lock_step', value=True),
STORAGE_FOLDER    ]
    made = NODE_TYPE(parameter_overrides=settings)
    yield made
    made.destroy_node()
    rclpy.shutdown()


def answer(node, service, name, request):
    executor = SingleThreadedExecutor()
    other = rclpy.create_node('tester')
    executor.add_node(node)
    executor.add_node(other)
    client = other.create_client(service, f'{node.get_name()}/{name}')
    assert client.wait_for_service(10.0)
    future = client.call_async(request)
    executor.spin_until_future_complete(future, 10.0)
    executor.remove_node(node)
    other.destroy_node()
    return future.result()


def test_it_goes_through_its_life(node, tmp_path) -> None:
    assert node.trigger_configure() == TransitionCallbackReturn.SUCCESS
    assert node.trigger_activate() == TransitionCallbackReturn.SUCCESS
    told = answer(node, Step, 'step', Step.Request(received=0, time=10 ** 9))
    assert told.success, told.message
    assert node.trigger_deactivate() == TransitionCallbackReturn.SUCCESS
    assert node.trigger_cleanup() == TransitionCallbackReturn.SUCCESS
STORED

def test_a_transition_that_its_state_does_not_have_is_refused(node) -> None:
    request = ChangeState.Request()
    request.transition.label = 'activate'
    assert not answer(node, ChangeState, 'change_state', request).success
    request.transition.label = 'configure'
    assert answer(node, ChangeState, 'change_state', request).success
"""
_STORAGE_FOLDER = """        Parameter('storage_folder', value=str(tmp_path)),
"""
_STORED = """    (file,) = tmp_path.iterdir()
    assert file.read_text().startswith('sigcat 1')
"""


def core_test(node: NodePlan, workspace: WorkspacePlan) -> Lines:
    """Tests of a core, which need no ROS but its packages."""
    core, name = core_type(node.core), package_name(workspace)
    modules = [(f"{name}.{core_stem(node)}", [core]), (f"{name}.support.core", ["LayoutError"]), ("pytest", ())]
    about = f"The core of {node.core.function} lives, without ROS."
    head = joined([docstring(about), (Line(""),), sorted_imports(modules)])
    return between([head, lines(_CORE_TESTS.replace("CORE_TYPE", core))], 2)


def node_test(node: NodePlan, workspace: WorkspacePlan) -> Lines:
    """Tests of a node with rclpy: its life, in lock-step."""
    modules = [
        (f"{package_name(workspace)}.{node.stem}", [node.type]),
        ("lifecycle_msgs.srv", ["ChangeState"]),
        (f"{node.step_service.package}.srv", [node.step_service.name]),
        ("pytest", ()),
        ("rclpy", ()),
        ("rclpy.executors", ["SingleThreadedExecutor"]),
        ("rclpy.lifecycle", ["TransitionCallbackReturn"]),
        ("rclpy.parameter", ["Parameter"]),
    ]
    about = f"The node of {node.core.function} lives, in lock-step."
    head = joined([docstring(about), (Line(""),), sorted_imports(modules)])
    folder, stored = (_STORAGE_FOLDER, _STORED) if node.is_stored else ("", "")
    tests = _NODE_TESTS.replace("NODE_TYPE", node.type).replace("STORAGE_FOLDER", folder).replace("STORED", stored)
    return between([head, lines(tests)], 2)
