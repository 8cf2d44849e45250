"""`ros2 run rqt_plot rqt_plot [FIELD…]`: listens to topics and draws numbers of their messages over time.

Without a screen it prints the newest values (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from day6_tui.core.ros.programs.rqt_gui.plugin import Place, Plugin, Settings, own_words, run_alone
from day6_tui.core.ros.programs.rqt_plot.model.plot import Plot
from day6_tui.core.session.session import Session

PRINT_SECONDS = 1.0
"""Without a window: how often the newest values are printed."""

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""

USAGE = "usage: rqt_plot [-h] [-e] [topic_and_field ...]"


class PlotPlugin(Plugin[Plot]):
    """rqt_plot/Plot."""

    kind, title = "rqt_plot", "MatPlot"

    def __init__(self, place: Place) -> None:
        super().__init__(place, Plot(place.node, place.session.clock.steady_ns))
        self.model.on_request = place.wake
        kept = place.settings.get("topics")
        words = [word for word in place.words if not word.startswith("-")]
        self.model.add_now(words or ([str(each) for each in kept] if isinstance(kept, list) else []))
        if self.model.message:
            place.session.print_error(self.model.message)

    async def run(self) -> None:
        await self.place.follow(self.model.handle_requests, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return {"topics": [curve.path for curve in self.model.curves]}

    async def without_screen(self) -> int | None:
        session = self.place.session
        session.spawn(self._print())
        session.spawn(session.spin(self.place.node))
        await self.run()
        return 0

    async def _print(self) -> None:
        async for _ in self.place.session.every(PRINT_SECONDS):
            values = [
                f"{curve.path}: {'-' if curve.last is None else format(curve.last, 'g')}" for curve in self.model.curves
            ]
            if values:
                self.place.session.print("  ".join(values))


async def main(session: Session) -> int | None:
    """Open the window and listen until interrupted; without a display print the values once a second."""
    if {"-h", "--help"} & set(own_words(session.argv)):
        session.print(f"{USAGE}\n\nPlots fields of topics over time, like /turtle1/pose/x, /turtle1/pose/x:y or ")
        session.print("/joint_states/position[0]. -e begins without what was plotted the last time (as always here).")
        return 0
    return await run_alone(session, PlotPlugin)
