"""Notebooks."""

TEXTS = {
    "notebook.here": "ROS 2 is ready: import rclpy, or %ros2 topic list. Nodes keep running after their cell.",
    "notebook.init_again": "ROS is already initialised, so this rclpy.init() does nothing. rclpy.shutdown() ends ROS.",
    "notebook.again": "{name}: the node created here before has been destroyed",
    "notebook.goes_on": "{name} keeps running in the background; {end} ends it",
    "notebook.go_on": "{names} keep running in the background; destroy_node() ends one of them, rclpy.shutdown() all",
    "notebook.failed": (
        "{name} no longer spins after this error; a program would have ended. Fix the error and run the cell that creates "
        "the node again."
    ),
    "notebook.ended": "{name} no longer spins: a callback called exit, which would have ended a program",
    "notebook.stuck": (
        "{name}: a callback hasn't returned for {seconds} s{where}. Until it does, no other callback of this node runs. "
        "destroy_node() ends it."
    ),
    "notebook.ros2.background": "keeps running in the background until the kernel ends; {end} ends it now",
}
