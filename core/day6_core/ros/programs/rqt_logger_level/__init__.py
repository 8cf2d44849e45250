"""rqt_logger_level: the log levels of nodes. `model` is what the window reads, `rqt_logger_level` is the program.

The distributions of ROS 2 have no such package: the port of ros-visualization (branch ros2-port) uses a draft of the services.
This one has its widget and calls those that nodes have since Iron, `get_logger_levels` and `set_logger_levels`.
"""
