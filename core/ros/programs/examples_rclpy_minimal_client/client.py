"""client: asks once what 41 + 1 is, in the original written as a client which waits for the answer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs.examples_rclpy_minimal_client._ask import ask

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session


async def main(session: Session) -> int:
    return await ask(session, "minimal_client")
