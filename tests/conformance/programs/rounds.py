import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")
out = []
for k in "ABC":
    n.create_subscription(String, k, lambda m, k=k: out.append(k + m.data), 10)
ps = {k: n.create_publisher(String, k, 10) for k in "ABC"}
time.sleep(0.5)
for k in "CBA":
    for i in range(3):
        ps[k].publish(String(data=str(i)))
n.create_timer(0.0, lambda: out.append("T")) if False else None
time.sleep(0.2)
for i in range(9):
    rclpy.spin_once(n, timeout_sec=0.2)
print(out)
out.clear()
tm = n.create_timer(0.01, lambda: (out.append("T"), tm.cancel()))
g = n.create_guard_condition(lambda: out.append("G"))
sv = n.create_service(Trigger, "s", lambda a, b: (out.append("S"), b)[1])
c = n.create_client(Trigger, "s")
c.wait_for_service()
time.sleep(0.3)
f = c.call_async(Trigger.Request())
g.trigger()
ps["B"].publish(String(data="x"))
ps["A"].publish(String(data="y"))
time.sleep(0.2)
for i in range(6):
    rclpy.spin_once(n, timeout_sec=0.2)
print(out, f.done())
rclpy.shutdown()
