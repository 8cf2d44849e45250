import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.task import Future, Task
from rclpy.executors import SingleThreadedExecutor

rclpy.init()
ex = SingleThreadedExecutor()


async def co(x):
    return x * 2


def fn(x, y=1):
    return x + y


def bad():
    raise KeyError("k")


async def waits(f):
    print("w1")
    r = await f
    print("w2", r)
    return r


t1 = ex.create_task(co, 4)
t2 = ex.create_task(fn, 4, y=3)
t3 = ex.create_task(bad)
for i in range(3):
    t(lambda: ex.spin_once(timeout_sec=0.1))
print(t1.done(), t1.result(), t2.result(), t3.done())
t(lambda: t3.result())
f = Future()
w = ex.create_task(waits, f)
ex.spin_once(timeout_sec=0.1)
print(w.done(), w.executing())
f.set_result(7)
ex.spin_until_future_complete(w, timeout_sec=1)
print(w.done(), w.result())
w2 = ex.create_task(waits, Future())
ex.spin_once(timeout_sec=0)
w2.cancel()
print(w2.cancelled(), w2.done())
f3 = ex.create_future()
f3.add_done_callback(lambda x: print("cb", x.result()))
f3.set_result(3)
print("set")
ex.spin_once(timeout_sec=0.1)
f4 = Future()
f4.add_done_callback(lambda x: 1 / 0)
f4.set_result(1)
f5 = Future()
print(f5.remove_done_callback(print))
f5.add_done_callback(print)
print(f5.remove_done_callback(print))
f6 = Future()
f6.set_exception(RuntimeError("x"))
del f6
tt = Task(lambda: 5)
tt()
print(tt.result(), tt.done())
tt()
tt = Task(bad)
tt()
t(lambda: tt.result())
print(repr(tt.exception()))
n = Node("n")
ex.add_node(n)
ex.spin_until_future_complete(Future(), timeout_sec=0.1)
print("x")
ex.shutdown()
rclpy.shutdown()
