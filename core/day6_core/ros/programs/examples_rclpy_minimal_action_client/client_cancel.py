"""client_cancel: sends a goal and cancels it two seconds later."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_action_client._goals import send_and_cancel

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await send_and_cancel(session)
