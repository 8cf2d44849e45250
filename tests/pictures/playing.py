"""Plays a script in a real desktop on a pty, and draws what is seen."""

from __future__ import annotations

import io
import re
import tempfile
import time
from base64 import b64encode
from codecs import getincrementaldecoder
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from threading import Event
from typing import Any, NamedTuple

from PIL import Image, ImageChops, ImageFilter

from day6_core.shell.screen.rows import runs_of
from day6_core.shell.screen.screen import Screen
from day6_tui.cast import svg
from day6_tui.cast.film import Rows
from day6_tui.cast.recorder import picture_of
from tests.e2e.place import DAY6, Place
from tests.e2e.terminal import Terminal
from tests.pictures.script import Script, script
from tests.pixels.pixel_terminal import CELL, PixelTerminal
from tests.support.waiting import Deadline


class Frame(NamedTuple):
    """What is seen for some seconds: the cells, and what stands over them in real pixels (clear where nothing does)."""

    rows: Rows
    pixels: Image.Image
    seconds: float


FILMED = 0.1
"""Seconds between two pictures of a film that runs as fast as the world."""

CALM = 0.4
"""Seconds after which a screen that says nothing more is complete."""

UNMARKED_CALM = 2.0
"""The same before the first picture that is marked as whole."""

_ASKS, _TELLS = b"\x1b[?2026$p", "\x1b[?2026;2$y"
_WHOLE = b"\x1b[?2026l"
_KITTY = re.compile(rb"\x1b_G[^\x1b]*\x1b\\")
_FINE = 2
"""Pixels of a picture for one of the page: many screens have as many."""


class Camera(Terminal):
    """A terminal that is told where a whole picture ends (mode 2026, synchronized output), and so sees whole ones only.

    With `pixels` it shows Kitty's graphics.
    """

    def __init__(self, *words: Any, pixels: bool, **options: Any) -> None:
        super().__init__(*words, **options)
        kind = "kitty" if pixels else "plain"
        self._answering, self._over = (PixelTerminal(kind, self.columns, self.rows) for _ in range(2))
        self._cells = Screen(self.columns, self.rows)
        self._developed = 0
        """How much of the output is in the last picture."""
        self._decoder = getincrementaldecoder("utf-8")("replace")
        self._told = 0
        stream, self._stream = self._stream, self
        self._feed_text = stream.feed
        self._rest = b""

    def feed(self, data: bytes) -> None:
        """Take a piece of what the program writes; its pictures are nothing for `pyte`."""
        data = _KITTY.sub(b"", self._rest + data)
        cut = data.find(b"\x1b_G")
        self._rest = data[cut:] if cut >= 0 else b""
        self._feed_text(data[:cut] if cut >= 0 else data)

    def _take(self, seconds: float) -> None:
        super()._take(seconds)
        fresh, self._told = bytes(self.output[self._told :]), len(self.output)
        answers = self._answering.feed(self._decoder.decode(fresh)) + _TELLS * (_ASKS in fresh)
        if answers:
            self.send(_larger(answers))

    def frame(self, seconds: float = 0.0) -> Frame:
        """The first whole picture from now on, or what is there once nothing more is written.

        Small changes aren't marked, and a program that was slow to hear that it may mark its pictures has perhaps drawn all
        of them without.
        """
        start = last = len(self.output)
        calm = self._calm()
        while (marked := self.output.rfind(_WHOLE)) < start:
            self.look(0.01)
            if len(self.output) != last:
                last, calm = len(self.output), self._calm()
            elif calm.is_over():
                break
        end = marked if marked >= start else last
        fresh = bytes(self.output[self._developed : end]).decode("utf-8", "replace")
        self._developed = end
        self._cells.feed(picture_of(fresh))
        self._over.feed(fresh)
        rows = [runs_of(self._cells.row(y)) for y in range(self.rows)]
        return Frame(rows, _pixels(self._over), seconds)

    def _calm(self) -> Deadline:
        """What ends when nothing more is to be expected; later on a busy machine, where the program goes on later."""
        return Deadline(CALM if _WHOLE in self.output else UNMARKED_CALM)

    def film(self, seconds: float) -> Iterator[Frame]:
        """What is seen in so many seconds from now on."""
        began = at = time.monotonic()
        while at < began + seconds:
            self.look(FILMED)
            seen = self.frame()
            now = time.monotonic()
            yield seen._replace(seconds=now - at)
            at = now


def _larger(answers: str) -> str:
    """The terminal's answers, of one whose cells have more pixels."""
    cell = "\x1b[6;{};{}t"
    area = "\x1b[4;480;800t"
    return answers.replace(cell.format(CELL[1], CELL[0]), cell.format(CELL[1] * _FINE, CELL[0] * _FINE)).replace(
        area, ""
    )


def _pixels(terminal: PixelTerminal) -> Image.Image:
    """What pictures show on the terminal."""
    width, height = CELL[0] * _FINE, CELL[1] * _FINE
    whole = Image.new("RGBA", (terminal.size[0] * width, terminal.size[1] * height))
    for (number, _), (column, row, keys) in terminal.placements.items():
        x, y, w, h, columns, rows = (keys[key] for key in "xywhcr")
        part = Image.fromarray(terminal.images[number][y : y + h, x : x + w]).resize((columns * width, rows * height))
        whole.paste(part, (column * width, row * height))
    return whole


def _elements(pictures: Sequence[Image.Image]) -> Iterator[list[str]]:
    """Each picture as elements of SVG: one that is whole, and over it what has changed since, step by step.

    In a film nothing is lost: what hardly differs would leave traces.
    """
    elements: list[str] = []
    before: Image.Image | None = None
    for whole in pictures:
        if before is None or before.getchannel("A").tobytes() != whole.getchannel("A").tobytes():
            elements, patch = [], whole
        else:
            changed = ImageChops.difference(before.convert("RGB"), whole.convert("RGB")).point(
                lambda by: 255 * (by > 0)
            )
            # A little more than that: scaled, the edge of a patch is half clear.
            around = changed.convert("L").point(lambda by: 255 * (by > 0)).filter(ImageFilter.MaxFilter(5))
            patch = whole.copy()
            patch.putalpha(ImageChops.darker(around, whole.getchannel("A")))
        elements = [*elements, *_element(patch, lossless=len(pictures) > 1)]
        before = whole
        yield elements


def _element(picture: Image.Image, *, lossless: bool) -> Iterator[str]:
    """A picture as an element in units of `svg.CELL`; nothing where it is clear."""
    if box := picture.getchannel("A").getbbox():
        data = io.BytesIO()
        picture.crop(box).save(data, "WEBP", lossless=lossless, quality=85, method=6)
        unit = CELL[0] * _FINE / svg.CELL[0]
        left, top, right, bottom = (place / unit for place in box)
        place = f'x="{left:g}" y="{top:g}" width="{right - left:g}" height="{bottom - top:g}"'
        yield f'<image {place} href="data:image/webp;base64,{b64encode(data.getvalue()).decode()}"/>\n'


@cache
def frames_of(name: str, lang: str) -> list[Frame]:
    """Play a script to its end, or take what others have shot for a film. Raises AssertionError if one doesn't get there."""
    told = script(name, lang)
    if told.films:
        return [frame for film in told.films for frame in frames_of(film, lang) if frame.seconds]
    over = Event()
    with ThreadPoolExecutor(max(1, len(told.others))) as pool:
        others = [pool.submit(_play, other, over) for other in told.others]
        try:
            return _play(told)
        finally:
            over.set()
            for other in others:
                other.result()


def _play(told: Script, over: Event | None = None) -> list[Frame]:
    """Play one script in a place of its own; with `over`, its desktop stays until then."""
    with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
        place = Place(Path(folder))
        try:
            return list(_played(told, place, over))
        finally:
            place.close()


def drawn(name: str, lang: str) -> str:
    """The picture as SVG: a film, or the last thing seen."""
    told, frames = script(name, lang), frames_of(name, lang)
    shown = frames if told.films else frames[-1:]
    over = list(_elements([frame.pixels for frame in shown]))
    return svg.picture([frame.rows for frame in shown], told.size, [frame.seconds for frame in shown], told.title, over)


def _played(told: Script, place: Place, over: Event | None) -> Iterator[Frame]:
    for name, text in told.files:
        path = place.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    command = [*DAY6, *told.options, "--home", str(place.home), "--lang", told.lang]
    variables = place.environment(DAY6_LINK="on")
    with Camera(command, *told.size, cwd=place.work, env=variables, pixels="pixels" in told.options) as screen:
        for does, what in told.steps:
            if does == "shot":
                yield screen.frame(what)
            elif does == "film":
                yield from screen.film(what)
            else:
                _do(screen, does, what)
        yield screen.frame()
        while over is not None and not over.is_set():
            screen.look(0.05)
        screen.quit()
        screen.wait_end()


def _do(screen: Terminal, does: str, what: Any) -> None:
    texts = what if isinstance(what, list) else [what]
    if does == "wait":
        screen.wait(*map(_condition, texts))
    elif does == "gone":
        screen.wait_gone(*texts)
    elif does == "press":
        screen.press(*what.split())
    else:
        screen.line(what)


def _condition(text: str) -> str | Callable[[str], Any]:
    """A text, or a regular expression between slashes."""
    found = re.fullmatch("/(.+)/", text)
    return re.compile(found[1]).search if found else text
