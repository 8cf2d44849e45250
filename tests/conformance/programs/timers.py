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
from rclpy.timer import TimerInfo

c = []


def cb(info: TimerInfo):
    c.append((info.actual_call_time - info.expected_call_time).nanoseconds < 50e6)


tm = n.create_timer(0.1, cb)
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.5)
print(c, tm.timer_period_ns)
tm.timer_period_ns = 50000000
print(tm.timer_period_ns)
tm.cancel()
print(tm.is_canceled(), tm.time_until_next_call())
rclpy.spin_once(n, timeout_sec=0.2)
print(len(c))
tm.reset()
print(tm.is_canceled(), tm.is_ready())
rclpy.spin_once(n, timeout_sec=0.3)
print(len(c))
n.destroy_timer(tm)
t(lambda: tm.is_ready())
print(n.destroy_timer(tm))
# slow callback skips
k = []
t0 = time.time()


def slow():
    k.append(round(time.time() - t0, 1))
    time.sleep(0.25)


tm = n.create_timer(0.1, slow)
t0 = time.time()
while time.time() - t0 < 0.95:
    rclpy.spin_once(n, timeout_sec=0.05)
print(k)
n.destroy_timer(tm)
# cancel within
k = []


def once():
    k.append(1)
    tm.cancel()


tm = n.create_timer(0.05, once)
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(k)
# destroy self within
k = []


def d():
    k.append(1)
    n.destroy_timer(tm2)


tm2 = n.create_timer(0.05, d)
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(k, len(list(n.timers)))
z = n.create_timer(0.0, lambda: k.append("z"))
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.1)
print(k)
from rclpy.clock import Clock, ClockType

q = []
n.destroy_timer(z)
n.create_timer(0.1, lambda: q.append(1), clock=Clock(clock_type=ClockType.STEADY_TIME))
rclpy.spin_once(n, timeout_sec=0.3)
print(q)
t(lambda: TimerInfo(expected_call_time=-1))
t(lambda: TimerInfo().actual_call_time)
rclpy.shutdown()
