"""What futures do: results, exceptions, cancelling, callbacks."""

import rclpy
from rclpy.task import Future

future = Future()
future.add_done_callback(lambda f: print("called with", f.result()))
print(future.done(), future.cancelled(), future.result())
future.set_result(5)
print(future.done(), future.result())
future.add_done_callback(lambda f: print("called at once", f.result()))
broken = Future()
broken.set_exception(ValueError("broken"))
print(broken.done(), repr(broken.exception()))
try:
    broken.result()
except ValueError as error:
    print("raised", error)
cancelled = Future()
cancelled.add_done_callback(lambda f: print("cancelled:", f.cancelled()))
print(cancelled.cancel(), cancelled.cancelled(), cancelled.done())


async def waits():
    return await future


coroutine = waits()
try:
    coroutine.send(None)
except StopIteration as stop:
    print("awaited", stop.value)
rclpy.init()
rclpy.shutdown()
