"""A service that returns nothing, or the wrong thing."""

import rclpy
from std_srvs.srv import SetBool, Trigger


def attempt(name, answer):
    rclpy.init()
    node = rclpy.create_node("server")
    node.create_service(Trigger, name, answer)
    client = node.create_client(Trigger, name)
    client.wait_for_service()
    future = client.call_async(Trigger.Request())
    try:
        rclpy.spin_until_future_complete(node, future, timeout_sec=2)
        print(name, future.result())
    except Exception as error:
        print(name, type(error).__name__, error)
    rclpy.shutdown()


def forgets(request, response):
    response.success = True


attempt("right", lambda q, r: r)
attempt("forgets", forgets)
attempt("other_type", lambda q, r: SetBool.Response())
attempt("one_argument", lambda q: None)
attempt("raises", lambda q, r: 1 / 0)
