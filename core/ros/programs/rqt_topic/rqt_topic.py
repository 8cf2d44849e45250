"""`ros2 run rqt_topic rqt_topic`: a node that lists all topics and listens to those that are ticked.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from day6_tui.core.graph import GraphEvent
from day6_tui.core.ros.programs._without_screen import stays
from day6_tui.core.ros.programs.rqt_topic.model import TopicMonitor
from day6_tui.core.session.session import Session
from day6_tui.core.session.task import Signal

STEP_SECONDS = 0.5
"""How often the numbers change: faster ones cannot be read."""

SETTLE_SECONDS = 0.5
"""Without a window: how long to let the graph be discovered before it is printed."""


async def main(session: Session) -> int | None:
    """Open the window and follow the graph until interrupted; without a display print the topics once, or stay."""
    graph = session.graph
    assert graph is not None
    node = session.create_node(f"rqt_gui_py_node_{session.pid}")
    model = TopicMonitor(node)
    if session.display is None and stays(session, node):
        await session.spin(node)
        return 0
    if session.display is None:
        await session.sleep(SETTLE_SECONDS)
        model.refresh()
        for topic in model.topics:
            session.print(f"{topic.name} [{', '.join(topic.types)}]")
        return 0
    changed = Signal()

    def on_change(event: GraphEvent) -> None:
        changed.set()

    session.defer(graph.add_listener(on_change))
    model.on_request = changed.set
    model.refresh()
    session.display.open("topics", "Topic Monitor", model)
    session.spawn(session.spin(node))
    session.spawn(_step(session, model))
    while True:
        await session.wait(changed)
        changed.clear()
        model.handle_requests()
        await session.sleep(0.1)


async def _step(session: Session, model: TopicMonitor) -> None:
    async for _ in session.every(STEP_SECONDS):
        if model.listening:
            model.tick()
