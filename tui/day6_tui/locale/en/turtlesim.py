"""Turtlesim."""

TEXTS = {
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "no turtle",
    "turtlesim.more": "{count} more",
    "turtlesim.from": "from",
    "turtlesim.undriven": "no node publishes here; to drive it:",
    "turtlesim.label": "names",
    "help.turtlesim": (
        "The world of turtlesim, 11.09 metres wide. The node /turtlesim subscribes to velocities on /turtle1/cmd_vel and "
        "publishes the turtle's position on /turtle1/pose.\n\n"
        "To drive, run ros2 run turtlesim turtle_teleop_key in a terminal and stay in it: the arrow keys work only in the "
        "terminal that runs it.\n\n"
        "Ctrl-C in turtlesim_node's terminal closes this window."
    ),
}
