"""A node in Python that offers methods: they are answered, in the executor of events, which takes messages meanwhile."""

import subprocess
from pathlib import Path

import pytest

from scripts import ros2_environment, ros2_packages
from tests.adapter.ros2.generated import files, integration, write
from tests.adapter.ros2.python_nodes import install, started, variables
from tests.needs import ros2

pytestmark = ros2

CODE = Path(__file__).parents[2] / "runs/cases/methods_of_another_function"
ASK = """
import rclpy
from calls_interfaces.msg import ServerModeIn
from calls_interfaces.srv import FetchLimit
from lifecycle_msgs.srv import ChangeState
from rclpy.qos import DurabilityPolicy, QoSProfile

rclpy.init()
node = rclpy.create_node('asking')


def ask(service, name, request):
    client = node.create_client(service, name)
    assert client.wait_for_service(30.0), name
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future, timeout_sec=30.0)
    return future.result()


for transition in (1, 3):
    request = ChangeState.Request()
    request.transition.id = transition
    assert ask(ChangeState, 'server/change_state', request).success
for place in (2, 4):
    answer = ask(FetchLimit, 'fetch_limit', FetchLimit.Request(place=place))
    print(answer.success, answer.limit, answer.places)
"""


@pytest.fixture(scope="module")
def where(tmp_path_factory):
    folder = tmp_path_factory.mktemp("methods")
    made = files(integration(CODE / "server.yaml", deployment={"name": "Calls"}))
    messages = {name: text for name, text in made.items() if "_interfaces/" in name}
    others = {name: text for name, text in made.items() if "_interfaces/" not in name}
    source = write(messages, folder / "messages")
    prefix = ros2_packages.build_cmake(source / "calls_interfaces", folder, folder / "built")
    (folder / "code").mkdir()
    for name in ("server.c", "calls.h"):
        (folder / "code" / name).write_bytes((CODE / name).read_bytes())
    return install(others, "calls", {"Server": ("server", folder / "code")}, prefix, folder)


def test_a_method_is_answered_and_the_node_ends_well(where, tmp_path):
    with started(where, "calls_py", "server_node", tmp_path) as node:
        command = [str(ros2_environment.PYTHON), "-c", ASK]
        done = subprocess.run(command, env=variables(where, tmp_path), capture_output=True, text=True, check=False)
        assert done.stdout.splitlines() == ["True 3.0 2", "True 6.0 6"], done.stderr
        assert node.end() == 0, node.said.read_text()
