"""`rqt_graph`: a node that looks at the graph and shows it in a window, or as text where there is no screen.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

import textwrap

from day6_tui.core.graph import GraphEvent
from day6_tui.core.ros.programs._without_screen import stays
from day6_tui.core.ros.programs.rqt_graph.model.drawing import ASCII, UNICODE, draw
from day6_tui.core.ros.programs.rqt_graph.model.fit import fitted
from day6_tui.core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from day6_tui.core.session.session import Session
from day6_tui.core.session.task import Signal

REFRESH_SECONDS = 0.2
"""At most this often is the graph looked at again while it changes."""

SETTLE_SECONDS = 0.5
"""Without a window: how long to let the graph be discovered before it is printed."""


async def main(session: Session) -> int | None:
    """Open the window and follow the graph until interrupted; without a display print the graph once, or stay."""
    graph = session.graph
    assert graph is not None
    node = session.create_node(f"rqt_gui_py_node_{session.pid}")
    model = RqtGraph(node, graph, session.cwd)
    if session.display is None and stays(session, node):
        await session.spin(node)
        return 0
    if session.display is None:
        await session.sleep(SETTLE_SECONDS)
        model.refresh()
        _print(session, model)
        return 0
    changed = Signal()

    def on_change(event: GraphEvent) -> None:
        if model.auto_refresh:
            changed.set()

    session.defer(graph.add_listener(on_change))
    model.on_request = changed.set
    model.refresh()
    session.display.open("rqt_graph", "rqt_graph", model)
    session.spawn(session.spin(node))
    while True:
        await session.wait(changed)
        changed.clear()
        model.refresh()
        await session.sleep(REFRESH_SECONDS)


def _print(session: Session, model: RqtGraph) -> None:
    encoding = (session.stdout.encoding or "ascii").lower()
    glyphs = UNICODE if encoding.startswith("utf") else ASCII
    picture = fitted(model.content.boxes, model.content.edges, session.stdout.columns, 1000)
    for row in draw(picture, glyphs, model.content.trouble).rows():
        session.print("".join(text for text, _ in row).rstrip())
    hidden = model.content.hidden
    if hidden:
        reasons = "; ".join(f"{each.option} hides {', '.join(each.names)}" for each in hidden)
        summary = f"{sum(len(each.names) for each in hidden)} hidden: {reasons}"
        for line in textwrap.wrap(summary, session.stdout.columns, break_long_words=False, break_on_hyphens=False):
            session.print(line)
