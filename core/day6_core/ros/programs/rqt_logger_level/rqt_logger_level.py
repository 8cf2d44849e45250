"""`ros2 run rqt_logger_level rqt_logger_level`: shows and sets the log levels of nodes.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_logger_level.model import LoggerLevels
from day6_core.session.session import Session

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""


class LoggerLevelPlugin(Plugin[LoggerLevels]):
    """rqt_logger_level/LoggerLevel."""

    kind, title = "rqt_logger_level", "Logger Level"

    def __init__(self, place: PluginPlace) -> None:
        node = place.settings.get("node")
        chosen = node if isinstance(node, str) else ""
        super().__init__(place, LoggerLevels(place.node, place.session.clock.steady_ns, chosen))

    async def run(self) -> None:
        self.place.serve(self.model)
        self.place.spawn(self.place.repeat(self.model.tick, 1.0, lambda: self.model.waited is not None))
        await self.place.follow(self.model.refresh, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return {"node": self.model.node}


async def main(session: Session) -> int | None:
    """Open the window and follow the graph until interrupted."""
    return await run_alone(session, LoggerLevelPlugin)
