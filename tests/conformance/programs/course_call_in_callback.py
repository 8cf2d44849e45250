"""A synchronous call inside a callback works with a group of its own and threads."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_srvs.srv import SetBool, Trigger

rclpy.init()
node = rclpy.create_node("nested")
inner = MutuallyExclusiveCallbackGroup()
client = node.create_client(SetBool, "set", callback_group=inner)


def set_it(request, response):
    response.success, response.message = request.data, "set" if request.data else "unset"
    return response


def ask(request, response):
    answer = client.call(SetBool.Request(data=True), timeout_sec=5.0)
    response.success, response.message = True, f"inner said {answer.message}"
    return response


node.create_service(SetBool, "set", set_it, callback_group=inner)
node.create_service(Trigger, "ask", ask)
outer = node.create_client(Trigger, "ask", callback_group=MutuallyExclusiveCallbackGroup())
outer.wait_for_service()
executor = MultiThreadedExecutor(3)
executor.add_node(node)
future = outer.call_async(Trigger.Request())
executor.spin_until_future_complete(future, timeout_sec=10)
print(future.result())
executor.shutdown()
rclpy.shutdown()
