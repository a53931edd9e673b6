"""The node `armui-ros2` in a real ROS 2, before a simulated arm, with a stranger's node."""
