"""`ros2 run rqt_msg rqt_msg`: browses the types of messages."""

from __future__ import annotations

from typing import ClassVar

from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, run_alone
from day6_core.ros.programs.rqt_msg.model import TypeBrowser
from day6_core.session.session import Session
from day6_core.session.task import Signal


class MessageTypePlugin(Plugin[TypeBrowser]):
    """rqt_msg/Messages."""

    kind, title = "type_browser", "Message Type Browser"
    types: ClassVar[str] = "msg"
    """The kind of types that it browses."""

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, TypeBrowser(self.types))
        self.model.on_warning = place.session.print_error

    async def run(self) -> None:
        await self.place.session.wait(Signal())  # everything is the window's doing


async def main(session: Session) -> int | None:
    """Open the window until it is closed."""
    return await run_alone(session, MessageTypePlugin)
