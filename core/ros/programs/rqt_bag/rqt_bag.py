"""`ros2 run rqt_bag rqt_bag [--clock] [BAG…]`: a timeline of bags that plays, records and exports them.

Without a screen it prints what is in the bags (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from pathlib import Path

from day6_tui.core.ros.programs._without_screen import stays
from day6_tui.core.ros.programs.rqt_bag.model.bags import Bags
from day6_tui.core.ros.programs.rqt_bag.model.loading import is_bag
from day6_tui.core.ros.programs.rqt_gui.plugin import Place, Plugin, own_words, run_alone
from day6_tui.core.session.session import Session

USAGE = "usage: rqt_bag [-h] [--clock] [bagfiles ...]"

HELP = f"""{USAGE}

Options for rqt_bag plugin:
  --clock     publish the clock time
  bagfiles    Bagfiles to load"""


class BagPlugin(Plugin[Bags]):
    """rqt_bag/Bag."""

    kind, title = "rqt_bag", "Bag"

    def __init__(self, place: Place) -> None:
        super().__init__(place, Bags(place.session, place.node, publish_clock="--clock" in place.words))
        place.defer(self.model.close)
        for word in place.words:
            if not word.startswith("-"):
                self.model.load(word)

    async def run(self) -> None:
        place, model = self.place, self.model
        for work in model.work:
            place.spawn(work())
        await model.serve()

    async def without_screen(self) -> int | None:
        session = self.place.session
        if stays(session, self.place.node):
            session.spawn(session.spin(self.place.node))
            await self.run()
        return await _print(session, self.place.words)


async def _print(session: Session, words: list[str]) -> int:
    """Print what is in the bags, as `ros2 bag info` does."""
    from rosbag2_py._info import Info

    from day6_tui.core.session.threads import in_thread

    status = 0
    for word in words:
        if word.startswith("-"):
            continue
        path = Path(session.cwd, word)
        try:
            text = await in_thread(lambda path=path: Info().text(Info().read_metadata(str(path), "")))  # type: ignore[misc]
            session.print(text)
        except (RuntimeError, OSError) as error:
            session.print_error(f"Loading '{word}' failed due to: {error}")
            status = 1
    return status


async def main(session: Session) -> int | None:
    """Open the window and play until it is closed; without a display print what is in the bags once, or stay."""
    words = own_words(session.argv)
    if {"-h", "--help"} & set(words):
        session.print(HELP)
        return 0
    for word in words:
        if word.startswith("-") and word != "--clock":
            session.print_error(f"{USAGE}\nrqt_bag: error: unrecognized arguments: {word}")
            return 2
        if not word.startswith("-") and not is_bag(Path(session.cwd, word)):
            session.print_error(f"{USAGE}\nrqt_bag: error: '{word}' is not a valid rosbag")
            return 2
    return await run_alone(session, BagPlugin)
