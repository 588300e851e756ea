"""Packages for ROS 2, tested with the real one: the installation of `make ros2`, and a subset of rclcpp, which no registry has."""
