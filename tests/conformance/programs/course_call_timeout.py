"""A call nobody answers."""

import rclpy
from std_srvs.srv import Empty

rclpy.init()
node = rclpy.create_node("lonely")
client = node.create_client(Empty, "nobody")
print(client.wait_for_service(timeout_sec=0.1), client.service_is_ready())
future = client.call_async(Empty.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=0.2)
print(future.done(), future.result())
try:
    client.call(Empty.Request(), timeout_sec=0.1)
except TimeoutError as error:
    print("TimeoutError", error)
print(client.remove_pending_request(future))
for wrong in (None, Empty.Response(), "text"):
    try:
        client.call_async(wrong)
    except TypeError as error:
        print("TypeError", error)
rclpy.shutdown()
