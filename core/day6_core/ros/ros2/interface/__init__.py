"""`ros2 interface …`.

Each public module is a verb, imported by the command tree only (see `ros2`).
"""

SUMMARY = "Show information about ROS interfaces"
