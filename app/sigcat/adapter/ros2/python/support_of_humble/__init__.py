"""Modules that replace those of the same names in `support`, for rclpy of ROS 2 Humble.

They are shipped as files: sigcat itself imports none of them.
"""
