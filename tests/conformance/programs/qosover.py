import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.qos_overriding_options import *
from rclpy.qos import *

rclpy.init(
    args=[
        "--ros-args",
        "-p",
        "qos_overrides./c.publisher.depth:=77",
        "-p",
        "qos_overrides./c.publisher.reliability:=best_effort",
        "-p",
        "qos_overrides./bad.publisher.reliability:=zzz",
    ]
)
n = Node("n")
p = n.create_publisher(String, "c", 10, qos_overriding_options=QoSOverridingOptions.with_default_policies())
print(p.qos_profile)
print(sorted(n._parameters))
t(lambda: n.create_publisher(String, "bad", 10, qos_overriding_options=QoSOverridingOptions.with_default_policies()))
t(
    lambda: n.create_subscription(
        String,
        "s",
        print,
        10,
        qos_overriding_options=QoSOverridingOptions.with_default_policies(
            callback=lambda q: QosCallbackResult(successful=False, reason="no"), entity_id="id"
        ),
    )
)
t(
    lambda: (
        n.create_subscription(
            String, "s2", print, 10, qos_overriding_options=QoSOverridingOptions(list(QoSPolicyKind)[1:])
        ).qos_profile.depth
    )
)
print(n.describe_parameter("qos_overrides./c.publisher.depth"))
rclpy.shutdown()
