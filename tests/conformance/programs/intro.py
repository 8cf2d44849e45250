import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.service_introspection import ServiceIntrospectionState as S
from rclpy.qos import *

rclpy.init()
n = Node("n")
s = n.create_service(SetBool, "x", lambda a, b: b)
c = n.create_client(SetBool, "x")
s.configure_introspection(n.get_clock(), qos_profile_system_default, S.CONTENTS)
c.configure_introspection(n.get_clock(), qos_profile_system_default, S.METADATA)
got = []
n.create_subscription(
    SetBool.Event,
    "/x/_service_event",
    lambda e: got.append((e.info.event_type, e.info.sequence_number, len(e.request), len(e.response))),
    10,
)
c.wait_for_service()
time.sleep(0.3)
f = c.call_async(SetBool.Request(data=True))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
for i in range(8):
    rclpy.spin_once(n, timeout_sec=0.05)
print(sorted(got))
print([x for x in n.get_topic_names_and_types() if "event" in x[0]])
s.configure_introspection(n.get_clock(), qos_profile_system_default, S.OFF)
rclpy.shutdown()
