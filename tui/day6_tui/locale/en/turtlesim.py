"""Turtlesim."""

TEXTS = {
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "no turtle",
    "turtlesim.more": "{count} more",
    "turtlesim.from": "from",
    "turtlesim.undriven": "nobody publishes here; to drive it:",
    "turtlesim.label": "names",
    "help.turtlesim": (
        "The world of turtlesim, 11.09 metres wide. The node /turtlesim subscribes to velocities on /turtle1/cmd_vel and "
        "publishes where the turtle is on /turtle1/pose.\n\n"
        "To drive, start ros2 run turtlesim turtle_teleop_key in a terminal and keep the keyboard there: the arrow "
        "keys work only in the terminal that runs it.\n\n"
        "Ctrl-C in the terminal of turtlesim_node closes this window."
    ),
}
