"""Texts that an attacker would put into names, logs and files, and a strict reader of what reaches the user's terminal."""

from __future__ import annotations

import re

MARK = "^[]0;T"
"""How the beginning of `HOSTILE` looks on the screen."""

SEQUENCES = {
    "title": "\x1b]0;T\x07",
    "clipboard": "\x1b]52;c;b3duZWQ=\x07",
    "link": "\x1b]8;;http://x/\x1b\\x\x1b]8;;\x1b\\",
    "DCS": "\x1bP1$r0m\x1b\\",
    "APC": "\x1b_Gi=1;AAAA\x1b\\",
    "PM": "\x1b^pm\x1b\\",
    "SOS": "\x1bXsos\x1b\\",
    "clear": "\x1b[2J\x1b[H",
    "reset": "\x1bc",
    "where": "\x1b[6n\x1b[c\x1b[>q\x05",
    "print": "\x1b[5i",
    "C1": "\x9d0;T\x9c\x9b2J\x90q\x9c\x85",
    "bell, back, delete": "\x07\b\x7f\x0b\x0c\x0e\x0f\x18\x1a",
    "directions": "\u202e\u2066\u2069\u200e\u200f\u061c",
    "lines": "\u2028\u2029\r",
    "unseen": "\u200b\ufeff\u2060\xad\U000e0041\uffff\U0010eeee",
    "markup": "[@click=app.quit]q[/][link=http://x]l[/link]",
}
HOSTILE = "".join(SEQUENCES.values())
IN_A_NAME = HOSTILE.replace("/", "|").replace("\0", "")
"""The same for the name of a file."""
SHORT = "\x1b]0;T\x07\x9b2J\u202e\u2028[@click=app.quit]"
"""Where 255 bytes are the limit."""

_TEXT = re.compile(
    "[^\x00-\x1f\x7f-\x9f\xad\u061c\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\ufffe\uffff\ud800-\udfff"
    "\U000e0000-\U000e007f\U00100000-\U0010ffff]+"
)
_COLOUR = re.compile(r"\x1b\[[0-9;]*m")
_OF_THE_DESKTOP = re.compile(
    r"\x1b\[(?:[0-9]+;[0-9]+H|[0-9]+G|[0-9]+X"  # a place, and blanks
    r"|\?(?:25|1000|1003|1004|1006|1015|1049|2004|2026|2048|7)[hl]"  # modes: cursor, mouse, focus, screen, paste, at once
    r"|\?(?:2026|2048)\$p|>[0-9]+u|<u|\?u"  # what Textual asks a terminal at its start, and its keys
    r"|>0q|16t|14t|c"  # whether it shows pictures
    r"|5n"  # how far it has read
    r"|[HJ]|2J|0?K)"
    r"|\x1b]22;[a-z-]*\x07"  # the shape of the mouse's pointer
    r"|\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\"  # whether it shows pictures of kitty
)
_OF_A_COMMAND = re.compile(
    "[\n\t]|\r\n"
    "|\r +\r+"  # colcon wipes its status line
    "|\x1b]0;colcon [a-z]+ \\[[0-9]+/[0-9]+ done] \\[[0-9]+ ongoing]\x07"  # and names the window after it
)


_CUT = re.compile(rb"(?:\x1b(?:\[[\d;?]*)?|[\xc0-\xff][\x80-\xbf]{0,3})\Z")


def whole(data: bytes) -> bytes:
    """The output of a program that still runs, without a sequence or character that was only begun when it was read."""
    return _CUT.sub(b"", data)


def foreign(data: bytes, *, desktop: bool) -> list[str]:
    """What is in the stream beside text, colours, ends of lines and, of the desktop, its own sequences; [] if all is well."""
    text = data.decode("utf-8", "surrogateescape")
    found, at = [], 0
    allowed = [_TEXT, _COLOUR, *([_OF_THE_DESKTOP] if desktop else [_OF_A_COMMAND])]
    while at < len(text):
        match = next((match for pattern in allowed if (match := pattern.match(text, at))), None)
        if match is None:
            found.append(text[at : at + 24])
            at += 1
        else:
            at = match.end()
    return found
