"""`ros2 run day6_inspector inspector`: shows what is wrong with the graph, in a window or, without a screen, once as text."""

from __future__ import annotations

from day6_tui.core.link import state_of
from day6_tui.core.link.state import LinkState
from day6_tui.core.ros.programs.day6_inspector.model import Inspector
from day6_tui.core.ros.remark_texts import TEXTS
from day6_tui.core.session.session import Session

LOOK_SECONDS = 0.5
SETTLE_SECONDS = 1.5
"""Without a window: how long to listen before the findings are printed."""


async def main(session: Session) -> int | None:
    """Watch until interrupted; without a display print the findings and end with 1 if there are errors."""
    node = session.create_node(f"_day6_inspector_{session.pid}", start_parameter_services=False)
    graph = session.graph
    model = Inspector(node, session.clock, (lambda: state_of(graph)) if graph is not None else LinkState)
    session.spawn(session.spin(node))
    if session.display is None:
        for _ in range(3):
            await session.sleep(SETTLE_SECONDS / 3)
            model.refresh()
        for finding in model.findings:
            session.print(f"{finding.level}: {finding.text}")
        if not model.findings:
            session.print(TEXTS["inspector.well"])
        return 1 if any(finding.level == "error" for finding in model.findings) else 0
    model.refresh()
    session.display.open("inspector", "Inspector", model)
    async for _ in session.every(LOOK_SECONDS):
        model.refresh()
    return 0
