import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.executors import *

rclpy.init()
n = Node("n")
m = Node("m")
ex = SingleThreadedExecutor()
print(ex.get_nodes(), ex.context is rclpy.get_default_context())
ex.add_node(n)
out = []
n.create_timer(0.1, lambda: (out.append("n"), ex.add_node(m) if "x" not in out else 0, out.append("x")))
m.create_timer(0.1, lambda: out.append("m"))
while "m" not in out:
    ex.spin_once(timeout_sec=0.02)
print(out[:2], sorted(set(out)), len(ex.get_nodes()))
ex.remove_node(n)
out.clear()
while out.count("m") < 2:
    ex.spin_once(timeout_sec=0.02)
print(set(out), n.executor is ex)


def sd():
    print("sd")
    ex.shutdown()


m.create_timer(0.05, sd)
ex.spin()
print("spin returned")
t(lambda: Executor().spin_once())
t(lambda: MultiThreadedExecutor(1))
t(lambda: SingleThreadedExecutor(context=5))
ex3 = MultiThreadedExecutor(2)
ex3.add_node(n)
th = threading.Thread(target=ex3.spin)
th.start()
time.sleep(0.2)
rclpy.shutdown()
th.join(2)
print(th.is_alive())
