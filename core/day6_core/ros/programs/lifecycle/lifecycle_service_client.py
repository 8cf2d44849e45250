"""lifecycle_service_client: leads lc_talker through all its states, with ten seconds between two transitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState

from day6_core.ros.programs._component import ready
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session

TALKER = "lc_talker"
PATIENCE = 3.0
BETWEEN = 10.0
LIFE = (
    Transition.TRANSITION_CONFIGURE,
    Transition.TRANSITION_ACTIVATE,
    Transition.TRANSITION_DEACTIVATE,
    Transition.TRANSITION_ACTIVATE,
    Transition.TRANSITION_DEACTIVATE,
    Transition.TRANSITION_CLEANUP,
    Transition.TRANSITION_UNCONFIGURED_SHUTDOWN,
)


class Leader:
    """Asks for the changes and for the state after each."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.node = create_node(session, "lc_client")
        self._get = self.node.create_client(GetState, f"{TALKER}/get_state")
        self._change = self.node.create_client(ChangeState, f"{TALKER}/change_state")
        session.executor.add_node(self.node)

    async def change_state(self, transition: int) -> bool:
        request = ChangeState.Request()
        request.transition.id = transition
        response = await self._call(self._change, request)
        if response is None:
            return False
        if response.success:
            self.node.get_logger().info(f"Transition {transition} successfully triggered.")
        else:
            self.node.get_logger().warning(f"Failed to trigger transition {transition}")
        return bool(response.success)

    async def get_state(self) -> bool:
        response = await self._call(self._get, GetState.Request())
        if response is None:
            return False
        self.node.get_logger().info(f"Node {TALKER} has current state {response.current_state.label}.")
        return True

    async def _call(self, client: Any, request: Any) -> Any:
        logger = self.node.get_logger()
        if not await ready(self.session, client.service_is_ready, PATIENCE):
            logger.error(f"Service {client.service_name} is not available.")
            return None
        future = client.call_async(request)
        if not await self.session.spin_until(future, PATIENCE):
            logger.error(f"Server time out while getting current state for node {TALKER}")
            return None
        return future.result()


async def main(session: Session) -> int:
    leader = Leader(session)
    try:
        for number, transition in enumerate(LIFE):
            if number:
                await session.spin_until(Future(), BETWEEN)
            if not (await leader.change_state(transition) and await leader.get_state()):
                return 0
    except STOPPED:
        log_interrupt(session)
    return 0
