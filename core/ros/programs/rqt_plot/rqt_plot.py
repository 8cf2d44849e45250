"""`ros2 run rqt_plot rqt_plot [FIELD…]`: a node that listens to topics and draws numbers of their messages over time.

Without a screen it prints the newest values (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from day6_tui.core.graph import GraphEvent
from day6_tui.core.ros.programs.rqt_plot.model.plot import Plot
from day6_tui.core.session.session import Session
from day6_tui.core.session.task import Signal

PRINT_SECONDS = 1.0
"""Without a window: how often the newest values are printed."""

USAGE = "usage: rqt_plot [-h] [-e] [topic_and_field ...]"


async def main(session: Session) -> int | None:
    """Open the window and listen until interrupted; without a display print the values once a second."""
    words = _fields(session)
    if words is None:
        session.print(f"{USAGE}\n\nPlots fields of topics over time, like /turtle1/pose/x, /turtle1/pose/x:y or ")
        session.print("/joint_states/position[0]. -e begins without what was plotted the last time (as always here).")
        return 0
    graph = session.graph
    assert graph is not None
    node = session.create_node(f"rqt_gui_py_node_{session.pid}")
    plot = Plot(node, session.clock.steady_ns)
    changed = Signal()

    def on_change(event: GraphEvent) -> None:
        changed.set()

    session.defer(graph.add_listener(on_change))
    plot.on_request = changed.set
    plot.add_now(words)
    if plot.message:
        session.print_error(plot.message)
    if session.display is None:
        session.spawn(_print(session, plot))
    else:
        session.display.open("rqt_plot", "MatPlot", plot)
    session.spawn(session.spin(node))
    while True:
        await session.wait(changed)
        changed.clear()
        plot.handle_requests()
        await session.sleep(0.1)


def _fields(session: Session) -> list[str] | None:
    """The fields of the command line; None if it asks for help."""
    words = session.argv[1:]
    if "--ros-args" in words:
        words = words[: words.index("--ros-args")]
    if "-h" in words or "--help" in words:
        return None
    return [word for word in words if not word.startswith("-")]


async def _print(session: Session, plot: Plot) -> None:
    async for _ in session.every(PRINT_SECONDS):
        values = [f"{curve.path}: {'-' if curve.last is None else format(curve.last, 'g')}" for curve in plot.curves]
        if values:
            session.print("  ".join(values))
