"""`ros2 run rqt_console rqt_console`: listens to /rosout and shows it in a window.

Without a screen it prints what comes (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from pathlib import Path

from rcl_interfaces.msg import Log

from day6_core.reason import reason
from day6_core.ros.programs.rqt_console.kept import kept_settings, take_settings
from day6_core.ros.programs.rqt_console.model import Console
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.session.session import Session
from day6_core.session.task import Signal
from rclpy.qos import DurabilityPolicy, QoSProfile

EAR = QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL)
"""As in rqt_console what was logged just before is heard, too; its depth of 10 would lose messages."""


class ConsolePlugin(Plugin[Console]):
    """rqt_console/Console."""

    kind, title = "rqt_console", "Console"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, Console(place.session.path))
        self.model.on_load = lambda path: place.spawn(self._load(path))
        take_settings(self.model, place.settings)
        self._subscription = place.node.create_subscription(Log, "/rosout", self.model.receive, EAR)

    async def run(self) -> None:
        self.place.serve(self.model)
        await self.place.session.wait(Signal())  # it only listens

    async def _load(self, path: Path) -> None:
        from day6_core.ros.programs.rqt_console.files import SKIPPED, loaded

        try:
            records, skipped = await loaded(path)
        except (OSError, ValueError) as error:
            self.model.tell(reason(error))
            return
        self.model.take_loaded(records)
        self.model.tell(str(path))
        if skipped:
            message = SKIPPED.format(count=len(skipped), reasons="\n- ".join(skipped[:10]))
            self.place.session.print_error(message)
            self.model.tell(" ".join(message.split()))

    def settings(self) -> Settings:
        return kept_settings(self.model)

    def close(self) -> None:
        self.place.node.destroy_subscription(self._subscription)

    async def without_screen(self) -> int | None:
        session, node = self.place.session, self.place.node
        self.close()

        def show(log: Log) -> None:
            self.model.receive(log)
            record = self.model.shown()[-1]
            session.print(f"#{record.number} {record.severity} [{record.node}]: {record.text}")

        node.create_subscription(Log, "/rosout", show, EAR)
        await session.spin(node)
        return 0


async def main(session: Session) -> int | None:
    """Open the window and listen until interrupted; without a display print the messages one by one."""
    return await run_alone(session, ConsolePlugin)
