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


rclpy.init()
n = Node("n")
q = []


def ex(gh):
    print("exec", gh.request.order, gh.status)
    gh.succeed() if gh.request.order != 2 else gh.abort()
    return Fibonacci.Result(sequence=[gh.request.order])


s = ActionServer(n, Fibonacci, "fib", ex, handle_accepted_callback=lambda gh: q.append(gh))
c = ActionClient(n, Fibonacci, "fib")
c.wait_for_server()
hs = []
for o in (1, 2, 3):
    f = c.send_goal_async(Fibonacci.Goal(order=o))
    rclpy.spin_until_future_complete(n, f)
    hs.append(f.result())
print([h.status for h in hs], [g.status for g in q], [g.is_active for g in q])
for g in q:
    g.execute()
rs = [h.get_result_async() for h in hs]
for r in rs:
    rclpy.spin_until_future_complete(n, r, timeout_sec=2)
    print(r.result())
q[0].execute(lambda g: Fibonacci.Result()) if False else None
t(lambda: q[0].execute())
print(q[0] == q[0], q[0] == q[1], q[0] == 5)
rclpy.shutdown()
