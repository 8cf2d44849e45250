"""`ros2 component …`.

In real ROS components are C++ classes in shared libraries, which a container process loads. The containers of
`rclcpp_components` here load the components that come with day6-tui (package `composition` …), written in Python.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various component related sub-commands"
