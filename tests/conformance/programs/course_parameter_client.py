"""Setting another node's parameters from a program."""

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

rclpy.init()
robot = rclpy.create_node("robot")
robot.declare_parameter("gain", 1.0)
robot.declare_parameter("mode", "idle")
tuner = rclpy.create_node("tuner")
client = AsyncParameterClient(tuner, "robot")
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(robot)
executor.add_node(tuner)
print(client.wait_for_services(timeout_sec=5.0), client.services_are_ready())


def wait(future):
    executor.spin_until_future_complete(future, timeout_sec=5)
    return future.result()


print(sorted(n for n in wait(client.list_parameters()).result.names if n in ("gain", "mode")))
print(
    wait(client.get_parameters(["gain", "mode", "none"])).values
    if False
    else [v.type for v in wait(client.get_parameters(["gain", "mode"])).values]
)
print(
    [
        (r.successful, r.reason)
        for r in wait(client.set_parameters([Parameter("gain", value=2.5), Parameter("mode", value=7)])).results
    ]
)
print(robot.get_parameter("gain").value, robot.get_parameter("mode").value)
print(list(wait(client.get_parameter_types(["gain", "mode"])).types))
print([d.name for d in wait(client.describe_parameters(["gain"])).descriptors])
answer = wait(client.set_parameters_atomically([Parameter("gain", value=1.0), Parameter("mode", value="go")]))
print(answer.result.successful, robot.get_parameter("mode").value)
rclpy.shutdown()
