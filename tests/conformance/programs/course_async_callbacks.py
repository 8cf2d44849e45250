"""Coroutines as callbacks that await a service inside a timer."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("coroutines")
group = ReentrantCallbackGroup()
node.create_service(Trigger, "count", lambda q, r: Trigger.Response(success=True, message="one"), callback_group=group)
client = node.create_client(Trigger, "count", callback_group=group)
client.wait_for_service()
answers = []
done = rclpy.task.Future()


async def tick():
    answer = await client.call_async(Trigger.Request())
    answers.append(answer.message)
    print("tick", len(answers))
    if len(answers) == 3:
        timer.cancel()
        done.set_result("three")


timer = node.create_timer(0.02, tick, callback_group=group)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(node)
executor.spin_until_future_complete(done, timeout_sec=5)
print(done.result(), answers)


async def twice(value):
    return value * 2


task = executor.create_task(twice, 21)
executor.spin_until_future_complete(task)
print(task.result())
rclpy.shutdown()
