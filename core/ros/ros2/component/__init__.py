"""`ros2 component …`.

In real ROS components are C++ classes in shared libraries, which a container process loads. The containers of
`rclcpp_components` here take the components that came with day6-tui (package `composition` …), written in Python.
"""

SUMMARY = "Various component related sub-commands"
