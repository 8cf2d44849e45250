import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


import rclpy.logging
from rclpy.logging import LoggingSeverity as S

rclpy.init()
n = Node("n", namespace="/a/b")
L = n.get_logger()
print(L.name)
for i in range(5):
    L.info("once %d" % i, once=True)
    L.info("skip %d" % i, skip_first=True)
    L.info("thr %d" % i, throttle_duration_sec=0.25)
    time.sleep(0.1)
for i in range(3):
    L.warning("both %d" % i, once=True, skip_first=True)
print(L.is_enabled_for(S.DEBUG), L.get_effective_level())
L.set_level(S.DEBUG)
L.debug("dbg")
k = L.get_child("kid")
print(k.name, k.get_effective_level())
k.debug("kd")
k.set_level(40)
k.warning("no")
k.error("yes")
print(L.info("x"), L.debug("y"), k.info("z"))
rclpy.logging.set_logger_level("other", S.ERROR)
o = rclpy.logging.get_logger("other")
o.warning("hidden")
o.error("shown")
print(
    rclpy.logging.get_logger_level("other"),
    rclpy.logging.get_logger_effective_level("other.x"),
    rclpy.logging.get_logger_level("nn"),
)
t(lambda: rclpy.logging.get_logger(""))
t(lambda: L.get_child(""))
t(lambda: L.log("x", S.INFO, throttle_time_source_type=5))
t(lambda: L.info("x", throttle_duration_sec=1, throttle_time_source_type=5))
t(lambda: L.info("x", once="a"))
t(lambda: L.info("x", name="custom"))
t(lambda: L.log("m", 20))
t(lambda: L.log("m", 99))
t(lambda: rclpy.logging.set_logger_level("x", 7))


def f(v):
    L.info("f", once=v)


f(True)
t(lambda: f(False))


def g(v):
    L.info("g", throttle_duration_sec=v)


g(1.0)
t(lambda: g(2.0))


def nm(v):
    L.info("nm", name=v)


nm("p")
t(lambda: nm("q"))
L.info("multi\nline")
L.info("")
L.info("%s {name}")
L.error("é你")
rclpy.logging.clear_config()
L.debug("gone?")
L.info("still")
L.info(b"bytes") if False else None
t(lambda: L.info(b"bytes"))
t(lambda: L.info(String(data="x")))
t(lambda: L.info(["a"]))
rclpy.logging.get_logger("p.q").info("pq")
print(rclpy.logging.get_logger("a").get_effective_level())
rclpy.shutdown()
L.info("after")
