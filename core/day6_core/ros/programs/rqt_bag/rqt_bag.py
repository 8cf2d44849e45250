"""`ros2 run rqt_bag rqt_bag [--clock] [BAG…]`: a timeline of bags that plays, records and exports them.

Without a screen it prints what is in the bags (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from functools import partial

from day6_core.reason import reason
from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.rqt_bag.model.bags import Bags
from day6_core.ros.programs.rqt_bag.model.keeping import read_kept
from day6_core.ros.programs.rqt_bag.model.loading import is_bag
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.session.argument_parser import SessionParser
from day6_core.session.session import Session
from day6_core.session.threads import in_thread


class BagPlugin(Plugin[Bags]):
    """rqt_bag/Bag."""

    kind, title = "rqt_bag", "Bag"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, Bags(place.session, place.node, publish_clock=place.option("clock", False)))
        place.defer(self.model.close)
        self._named: list[str] = place.option("bagfiles", [])
        if self._named:
            for name in self._named:
                self.model.load(name)
        else:
            self.model.resume(read_kept(place.settings))

    @staticmethod
    def add_arguments(parser: SessionParser) -> None:
        def bag(name: str) -> str:
            if not is_bag(parser.session.path(name)):
                parser.error(f"'{name}' is not a valid rosbag")
            return name

        group = parser.add_argument_group("Options for rqt_bag plugin")
        group.add_argument("--clock", action="store_true", help="publish the clock time")
        group.add_argument("bagfiles", type=bag, nargs="*", default=[], help="Bagfiles to load")

    async def run(self) -> None:
        place, model = self.place, self.model
        for work in model.work:
            place.spawn(work())
        await model.serve()

    def settings(self) -> Settings:
        return self.model.kept().settings()

    async def without_screen(self) -> int | None:
        session = self.place.session
        if stays(session, self.place.node):
            session.spawn(session.spin(self.place.node))
            await self.run()
        return await _print(session, self._named)


async def _print(session: Session, names: list[str]) -> int:
    """Print what is in the bags, as `ros2 bag info` does."""
    from rosbag2_py._console import quiet
    from rosbag2_py._info import Info

    status, info = 0, Info(quiet)
    for name in names:
        path = str(session.path(name))
        try:
            session.print(await in_thread(partial(lambda path: info.text(info.read_metadata(path)), path)))
        except (RuntimeError, OSError) as error:
            session.print_error(f"Loading '{name}' failed due to: {reason(error)}")
            status = 1
    return status


async def main(session: Session) -> int | None:
    """Open the window and play until it is closed; without a display print what is in the bags once, or stay."""
    return await run_alone(session, BagPlugin)
