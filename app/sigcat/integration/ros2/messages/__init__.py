"""Messages and services of ROS 2: made for the set, and existing ones."""
