"""Times and durations: adding, comparing, converting, and what may not be mixed."""

from rclpy.clock import ClockType
from rclpy.duration import Duration, Infinite
from rclpy.time import Time

a = Time(seconds=10, nanoseconds=500)
b = Time(seconds=8)
d = Duration(seconds=1, nanoseconds=250)
print(a, b, d, a - b, a + d, a - d, d + b)
print(a > b, a == Time(nanoseconds=10_000_000_500), a.seconds_nanoseconds(), (a - b).nanoseconds)
print(Duration(seconds=2) > d, Duration(seconds=1) == Duration(nanoseconds=10**9), d.to_msg())
print(Time.from_msg(a.to_msg()), Duration.from_msg(d.to_msg()), a.to_msg())
print(Duration(seconds=1) + Duration(seconds=2), Duration(seconds=2) * 2 if hasattr(Duration, "__mul__") else "no *")
print(Infinite, repr(a), hash(a) == hash(Time(seconds=10, nanoseconds=500)) if Time.__hash__ else "unhashable")
for name, wrong in (
    ("times of two clocks", lambda: a < Time(seconds=1, clock_type=ClockType.STEADY_TIME)),
    ("sum of times", lambda: a + b),
    ("time and number", lambda: a - 1),
    ("negative time", lambda: Time(seconds=-1)),
    ("too early", lambda: b - Duration(seconds=9)),
    ("too large", lambda: Time(seconds=2**63)),
    ("time and text", lambda: a < "x"),
    ("clock type", lambda: Time(clock_type=3)),
):
    try:
        print(name, wrong())
    except Exception as error:
        print(name, type(error).__name__, error)
