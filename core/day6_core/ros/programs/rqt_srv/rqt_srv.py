"""`ros2 run rqt_srv rqt_srv`: browses the types of services."""

from __future__ import annotations

from day6_core.ros.programs.rqt_gui.plugin import run_alone
from day6_core.ros.programs.rqt_msg.rqt_msg import MessageTypePlugin
from day6_core.session.session import Session


class ServiceTypePlugin(MessageTypePlugin):
    """rqt_srv/Services."""

    title = "Service Type Browser"
    types = "srv"


async def main(session: Session) -> int | None:
    """Open the window until it is closed."""
    return await run_alone(session, ServiceTypePlugin)
