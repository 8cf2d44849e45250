"""`ros2 run rqt_publisher rqt_publisher`: publishes messages whose fields are expressions, at given rates or once."""

from __future__ import annotations

from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_publisher.model import MessagePublisher
from day6_core.session.session import Session

REFRESH_SECONDS = 0.05
"""At most this often are requests of the window carried out."""


class PublisherPlugin(Plugin[MessagePublisher]):
    """rqt_publisher/Publisher."""

    kind, title = "publisher", "Message Publisher"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, MessagePublisher(place.node))
        self.model.on_request = place.wake
        self.model.on_warning = place.session.print_error
        kept = place.settings.get("publishers")
        if isinstance(kept, str):
            self.model.take_kept(kept)

    async def run(self) -> None:
        await self.place.follow(self.model.handle, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return {"publishers": self.model.kept()}


async def main(session: Session) -> int | None:
    """Open the window and publish until it is closed."""
    return await run_alone(session, PublisherPlugin)
