"""ROS 2: packages, messages, topics and nodes, derived from functions."""
