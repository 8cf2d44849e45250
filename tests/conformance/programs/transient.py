import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.qos import *
from rclpy.duration import Duration

rclpy.init()
n = Node("n")
q = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
p = n.create_publisher(Int32, "l", q)
for i in range(5):
    p.publish(Int32(data=i))
got = []
s = n.create_subscription(
    Int32, "l", lambda m: got.append(m.data), QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
)
got2 = []
s2 = n.create_subscription(Int32, "l", lambda m: got2.append(m.data), 10)
for i in range(6):
    rclpy.spin_once(n, timeout_sec=0.1)
print(got, got2)
p.publish(Int32(data=9))
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(got, got2)
k = n.create_publisher(Int32, "k", QoSProfile(history=HistoryPolicy.KEEP_ALL))
g3 = []
n.create_subscription(Int32, "k", lambda m: g3.append(m.data), QoSProfile(history=HistoryPolicy.KEEP_ALL))
time.sleep(0.3)
for i in range(30):
    k.publish(Int32(data=i))
for i in range(32):
    rclpy.spin_once(n, timeout_sec=0.05)
print(len(g3))
rclpy.shutdown()
