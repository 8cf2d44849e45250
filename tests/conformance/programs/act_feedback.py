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


def ex(gh):
    fb = Fibonacci.Feedback()
    fb.sequence = [0, 1]
    for i in range(1, gh.request.order):
        fb.sequence.append(fb.sequence[i] + fb.sequence[i - 1])
        gh.publish_feedback(fb)
    gh.succeed()
    r = Fibonacci.Result()
    r.sequence = fb.sequence
    return r


s = ActionServer(n, Fibonacci, "fib", ex)
c = ActionClient(n, Fibonacci, "fib")
print(c.wait_for_server(timeout_sec=2))


def fbcb(m):
    print("fb", m.feedback.sequence.tolist() if hasattr(m.feedback.sequence, "tolist") else m.feedback.sequence)


done = []


def resp(f):
    gh = f.result()
    print("accepted", gh.accepted)
    gh.get_result_async().add_done_callback(
        lambda f: (print("result", list(f.result().result.sequence), f.result().status), done.append(1))
    )


c.send_goal_async(Fibonacci.Goal(order=6), feedback_callback=fbcb).add_done_callback(resp)
while not done:
    rclpy.spin_once(n, timeout_sec=1)
rclpy.shutdown()
