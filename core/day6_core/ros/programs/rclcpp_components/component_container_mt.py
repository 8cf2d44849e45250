"""component_container_mt: a container, in real ROS with several threads; here nodes take turns on one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.rclcpp_components.component_manager import run_container

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await run_container(session)
