import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.parameter import Parameter
from rclpy.clock import *
from rosgraph_msgs.msg import Clock
from rclpy.duration import Duration

rclpy.init()
n = Node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
p = n.create_publisher(Clock, "/clock", 10)
print(n.get_clock().ros_time_is_active, n.get_clock().now())
fired = []
tm = n.create_timer(1.0, lambda: fired.append(n.get_clock().now().nanoseconds))
j = n.get_clock().create_jump_callback(
    JumpThreshold(min_forward=Duration(seconds=5), min_backward=Duration(seconds=-1)),
    pre_callback=lambda: print("pre"),
    post_callback=lambda x: print("post", x.clock_change, x.delta),
)


def tick(s):
    m = Clock()
    m.clock.sec = int(s)
    m.clock.nanosec = int((s % 1) * 1e9)
    p.publish(m)
    for i in range(3):
        rclpy.spin_once(n, timeout_sec=0.1)


for s in (10, 10.5, 11, 11.5, 12, 12.5, 20, 21, 5, 6, 6.5, 7):
    tick(s)
    print(s, n.get_clock().now(), fired, tm.time_until_next_call())
print(
    n.set_parameters([Parameter("use_sim_time", value=False)])[0].successful,
    n.get_clock().ros_time_is_active,
    n.get_clock().now().nanoseconds > 1e18,
)
t(lambda: n.set_parameters([Parameter("use_sim_time", value="x")]))
j.unregister()
t(lambda: JumpThreshold(min_forward=None, min_backward=None, on_clock_change=False))
t(lambda: JumpThreshold(min_forward=Duration(seconds=-1), min_backward=None))
t(lambda: n.get_clock().set_ros_time_override(5))
t(lambda: Clock(clock_type=5))
t(lambda: ROSClock())
rclpy.shutdown()
