"""Parts of a derived Integration JSON."""

from tests.integration.ros2.functions import (
    document,
    topics,
)


def messages(functions, deployment=None):
    packages = document(functions, deployment)["InterfacePackageList"]
    return {message["Name"]: message for package in packages for message in package["Messages"]}


def quality(*functions, role="Subscription", deployment=None):
    return topics(functions, deployment)[role, "vehicle/speed"]["QualityOfService"]


def ends(made, key):
    return [(each["Role"], each["TopicName"], each.get("Provider")) for each in made[key]]
