import rclpy, tempfile, os
from rclpy.node import Node
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler
from rcl_interfaces.msg import *
from rclpy.parameter import Parameter


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")
m = Node("m", allow_undeclared_parameters=True)
m.declare_parameter("a", 1)
m.declare_parameter("b.c", "x")
m.declare_parameter("d", Parameter.Type.INTEGER)
from rclpy.executors import SingleThreadedExecutor

ex = SingleThreadedExecutor()
ex.add_node(n)
ex.add_node(m)
c = AsyncParameterClient(n, "m")
print(c.wait_for_services(2), c.services_are_ready())
h = ParameterEventHandler(n)
cb = h.add_parameter_callback("a", "m", lambda p: print("CB", p))
h.add_parameter_event_callback(
    lambda e: print(
        "EV",
        e.node,
        [x.name for x in e.new_parameters],
        [x.name for x in e.changed_parameters],
        [x.name for x in e.deleted_parameters],
    )
)
import time

time.sleep(0.3)


def w(f):
    ex.spin_until_future_complete(f, timeout_sec=2)
    print(f.result())


w(c.get_parameters(["a", "b.c"]))
w(c.get_parameters(["a", "zz"]))
w(c.get_parameters(["d"]))
w(c.list_parameters())
w(c.list_parameters(["b"], 1))
w(c.get_parameter_types(["a", "b.c", "zz"]))
w(c.describe_parameters(["a"]))
w(c.describe_parameters(["zz"]))
w(c.set_parameters([Parameter("a", value=2)]))
w(c.set_parameters([Parameter("a", value="s")]))
w(c.set_parameters([Parameter("new", value="s"), Parameter("a", value=9)]))
w(c.set_parameters_atomically([Parameter("a", value=3), Parameter("b.c", value=1)]))
w(c.delete_parameters(["new"]))
w(c.delete_parameters(["a"]))
for i in range(12):
    ex.spin_once(timeout_sec=0.05)
fn = os.path.join(tempfile.mkdtemp(), "p.yaml")
open(fn, "w").write("/m:\n  ros__parameters:\n    a: 42\n    b:\n      c: hello\n")
w(c.load_parameter_file(fn))
w(c.load_parameter_file_atomically(fn))
t(lambda: c.load_parameter_file("/nope"))
open(fn, "w").write("x: 1")
t(lambda: c.load_parameter_file(fn))
h.remove_parameter_callback(cb)
t(lambda: h.remove_parameter_callback(cb))
for i in range(12):
    ex.spin_once(timeout_sec=0.05)
rclpy.shutdown()
