"""`ros2 run rqt_plot rqt_plot [FIELD…]`: listens to topics and draws numbers of their messages over time.

Without a screen it prints the newest values (see `programs/_without_screen.py`).
"""

from __future__ import annotations

import argparse

from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_plot.model.plot import Plot
from day6_core.session.argument_parser import SessionParser
from day6_core.session.session import Session

PRINT_SECONDS = 1.0
"""Without a window: how often the newest values are printed."""

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""


class PlotPlugin(Plugin[Plot]):
    """rqt_plot/Plot."""

    kind, title = "rqt_plot", "MatPlot"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, Plot(place.node, place.session.clock.steady_ns))
        self.model.on_request = place.wake
        kept = place.settings.get("topics")
        named: list[str] = place.option("topics", [])
        self.model.add_now(named or ([str(each) for each in kept] if isinstance(kept, list) else []))
        if place.option("start_paused", False):
            self.model.toggle_paused()
        if self.model.message:
            place.session.print_error(self.model.message)

    @staticmethod
    def add_arguments(parser: SessionParser) -> None:
        group = parser.add_argument_group("Options for rqt_plot plugin")
        group.add_argument("-P", "--pause", action="store_true", dest="start_paused", help="Start in paused state")
        group.add_argument("-e", "--empty", action="store_true", help=argparse.SUPPRESS)  # here it begins so always
        group.add_argument("topics", nargs="*", default=[], help="Topics to plot")

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
    return await run_alone(session, PlotPlugin)
