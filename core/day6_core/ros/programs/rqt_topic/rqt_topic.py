"""`ros2 run rqt_topic rqt_topic`: lists all topics and listens to those that are ticked.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_topic.model import TopicMonitor
from day6_core.session.session import Session

STEP_SECONDS = 0.5
"""How often the numbers change: faster ones cannot be read."""

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""

SETTLE_SECONDS = 0.5
"""Without a window: how long to let the graph be discovered before it is printed."""


class TopicMonitorPlugin(Plugin[TopicMonitor]):
    """rqt_topic/TopicPlugin."""

    kind, title = "topics", "Topic Monitor"

    def __init__(self, place: PluginPlace) -> None:
        kept = place.settings.get("selected_topics")
        selected = [each for each in kept if isinstance(each, str)] if isinstance(kept, list) else []
        super().__init__(place, TopicMonitor(place.node, place.session.clock.now_ns, selected))
        self.model.on_request = place.wake

    async def run(self) -> None:
        self.model.refresh()
        self.place.spawn(self.place.repeat(self.model.tick, STEP_SECONDS, lambda: self.model.selected))
        await self.place.follow(self.model.handle_requests, REFRESH_SECONDS)

    def settings(self) -> Settings:
        return {"selected_topics": self.model.selected}

    def close(self) -> None:
        self.model.close()

    async def without_screen(self) -> int | None:
        session, node, model = self.place.session, self.place.node, self.model
        if stays(session, node):
            await session.spin(node)
            return 0
        await session.sleep(SETTLE_SECONDS)
        model.refresh()
        for topic in model.topics:
            session.print(f"{topic.name} [{', '.join(topic.types)}]")
        return 0


async def main(session: Session) -> int | None:
    """Open the window and follow the graph until interrupted; without a display print the topics once, or stay."""
    return await run_alone(session, TopicMonitorPlugin)
