"""Packages for ROS 2, judged by the real one: what `make ros2` installs, and a subset of rclcpp, which no registry has."""
