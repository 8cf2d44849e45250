"""Nodes with names ROS does not take: what the exception points at, and what it came from."""

import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self, name, namespace=""):
        super().__init__(name, namespace=namespace)


rclpy.init()
for words in (
    ("2nd_robot",),
    ("my robot",),
    ("team/robot",),
    ("my-robot",),
    ("机器人",),
    ("",),
    ("r" * 256,),
    ("robot", "team one"),
    ("robot", "/team/"),
    ("robot", "team//one"),
    ("robot", "1st"),
    ("robot", "t" * 300),
    ("my robot", "team one"),
):
    try:
        print(Robot(*words).get_fully_qualified_name())
    except Exception as error:
        print(type(error).__name__, error)
        print("   from", repr(error.__context__))
Robot("3rd")
