from rclpy.qos import *
import itertools
from rclpy.duration import Duration

R = ReliabilityPolicy
D = DurabilityPolicy
L = LivelinessPolicy


def q(**k):
    return QoSProfile(depth=1, **k)


for n, pv, sv in [
    ("reliability", list(R), list(R)),
    ("durability", list(D), list(D)),
    ("liveliness", list(L), list(L)),
    (
        "deadline",
        [Duration(), Duration(seconds=1), Duration(seconds=2), DeadlineBestAvailable, Duration(nanoseconds=2**63 - 1)],
        None,
    ),
    (
        "liveliness_lease_duration",
        [Duration(), Duration(seconds=1), Duration(seconds=2), LivelinessLeaseDurationeBestAvailable],
        None,
    ),
]:
    for p in pv:
        for s in sv or pv:
            base = dict(liveliness=L.AUTOMATIC)
            a = dict(base)
            b = dict(base)
            a[n] = p
            b[n] = s
            c, r = qos_check_compatible(q(**a), q(**b))
            print(n, p, s, c.name, repr(r))
a = q(reliability=R.BEST_EFFORT, durability=D.VOLATILE, deadline=Duration(seconds=2), liveliness=L.SYSTEM_DEFAULT)
b = q(
    reliability=R.RELIABLE,
    durability=D.TRANSIENT_LOCAL,
    deadline=Duration(seconds=1),
    liveliness=L.MANUAL_BY_TOPIC,
    liveliness_lease_duration=Duration(seconds=1),
)
print(qos_check_compatible(a, b))
print(
    qos_check_compatible(
        QoSProfile(history=0, depth=0, reliability=0, durability=0, liveliness=0),
        QoSProfile(history=0, depth=0, reliability=0, durability=0, liveliness=0),
    )
)
print(
    qos_check_compatible(
        QoSProfile(history=0, depth=0, reliability=0, durability=0, liveliness=0, deadline=Duration(seconds=1)),
        q(reliability=R.BEST_EFFORT, durability=0),
    )
)
