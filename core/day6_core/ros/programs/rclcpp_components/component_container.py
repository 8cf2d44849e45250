"""component_container: a container, one thread for all its nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.rclcpp_components.component_manager import run_container

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await run_container(session)
