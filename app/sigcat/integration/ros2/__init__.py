"""Functions and the settings of ROS 2 in; Integration JSON for it, findings and a report out.

Packages, messages, topics and nodes are derived; `ros2_integration.py` is the whole way.
"""
