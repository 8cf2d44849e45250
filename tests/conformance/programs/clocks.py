import rclpy, time, threading, functools
from rclpy.node import Node
from rclpy.qos import *
from rclpy.duration import Duration
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.clock import *
from rclpy.time import Time

rclpy.init()
n = Node("n")
c = n.get_clock()
a = c.now()
b = c.now()
print(b >= a, (b - a).nanoseconds < 1e9, a.to_msg().sec > 1e9, type(c).__name__, c)
t(lambda: c.now() - Clock().now())
t(lambda: Clock(clock_type=ClockType.STEADY_TIME))
t(lambda: Clock(clock_type=ClockType.UNINITIALIZED))
t(lambda: TimeJump(5, Duration()))
t(lambda: TimeJump(ClockChange.ROS_TIME_ACTIVATED, Duration(seconds=1)).delta)
t(lambda: c.create_jump_callback(JumpThreshold(min_forward=None, min_backward=None)))
t(lambda: c.create_jump_callback(JumpThreshold(min_forward=None, min_backward=None), pre_callback=5))
t(lambda: c.create_jump_callback(JumpThreshold(min_forward=None, min_backward=None), post_callback=5))
print(
    Time(seconds=1.5).nanoseconds,
    Time.from_msg(Time(seconds=2).to_msg(), clock_type=ClockType.SYSTEM_TIME) == Time(seconds=2),
    Duration(seconds=1) * 1.5,
    Duration.from_msg(Duration(seconds=-1.5).to_msg()),
    Duration(seconds=1) == 5,
    Duration(seconds=3) >= Duration(seconds=3),
)
t(lambda: Duration(seconds=1) * float("nan"))
t(lambda: Duration(seconds=1) * float("inf"))
t(lambda: Duration(seconds=1) * "x")
t(lambda: 2 * Duration(seconds=1))
t(lambda: Duration(seconds=1) < 5)
t(lambda: Duration.from_msg(5))
t(lambda: Time(seconds=5) - Duration(seconds=6))
t(lambda: Time(nanoseconds=-1))
t(lambda: Time(seconds=1, clock_type=5))
t(lambda: -Duration(seconds=1))
t(lambda: abs(Duration(seconds=-1)))
t(lambda: Duration(seconds=1) / 2)
t(lambda: bool(Duration()))
t(lambda: Time(seconds=1) + Time(seconds=1))
t(lambda: Duration(seconds=1) + Time(seconds=1))
t(lambda: Duration(1))
t(lambda: Time(1))
t(lambda: Duration(seconds="1"))
t(lambda: Time(seconds=1) != Time(seconds=2))
t(lambda: ClockType.ROS_TIME == 1)
t(lambda: int(ClockType.ROS_TIME))
t(lambda: list(ClockType)) if False else None
t(lambda: hash(Duration()))
rclpy.shutdown()
