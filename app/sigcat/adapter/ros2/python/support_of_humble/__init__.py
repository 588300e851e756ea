"""Modules of `support` as rclpy of ROS 2 Humble needs them, in; the same names as there, so that they take their places, out.

They are shipped as files: sigcat itself imports none of them.
"""
