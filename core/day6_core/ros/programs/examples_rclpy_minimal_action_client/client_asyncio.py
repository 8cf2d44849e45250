"""client_asyncio: sends two goals at the same time, then two one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_action_client._goals import send_four

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await send_four(session)
