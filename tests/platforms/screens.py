"""Screens other than a terminal: a tab of a browser, as far as that goes without one, and a terminal that shows real pixels."""

from __future__ import annotations

from codecs import getincrementaldecoder
from typing import Any

from tests.support.waiting import PATIENCE, until


class Pixels:
    """A terminal that answers as kitty does; what it is sent as pixels is seen as `a picture`."""

    def __init__(self, screen: Any) -> None:
        from tests.pixels.pixel_terminal import PixelTerminal

        self._screen, self._terminal = screen, PixelTerminal("kitty", 80, 24)
        self._decode, self._fed = getincrementaldecoder("utf-8")("replace").decode, 0
        self.send, self.quit, self.wait_end = screen.send, screen.quit, screen.wait_end

    def wait(self, *wanted: str, limit: float = PATIENCE) -> None:
        """Look until all of it is there."""
        until(
            lambda: set(wanted) <= {"a picture"} and self._terminal.pictures,
            limit,
            meanwhile=self._feed,
            told=self.look,
        )

    def look(self) -> str:
        """Return the screen's text."""
        return str(self._screen.look(0.02))

    def _feed(self) -> None:
        self.look()
        fresh, self._fed = bytes(self._screen.output[self._fed :]), len(self._screen.output)
        if answers := self._terminal.feed(self._decode(fresh)):
            self.send(answers)


class Page:
    """A tab of a browser that has opened the link of `day6-tui serve`."""

    status = 0

    def __init__(self, link: str) -> None:
        from tests.web.background import Background
        from tests.web.serving import browser

        self._background = Background()
        self._browser = browser(f"{link.partition('/p/')[0]}/")
        self._link = link

    def __enter__(self) -> Page:
        door = self._background.run(self._browser.__aenter__())
        status, page = self._background.run(door.get(self._link))
        assert status == 200, page
        self._tab = self._background.run(door.tab())
        return self

    def __exit__(self, *_: object) -> None:
        self._background.run(self._browser.__aexit__(None, None, None))
        self._background.close()

    def look(self) -> str:
        """Return the screen."""
        return str(self._tab.text())

    def wait(self, *wanted: str, limit: float = PATIENCE) -> None:
        """Wait until all of it is on the screen."""
        for each in wanted:
            self._background.run(self._tab.see(each), limit)

    def send(self, keys: str) -> None:
        """Type."""
        self._background.run(self._tab.type(keys))

    def quit(self) -> None:
        """Ctrl-Q, twice."""
        self.send("\x11\x11")

    def wait_end(self, limit: float = PATIENCE) -> int:
        """Wait until the desktop says that it has ended."""
        self._background.run(self._tab.end(), limit)
        return 0
