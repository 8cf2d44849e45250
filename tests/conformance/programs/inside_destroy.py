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
p = n.create_publisher(String, "c", 10)
got = []


def cb(m):
    got.append(m.data)
    n.destroy_subscription(s)


s = n.create_subscription(String, "c", cb, 10)
time.sleep(0.3)
for i in range(3):
    p.publish(String(data=str(i)))
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(got, len(list(n.subscriptions)))
t(lambda: s.topic_name)
t(lambda: s.get_publisher_count())


def make(m):
    got.append("m" + m.data)
    n.create_subscription(String, "d", lambda m: got.append("d" + m.data), 10)


n.create_subscription(String, "c", make, 10)
time.sleep(0.3)
p.publish(String(data="a"))
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.1)
n.create_publisher(String, "d", 10).publish(String(data="z"))
time.sleep(0.3)
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.1)
print(got[:2])


def sd():
    rclpy.shutdown()
    print("shut")


n.create_timer(0.1, sd)
try:
    rclpy.spin(n)
    print("returned")
except BaseException as e:
    print(type(e), e)
