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


rclpy.init()
n = Node("n")


class C:
    def __call__(self, m):
        print("C", m.data)

    def m1(self, m):
        print("m1", m.data)

    def m0(self):
        pass

    @staticmethod
    def s(m):
        print("s", m.data)

    @classmethod
    def c(cls, m):
        print("c", m.data)

    async def am(self, m):
        print("am", m.data)


def three(a, b, c):
    pass


def deflt(a, b=1):
    print("deflt", a.data, b)


def two(a, b):
    print("two", a.data, type(b).__name__, len(b))


def var(*a):
    print("var", len(a))


def kw(a, *, k):
    pass


def kwd(a, *, k=1):
    print("kwd", k)


c = C()
got = []
for f in (
    c,
    c.m1,
    c.m0,
    C.s,
    C.c,
    c.am,
    three,
    deflt,
    two,
    var,
    kw,
    kwd,
    functools.partial(two, 5),
    functools.partial(deflt, b=7),
    None,
    5,
    "x",
    lambda: 0,
    lambda m: print("lam"),
    got.append,
    print,
    String,
    len,
    dict,
    int,
    max,
    C,
):
    t(lambda: type(n.create_subscription(String, "c", f, 10)).__name__)
p = n.create_publisher(String, "c", 10)
time.sleep(0.4)
p.publish(String(data="d"))
for i in range(40):
    t2 = rclpy.spin_once(n, timeout_sec=0.05) if i < 30 else None
s = n.create_subscription(String, "e", two, 10)


def setcb():
    s.callback = three


t(setcb)
s.callback = deflt
print(s._callback_type)
rclpy.shutdown()
