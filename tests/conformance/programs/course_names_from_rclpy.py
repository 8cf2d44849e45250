"""Annotations as an editor completes them: names that rclpy's modules only have because they import them."""

import rclpy
from rclpy.executors import Lock, SingleThreadedExecutor
from rclpy.node import Dict, List, Node, Optional
from rclpy.qos import Union
from rclpy.time import Duration, Time


class Robot(Node):
    def __init__(self, name: str = "robot", *, context: rclpy.Context | None = None, cli_args: rclpy.List[str] | None = None):
        super().__init__(name, context=context, cli_args=cli_args)
        self.lock = Lock()
        self.poses: Dict[str, List[float]] = {}
        self.last: Optional[Time] = None

    def place(self, name: str, *pose: Union[int, float]) -> rclpy.Optional[int]:
        with self.lock:
            self.poses[name] = list(pose)
        self.last = Time(nanoseconds=5) + Duration(nanoseconds=6)
        return len(self.poses)


rclpy.init()
robot = Robot()
print(robot.place("arm", 1, 2.5), robot.poses, robot.last)
executor = SingleThreadedExecutor()
executor.add_node(robot)
for module, name in ((rclpy, "Dict"), (rclpy.node, "Lock"), (rclpy, "threading")):
    try:
        print(getattr(module, name))
    except AttributeError as error:
        print(error)
rclpy.shutdown()
