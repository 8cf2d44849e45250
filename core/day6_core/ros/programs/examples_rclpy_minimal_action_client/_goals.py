"""What the four clients do with the action `fibonacci`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci

from rclpy.action import ActionClient
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session

ORDER = 10
SECONDS_TO_CANCEL = 2.0


class Goals:
    """An action client in a node of its own that logs what happens."""

    def __init__(self, session: Session, name: str) -> None:
        self.session = session
        node = session.create_node(name)
        self.info = node.get_logger().info
        self.client: ActionClient[Any, Any, Any] = ActionClient(node, Fibonacci, "fibonacci")
        session.executor.add_node(node)

    async def send(self) -> Any:
        """Send a goal of order ten; returns the handle, or None if it was rejected."""
        self.info("Waiting for action server...")
        while not self.client.server_is_ready():
            await self.session.sleep(0.02)
        self.info("Sending goal request...")
        sent: Any = self.client.send_goal_async(Fibonacci.Goal(order=ORDER), feedback_callback=self._feedback)
        await self.session.spin_until(sent)
        handle = sent.result()
        self.info("Goal accepted :)" if handle.accepted else "Goal rejected :(")
        return handle if handle.accepted else None

    async def result(self, handle: Any, failure: str = "status") -> tuple[Any, int]:
        """Wait for the result of a goal, log and return it with its status."""
        future = handle.get_result_async()
        await self.session.spin_until(future)
        result, status = future.result().result, future.result().status
        if status == GoalStatus.STATUS_SUCCEEDED:
            self.info(f"Goal succeeded! Result: {result.sequence}")
        else:
            self.info(f"Goal failed with {failure}: {status}")
        return result, status

    def _feedback(self, message: Any) -> None:
        self.info(f"Received feedback: {message.feedback.sequence}")


async def send_and_wait(session: Session, failure: str) -> int:
    """Send one goal, wait for its result."""
    goals = Goals(session, "minimal_action_client")
    try:
        handle = await goals.send()
        if handle is not None:
            await goals.result(handle, failure)
    except KeyboardInterrupt:
        return 0
    return 0


async def send_and_cancel(session: Session) -> int:
    """Send one goal and cancel it two seconds later."""
    goals = Goals(session, "minimal_action_client")
    try:
        handle = await goals.send()
        if handle is None:
            return 0
        await session.spin_until(Future(), SECONDS_TO_CANCEL)
        goals.info("Canceling goal")
        future = handle.cancel_goal_async()
        await session.spin_until(future)
    except KeyboardInterrupt:
        return 0
    goals.info("Goal successfully canceled" if future.result().goals_canceling else "Goal failed to cancel")
    return 0


async def send_four(session: Session) -> int:
    """Send two goals at the same time, then one, then another one."""
    goals = Goals(session, "minimal_action_client_asyncio")
    try:
        together = [handle for handle in (await goals.send(), await goals.send()) if handle is not None]
        finished = [await goals.result(handle) for handle in together]
        goals.info("unfinished: 0")
        for result, status in finished:
            goals.info(f"result {result} and status flag {status}")
        for letter in "AB":
            handle = await goals.send()
            if handle is not None:
                result, status = await goals.result(handle)
                goals.info(f"{letter}) result {result} and status flag {status}")
    except KeyboardInterrupt:
        return 0
    return 0
