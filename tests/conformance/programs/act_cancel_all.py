import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger
from rclpy.action import *
from rclpy.executors import *
from rclpy.callback_groups import *
from test_msgs.action import Fibonacci


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from action_msgs.srv import CancelGoal

rclpy.init()
n = Node("n")
s = ActionServer(
    n,
    Fibonacci,
    "fib",
    lambda g: None,
    handle_accepted_callback=lambda gh: None,
    cancel_callback=lambda g: CancelResponse.ACCEPT,
)
c = ActionClient(n, Fibonacci, "fib")
c.wait_for_server()
hs = []
for o in (1, 2, 3):
    f = c.send_goal_async(Fibonacci.Goal(order=o))
    rclpy.spin_until_future_complete(n, f)
    hs.append(f.result())
k = n.create_client(CancelGoal, "fib/_action/cancel_goal")
k.wait_for_service()
f = k.call_async(CancelGoal.Request())
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
print(f.result().return_code, len(f.result().goals_canceling))
for i in range(8):
    rclpy.spin_once(n, timeout_sec=0.05)
print([h.status for h in hs])
f = hs[0].cancel_goal_async()
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
print(f.result().return_code)
q = CancelGoal.Request()
q.goal_info.goal_id.uuid[0] = 9
f = k.call_async(q)
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
print(f.result().return_code)
rclpy.shutdown()
