"""A service that adds, asked with call_async from the same program."""

import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__("server")
        self.create_service(GetParameters, "upper", self.answer)

    def answer(self, request, response):
        self.get_logger().info(f"asked for {request.names}")
        for name in request.names:
            value = response.values.append
            from rcl_interfaces.msg import ParameterValue

            value(ParameterValue(type=4, string_value=name.upper()))
        return response


class Client(Node):
    def __init__(self):
        super().__init__("client")
        self.client = self.create_client(GetParameters, "upper")
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("service not available, waiting again...")

    def send(self, *names):
        return self.client.call_async(GetParameters.Request(names=list(names)))


rclpy.init()
server = Server()
client = Client()
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(server)
executor.add_node(client)
for names in (("a",), ("left", "right"), ()):
    future = client.send(*names)
    executor.spin_until_future_complete(future)
    print([value.string_value for value in future.result().values], future.done(), future.cancelled())
print(client.client.srv_name, client.client.service_name, client.client.srv_type.__name__)
rclpy.shutdown()
