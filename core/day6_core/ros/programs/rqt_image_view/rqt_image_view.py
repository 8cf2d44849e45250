"""`ros2 run rqt_image_view rqt_image_view [TOPIC]`: shows the images of a topic.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from day6_core.graph.names import flaw_of_full_topic_name
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_image_view.decoding import ImageRequest
from day6_core.ros.programs.rqt_image_view.model import ImageView
from day6_core.session.argument_parser import SessionParser
from day6_core.session.session import Session
from day6_core.session.task import Signal

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""

IMAGE_SECONDS = 0.1
"""At most this often does an image have the window drawn anew."""


class ImageViewPlugin(Plugin[ImageView]):
    """rqt_image_view/ImageView."""

    kind, title, in_cpp = "rqt_image_view", "Image View", True

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, ImageView(place.node, place.session.path))
        kept = place.settings.get("topic")
        topic: str = place.option("topic", None) or (kept if isinstance(kept, str) else "")
        topic = topic if not topic or topic.startswith("/") else f"/{topic}"
        if topic and flaw_of_full_topic_name(topic) is None:
            self.model.topic = topic
        self._restore(place.settings)

    @staticmethod
    def add_arguments(parser: SessionParser) -> None:
        group = parser.add_argument_group("Options for rqt_image_view plugin")
        group.add_argument("topic", nargs="?", help="The topic name to subscribe to")

    def _restore(self, kept: Settings) -> None:
        """Show images as the perspective says."""
        most, turns = kept.get("max_range"), kept.get("rotate")
        self.model.publishes_clicks = kept.get("publish_click_location") is True
        self.model.view = ImageRequest(
            0,
            0,
            zoom_1=kept.get("zoom1") is True,
            rotation=turns % 4 if isinstance(turns, int) else 0,
            dynamic_range=kept.get("dynamic_range") is True,
            max_range=most if isinstance(most, float) and 0.01 <= most <= 100.0 else ImageRequest.max_range,
        )

    async def run(self) -> None:
        self.place.serve(self.model)
        self.place.spawn(self._wake_window())
        await self.place.follow(self.model.refresh, REFRESH_SECONDS)

    async def _wake_window(self) -> None:
        """Images come on other threads, and a window is drawn when something has run on this one."""
        session, come = self.place.session, Signal()
        self.model.on_image = come.set
        while True:
            await session.wait(come)
            come.clear()
            await session.sleep(IMAGE_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        view = self.model.view
        return {
            "topic": self.model.topic,
            "publish_click_location": self.model.publishes_clicks,
            "zoom1": view.zoom_1,
            "rotate": view.rotation,
            "dynamic_range": view.dynamic_range,
            "max_range": view.max_range,
        }


async def main(session: Session) -> int | None:
    """Open the window and listen until interrupted."""
    return await run_alone(session, ImageViewPlugin)
