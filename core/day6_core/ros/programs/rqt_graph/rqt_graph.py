"""`rqt_graph`: looks at the graph and shows it in a window, or as text where there is no screen.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

import textwrap

from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.rqt_graph.model.drawing import ASCII, UNICODE, draw
from day6_core.ros.programs.rqt_graph.model.fit import fitted
from day6_core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, run_alone
from day6_core.session.session import Session

REFRESH_SECONDS = 0.2
"""At most this often is the graph looked at again while it changes."""

SETTLE_SECONDS = 0.5
"""Without a window: how long to let the graph be discovered before it is printed."""


class RosGraphPlugin(Plugin[RqtGraph]):
    """rqt_graph/RosGraph."""

    kind, title = "rqt_graph", "rqt_graph"

    def __init__(self, place: PluginPlace) -> None:
        session = place.session
        assert session.graph is not None
        super().__init__(place, RqtGraph(place.node, session.graph, session.path))
        self.model.on_request = self._asked
        self._wanted = True

    def _asked(self) -> None:
        self._wanted = True
        self.place.wake()

    async def run(self) -> None:
        await self.place.follow(self._look, REFRESH_SECONDS)

    def _look(self) -> None:
        if self._wanted or self.model.auto_refresh:
            self._wanted = False
            self.model.refresh()

    async def without_screen(self) -> int | None:
        session, node = self.place.session, self.place.node
        if stays(session, node):
            await session.spin(node)
            return 0
        await session.sleep(SETTLE_SECONDS)
        self.model.refresh()
        _print(session, self.model)
        return 0


async def main(session: Session) -> int | None:
    """Open the window and follow the graph until interrupted; without a display print the graph once, or stay."""
    return await run_alone(session, RosGraphPlugin)


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
