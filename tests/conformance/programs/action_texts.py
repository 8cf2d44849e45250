import rclpy, time, sys
from rclpy.node import Node
from rclpy.action import *
from rclpy.action.server import ServerGoalHandle
from test_msgs.action import Fibonacci
from std_msgs.msg import String


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__name__, "|", e)


rclpy.init()
n = Node("n")


def ex(gh):
    print("st", gh.status, gh.is_active, gh.is_cancel_requested, gh.request)
    t(lambda: gh.publish_feedback(5))
    t(lambda: gh.publish_feedback(Fibonacci.Feedback()))
    t(lambda: gh.canceled())
    t(lambda: gh.execute())
    t(lambda: gh.succeed())
    t(lambda: gh.succeed())
    t(lambda: gh.abort())
    t(lambda: gh.canceled())
    print(gh.status, gh.is_active)
    return Fibonacci.Result(sequence=[1])


fb = []
s = ActionServer(n, Fibonacci, "fib", ex, cancel_callback=lambda g: CancelResponse.ACCEPT)
c = ActionClient(n, Fibonacci, "fib")
print(c.wait_for_server(3), c.server_is_ready())
f = c.send_goal_async(Fibonacci.Goal(order=3), feedback_callback=lambda m: fb.append(m))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
gh = f.result()
import re

print(re.sub(r"\[[\d ]+\]", "[U]", repr(gh)), gh.status, gh.accepted, type(gh.stamp))
r = gh.get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
for i in range(5):
    rclpy.spin_once(n, timeout_sec=0.05)
print(gh.status, len(fb), type(fb[0]).__name__ if fb else None)
r = gh.cancel_goal_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(re.sub(r"array\(.*?\)", "A", repr(r.result()), flags=re.S))
r = gh.get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
print(n.get_topic_names_and_types())
print([x for x in n.get_service_names_and_types() if "fib" in x[0]])
print(
    get_action_names_and_types(n),
    get_action_server_names_and_types_by_node(n, "n", "/"),
    get_action_client_names_and_types_by_node(n, "n", "/"),
)
t(lambda: get_action_server_names_and_types_by_node(n, "zz", "/"))
print(s.get_num_entities(), c.get_num_entities())
for name in ("fib/_action/status", "fib/_action/feedback"):
    for i in n.get_publishers_info_by_topic(name):
        print(str(i.qos_profile))


# goal exception
def ex2(gh):
    raise ValueError("boom")


s2 = ActionServer(n, Fibonacci, "fib2", ex2)
c2 = ActionClient(n, Fibonacci, "fib2")
c2.wait_for_server(2)
f = c2.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
r = f.result().get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
# goal callback wrong return
s3 = ActionServer(n, Fibonacci, "fib3", ex2, goal_callback=lambda g: True)
c3 = ActionClient(n, Fibonacci, "fib3")
c3.wait_for_server(2)
f = c3.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
print(f.result().accepted)
r = f.result().get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())


# async cancel while executing
async def ex4(gh):
    print("exec4")
    while not gh.is_cancel_requested:
        await sleepfut()
    gh.canceled()
    return Fibonacci.Result(sequence=[9])


from rclpy.task import Future


def sleepfut():
    fu = Future()
    n.create_timer(0.05, lambda: fu.done() or fu.set_result(None))
    return fu


s4 = ActionServer(n, Fibonacci, "fib4", ex4, cancel_callback=lambda g: CancelResponse.ACCEPT)
c4 = ActionClient(n, Fibonacci, "fib4")
c4.wait_for_server(2)
f = c4.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
g4 = f.result()
for i in range(5):
    rclpy.spin_once(n, timeout_sec=0.1)
print(g4.status)
r = g4.cancel_goal_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result().return_code, len(r.result().goals_canceling))
r = g4.get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
for i in range(5):
    rclpy.spin_once(n, timeout_sec=0.05)
print(g4.status)
# default cancel rejects
s5 = ActionServer(n, Fibonacci, "fib5", ex4)
c5 = ActionClient(n, Fibonacci, "fib5")
c5.wait_for_server(2)
f = c5.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
r = f.result().cancel_goal_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
t(lambda: ActionServer(n, Fibonacci, "bad name", ex4))
t(lambda: ActionServer(n, Fibonacci, "", ex4))
t(lambda: ActionServer(n, Fibonacci, "{x}", ex4))
t(lambda: ActionClient(n, 5, "x"))
t(lambda: s.destroy())
t(lambda: s.destroy())
t(lambda: c4.send_goal_async(Fibonacci.Goal(), goal_uuid=5))
t(lambda: c4.wait_for_server(timeout_sec=0.1))
t(lambda: s4.register_goal_callback(5))
t(lambda: s4.register_execute_callback(None))
