"""The Integration JSON of ROS 2 in, a workspace that colcon builds out: messages, nodes in C++ and Python, what starts them.

`plan` has a node beside each core, with every name resolved; each room writes a part of the workspace from it.
"""
