"""`ros2 run rqt_console rqt_console`: a node that listens to /rosout and shows it in a window.

Without a screen it prints what comes (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from rcl_interfaces.msg import Log

from day6_tui.core.ros.programs.rqt_console.model import Console
from day6_tui.core.session.session import Session

DEPTH = 1000


async def main(session: Session) -> int | None:
    """Open the window and listen until interrupted; without a display print the messages one by one."""
    node = session.create_node(f"rqt_gui_py_node_{session.pid}")
    console = Console()

    def show(log: Log) -> None:
        console.receive(log)
        if session.display is None:
            record = console.shown()[-1]
            session.print(f"#{record.number} {record.severity} [{record.node}]: {record.text}")

    node.create_subscription(Log, "/rosout", show, DEPTH)
    if session.display is not None:
        session.display.open("rqt_console", "Console", console)
    await session.spin(node)
    return 0
