"""The text that a key press sends: the bytes of an xterm."""

from __future__ import annotations

_PLAIN = {
    "enter": "\r",
    "tab": "\t",
    "shift+tab": "\x1b[Z",
    "backspace": "\x7f",
    "ctrl+backspace": "\x17",
    "alt+backspace": "\x1b\x7f",
    "escape": "\x1b",
    "space": " ",
    "insert": "\x1b[2~",
    "delete": "\x1b[3~",
    "pageup": "\x1b[5~",
    "pagedown": "\x1b[6~",
    "f1": "\x1bOP",
    "f2": "\x1bOQ",
    "f3": "\x1bOR",
    "f4": "\x1bOS",
    "f5": "\x1b[15~",
    "f6": "\x1b[17~",
    "f7": "\x1b[18~",
    "f8": "\x1b[19~",
    "f9": "\x1b[20~",
    "f10": "\x1b[21~",
    "f11": "\x1b[23~",
    "f12": "\x1b[24~",
    "ctrl+@": "\x00",
    "ctrl+space": "\x00",
    "ctrl+backslash": "\x1c",
    "ctrl+right_square_bracket": "\x1d",
    "ctrl+circumflex_accent": "\x1e",
    "ctrl+underscore": "\x1f",
}

_CURSOR = {"up": "A", "down": "B", "right": "C", "left": "D", "home": "H", "end": "F"}

_MODIFIERS = {"shift": 1, "alt": 2, "ctrl": 4}

_BACK = {text: key for key, text in reversed(_PLAIN.items())} | {
    f"\x1b{mode}{letter}": key for key, letter in _CURSOR.items() for mode in "[O"
}


def decode(text: str) -> tuple[str, str | None]:
    """Textual's key and character for one key as a terminal sends it; the other way round than `encode`."""
    if text in ("\n", "\r"):
        return "enter", "\r"
    character = text if len(text) == 1 else None
    if "\x01" <= text <= "\x1a" and text != "\t":
        return "ctrl+" + chr(ord(text) + 96), character
    return _BACK.get(text, text), character


def encode(key: str, character: str | None, *, application_cursor: bool = False) -> str:
    """The text a terminal sends for Textual's `key` and `character`; '' for a key that sends nothing.

    `application_cursor` is the mode DECCKM, in which the unmodified cursor keys send ESC O instead of ESC [.
    """
    if key in _PLAIN:
        return _PLAIN[key]
    *names, base = key.split("+") if key != "+" else [key]
    if base in _CURSOR:
        modifier = 1 + sum(_MODIFIERS.get(name, 0) for name in names)
        if modifier > 1:
            return f"\x1b[1;{modifier}{_CURSOR[base]}"
        return ("\x1bO" if application_cursor else "\x1b[") + _CURSOR[base]
    if names == ["ctrl"] and len(base) == 1 and base.isalpha():
        return chr(ord(base.lower()) - 96)
    if character and (character.isprintable() or len(key) == 1):
        return ("\x1b" + character) if "alt" in names else character
    if names == ["alt"] and len(base) == 1:
        return "\x1b" + base
    return ""
