"""A second node watches the parameters of the first."""

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_event_handler import ParameterEventHandler

rclpy.init()
owner = rclpy.create_node("owner")
watcher = rclpy.create_node("watcher")
owner.declare_parameter("speed", 1)
handler = ParameterEventHandler(watcher)
one = handler.add_parameter_callback("speed", "/owner", lambda p: print("speed is", p.value.integer_value))
every = handler.add_parameter_event_callback(
    lambda e: print(e.node, [p.name for p in e.changed_parameters], [p.name for p in e.new_parameters])
)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(owner)
executor.add_node(watcher)
for _ in range(30):
    executor.spin_once(timeout_sec=0.01)
for value in (2, 3):
    owner.set_parameters([Parameter("speed", value=value)])
    for _ in range(20):
        executor.spin_once(timeout_sec=0.01)
handler.remove_parameter_callback(one)
owner.set_parameters([Parameter("speed", value=4)])
for _ in range(20):
    executor.spin_once(timeout_sec=0.01)
handler.remove_parameter_event_callback(every)
owner.declare_parameter("more", "x")
for _ in range(20):
    executor.spin_once(timeout_sec=0.01)
print("end")
rclpy.shutdown()
