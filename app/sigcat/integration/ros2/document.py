"""Integration JSON for ROS 2 from anywhere: the model, or everything that is wrong with it."""

from sigcat import codes
from sigcat.integration.checked_document import DocumentKind
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.integration.ros2.problems import problems_of

read_integration = DocumentKind("ros2", Ros2Integration, codes.NOT_WRITABLE_AS_ROS2, problems_of).read
"""The model of a document. Raises InputRefused with every finding."""
