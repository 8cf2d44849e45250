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
got = []
n.create_subscription(String, "c", lambda m: got.append(m.data), 10)
p = n.create_publisher(String, "c", 10)
th = threading.Thread(target=rclpy.spin, args=(n,), daemon=True)
th.start()
time.sleep(0.3)
r = n.create_rate(20)
for i in range(5):
    p.publish(String(data=str(i)))
    r.sleep()
print(got)
n.destroy_rate(r)
t(lambda: r.sleep())
c = n.create_client(Trigger, "x")
s = n.create_service(Trigger, "x", lambda a, b: b)
print(c.wait_for_service(2), c.call(Trigger.Request()))
n.create_timer(0.05, lambda: got.append("T"))
time.sleep(0.2)
print("T" in got)
rclpy.shutdown()
th.join(2)
print(th.is_alive())
