"""Parameters and names given as ROS arguments of the node."""

import rclpy

rclpy.init(
    args=[
        "prog",
        "--ros-args",
        "-p",
        "rate:=5",
        "-p",
        "label:=hi",
        "-r",
        "__node:=renamed",
        "-r",
        "out:=/tele/out",
        "-p",
        "numbers:=[1, 2, 3]",
        "-p",
        "flag:=true",
        "-p",
        "ratio:=2.5",
    ]
)
node = rclpy.create_node("original", automatically_declare_parameters_from_overrides=True)
print(node.get_fully_qualified_name())
for name in ("rate", "label", "numbers", "flag", "ratio"):
    print(name, node.get_parameter(name).value, type(node.get_parameter(name).value).__name__)
print(node.resolve_topic_name("out"), node.resolve_topic_name("out", only_expand=True))
from std_msgs.msg import Empty

print(node.create_publisher(Empty, "out", 1).topic_name)
rclpy.shutdown()
