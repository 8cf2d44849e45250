"""A small terminal of real pixels: reads text and pictures, and answers questions. It shares no code with the encoders."""

from __future__ import annotations

import io
import re
import zlib
from base64 import b64decode

import numpy as np
from PIL import Image
from rich.cells import cell_len

CELL = (10, 20)
TEXT = (1, 2, 3)
"""The colour of every cell that text was written to."""

_SEQUENCE = re.compile(
    r"\x1b_G(?P<kitty>[^\x1b]*)\x1b\\|\x1b_\x1b\\|\x1bP(?P<dcs>[^\x1b]*)\x1b\\|\x1b\](?P<osc>[^\x07\x1b]*)(?:\x07|\x1b\\)"
    r"|\x1b\[(?P<csi>[0-?]*[ -/]*[@-~])|\x1b(?P<esc>[78=>\\])"
    r"|\x1b(?=\x1b)|\x1b\[[0-?]*[ -/]*(?=\x1b)|\x1b(?:_G|P|\])[^\x1b\x07]*(?=\x1b[^\\])"  # cut off: the next one counts
)
ANSWERS = {
    "kitty": {">0q": "\x1bP>|kitty(0.26.5)\x1b\\", "16t": "\x1b[6;20;10t", "14t": "\x1b[4;480;800t", "c": "\x1b[?62;c"},
    "sixel": {">0q": "\x1bP>|XTerm(379)\x1b\\", "16t": "\x1b[6;20;10t", "c": "\x1b[?62;1;4;6;22c"},
    "iterm": {">0q": "\x1bP>|iTerm2 3.4.20\x1b\\", "16t": "\x1b[6;20;10t", "c": "\x1b[?62;4c"},
    "plain": {"c": "\x1b[?1;2c"},
}


class PixelTerminal:
    """`columns` x `rows` cells of `CELL` pixels; `kind` is what it can."""

    def __init__(self, kind: str, columns: int, rows: int) -> None:
        self.kind = kind
        self.size = columns, rows
        self.pixels = np.zeros((rows * CELL[1], columns * CELL[0], 3), np.uint8)
        self.images: dict[int, np.ndarray] = {}
        self.placements: dict[tuple[int, int], tuple[int, int, dict[str, int]]] = {}
        self.may_break = False
        """Whether a picture can be cut short: whoever draws it was killed."""
        self.pictures = 0
        """Pictures received."""
        self._chunks: tuple[dict[str, str], str] | None = None
        self._at = self._saved = (0, 0)
        self._rest = ""

    def feed(self, text: str) -> str:
        """Take what the program wrote; returns what the terminal answers."""
        text = self._rest + text
        answers, place = [], 0
        while place < len(text):
            found = _SEQUENCE.match(text, place)
            if found is None and text[place] == "\x1b":
                break  # the rest of it comes later
            if found is None:
                end = text.find("\x1b", place)
                end = len(text) if end < 0 else end
                self._write(text[place:end])
                place = end
                continue
            answers.append(self._take(found))
            place = found.end()
        self._rest = text[place:]
        return "".join(answers)

    def seen(self) -> np.ndarray:
        """Everything as it is on the screen."""
        screen = self.pixels.copy()
        for (number, _), (column, row, keys) in self.placements.items():
            x, y, w, h = (keys[key] for key in "xywh")
            part = Image.fromarray(self.images[number][y : y + h, x : x + w])
            width, height = keys["c"] * CELL[0], keys["r"] * CELL[1]
            self._put(screen, column, row, np.asarray(part.resize((width, height), Image.Resampling.NEAREST)))
        return screen

    def has(self, colour: tuple[int, int, int], near: int = 4) -> np.ndarray:
        """The cells (rows x columns) that have a pixel of about this colour."""
        off = np.abs(self.seen().astype(int) - colour).max(axis=2) <= near
        columns, rows = self.size
        return off.reshape(rows, CELL[1], columns, CELL[0]).any(axis=(1, 3))

    # -- what is written -----------------------------------------------------------------------------------------------

    def _write(self, text: str) -> None:
        column, row = self._at
        for char in text:
            if char == "\n":
                column, row = 0, row + 1
            elif char == "\r":
                column = 0
            elif char >= " ":
                width = cell_len(char)
                self.pixels[row * CELL[1] : (row + 1) * CELL[1], column * CELL[0] : (column + width) * CELL[0]] = TEXT
                column += width
        self._at = column, row

    def _take(self, found: re.Match[str]) -> str:
        if found["csi"] is not None:
            return self._control(found["csi"])
        if found["kitty"] is not None:
            return self._kitty(found["kitty"])
        if found["esc"] == "7":
            self._saved = self._at
        elif found["esc"] == "8":
            self._at = self._saved
        elif found["dcs"] is not None and "q" in found["dcs"]:
            self.pictures += 1
            picture, drawn = sixel_picture(found["dcs"])
            column, row = self._at
            height, width = drawn.shape
            part = self.pixels[row * CELL[1] : row * CELL[1] + height, column * CELL[0] : column * CELL[0] + width]
            part[drawn] = picture[drawn]
        elif found["osc"] is not None and found["osc"].startswith("1337;File="):
            self._inline(found["osc"])
        return ""

    def _control(self, text: str) -> str:
        if text.endswith("H"):
            row, _, column = text[:-1].partition(";")
            self._at = int(column or 1) - 1, int(row or 1) - 1
        elif text.endswith("G"):
            self._at = int(text[:-1] or 1) - 1, self._at[1]
        elif text == "5n":
            return "\x1b[0n"
        return ANSWERS[self.kind].get(text, "")

    def _inline(self, text: str) -> None:
        head, _, data = text.removeprefix("1337;File=").partition(":")
        keys = dict(pair.split("=") for pair in head.split(";"))
        assert int(keys["size"]) == len(b64decode(data))
        size = int(keys["width"]) * CELL[0], int(keys["height"]) * CELL[1]
        picture = Image.open(io.BytesIO(b64decode(data))).resize(size, Image.Resampling.NEAREST)
        self.pictures += 1
        self._put(self.pixels, *self._at, np.asarray(picture.convert("RGB")))

    def _put(self, screen: np.ndarray, column: int, row: int, picture: np.ndarray) -> None:
        height, width = picture.shape[:2]
        x, y = column * CELL[0], row * CELL[1]
        assert y + height <= screen.shape[0] and x + width <= screen.shape[1], "outside the screen"
        screen[y : y + height, x : x + width] = picture

    def _kitty(self, text: str) -> str:
        try:
            return self._graphics(text)
        except (KeyError, ValueError, zlib.error):
            assert self.may_break, text
            return ""  # cut short; Kitty takes no notice either

    def _graphics(self, text: str) -> str:
        head, _, data = text.partition(";")
        keys = dict(pair.split("=") for pair in head.split(","))
        if self._chunks is not None and "a" in keys:
            assert self.may_break, text
            self._chunks = None
        if self._chunks is not None:
            self._chunks = self._chunks[0], self._chunks[1] + data
            keys = {**self._chunks[0], "m": keys["m"]}
        elif keys.get("a") == "t":
            self._chunks = keys, data
        if keys.get("a") == "q":
            return f"\x1b_Gi={keys['i']};OK\x1b\\" if self.kind == "kitty" else ""
        if keys.get("a") == "t" and keys["m"] == "0":
            assert self._chunks is not None
            data, self._chunks = self._chunks[1], None
            raw = zlib.decompress(b64decode(data))
            shape = int(keys["v"]), int(keys["s"]), 3
            self.images[int(keys["i"])] = np.frombuffer(raw, np.uint8).reshape(shape)
            self.pictures += 1
        elif keys.get("a") == "p":
            numbers = {key: int(keys[key]) for key in "ipxywhcr"}
            if numbers["i"] not in self.images:
                raise ValueError("placed, but never sent")
            self.placements[numbers["i"], numbers["p"]] = (*self._at, numbers)
        elif keys.get("a") == "d":
            number = int(keys["i"])
            self.placements = {key: value for key, value in self.placements.items() if key[0] != number}
            if keys["d"] == "I":
                self.images.pop(number, None)
        return ""


def sixel_picture(text: str) -> tuple[np.ndarray, np.ndarray]:
    """The pixels of a Sixel sequence (what is between DCS and ST), and which of them were drawn."""
    body = text[text.index("q") + 1 :]
    size = re.match(r'"\d+;\d+;(\d+);(\d+)', body)
    assert size is not None
    width, height = int(size[1]), int(size[2])
    picture = np.zeros((height + 6, width, 3), np.uint8)
    drawn = np.zeros((height + 6, width), bool)
    colours: dict[int, tuple[int, ...]] = {}
    colour, x, y = 0, 0, 0
    for token in re.finditer(r"#(\d+)(?:;2;(\d+);(\d+);(\d+))?|!(\d+)([?-~])|([?-~])|([$-])", body[size.end() :]):
        if token[1] is not None:
            colour = int(token[1])
            if token[2] is not None:
                colours[colour] = tuple(round(int(part) * 255 / 100) for part in token.groups()[1:4])
        elif token[8] is not None:
            x, y = 0, y + (6 if token[8] == "-" else 0)
        else:
            count, char = (int(token[5]), token[6]) if token[5] is not None else (1, token[7])
            for row in range(6):
                if ord(char) - 63 >> row & 1:
                    picture[y + row, x : x + count] = colours[colour]
                    drawn[y + row, x : x + count] = True
            x += count
            assert x <= width
    return picture[:height], drawn[:height]
