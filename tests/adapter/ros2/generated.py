"""Packages, generated from functions."""

from functools import cache

from sigcat.adapter.ros2.ros2_workspace import generate
from sigcat.data import EXAMPLES
from sigcat.function.function_file import build_function
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from sigcat.platforms.integrate import integrate
from sigcat.platforms.ros2 import ROS2
from tests.adapter.autosar_adaptive.application.generated import FULL, SMALL, STORING
from tests.function.shipped import interfaces, resolved

ECOCONTROL = EXAMPLES / "ecocontrol/expected/ros2.json"


def integration(*paths, deployment=None):
    """The Integration JSON of function files, with what a deployment says."""
    functions = [resolved(build_function(path.read_bytes(), path.name, interfaces())[0]) for path in paths]
    return integrate(ROS2, functions, DEPLOYMENT_FILE.model_validate(deployment or {})).document


def files(document, release=None):
    """The files of an Integration JSON, by name."""
    return {file.name: file.data.decode() for file in generate(document, "ros2.json", DEFAULT_LIMITS, release)}


@cache
def ecocontrol():
    """The workspace of EcoControl."""
    return files(ECOCONTROL.read_bytes())


@cache
def full():
    """The workspace of the function that uses everything that a declaration can say."""
    return files(integration(FULL / "function.yaml"))


@cache
def bonded():
    """The same with bonds."""
    return files(integration(FULL / "function.yaml", deployment={"ros2": {"bond": True}}))


@cache
def small():
    """The workspace of functions that leave out almost everything, or have names that are easily taken."""
    return files(integration(*sorted(SMALL.glob("*.yaml")), deployment={"name": "Small"}))


@cache
def storing():
    """The workspace of a function with parameters in several storages."""
    return files(integration(STORING))


def write(made, folder):
    """Write files into a folder."""
    for name, text in made.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder
