"""Notebooks."""

TEXTS = {
    "notebook.here": "ROS 2 is here: import rclpy, and %ros2 topic list. Nodes go on after their cell.",
    "notebook.init_again": "ROS is initialised already, so this rclpy.init() does nothing. rclpy.shutdown() ends ROS.",
    "notebook.again": "{name}: the node made here before has been destroyed",
    "notebook.goes_on": "{name} goes on in the background; {end} ends it",
    "notebook.go_on": "{names} go on in the background; destroy_node() ends one of them, rclpy.shutdown() all",
    "notebook.failed": (
        "{name} is not spun any more after this error, as a program would have ended. "
        "Correct it, and run the cell again that makes the node."
    ),
    "notebook.ended": "{name} is not spun any more: a callback has called exit, which would have ended a program",
    "notebook.stuck": (
        "{name}: a callback has not returned for {seconds} s{where}. Until it does, no other callback of this node runs. "
        "destroy_node() ends it."
    ),
    "notebook.ros2.background": "goes on in the background until the kernel ends; {end} ends it now",
}
