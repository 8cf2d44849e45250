"""client_async_member_function: requests the sum of 41 and 1 once, in the original with a class that is a node."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.examples_rclpy_minimal_client._ask import ask

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await ask(session, "minimal_client_async")
