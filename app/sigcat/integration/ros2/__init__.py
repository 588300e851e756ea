"""Functions and the settings of ROS 2 in; Integration JSON for it, findings and a report out.

Packages, messages, topics and nodes are derived; `derive.py` is the whole way.
"""
