"""What pupils may be called, and which names mean the same pupil."""

from __future__ import annotations

import re
import unicodedata
from zlib import crc32

LONGEST = 32
"""Characters of a name."""

_LONGEST_FOLDER = 120
"""Bytes: a file system takes 255, and ours get something added."""

_INVISIBLE = re.compile(r"[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u3164\ufe00-\ufe0f\uffa0\U000e0100-\U000e01ef]")
"""Letters and marks that nobody sees (Unicode: Default_Ignorable_Code_Point): a name with them is the one without."""


class BadName(ValueError):
    """This cannot be a name; the message is the key of a text."""


def clean(text: str) -> str:
    """The name as it is kept and shown. Raises BadName."""
    name = " ".join(_INVISIBLE.sub("", unicodedata.normalize("NFC", text)).split())
    if not name:
        raise BadName("serve.name.empty")
    if len(name) > LONGEST:
        raise BadName("serve.name.long")
    if not any(letter.isalnum() for letter in name) or not all(_is_fit(letter) for letter in name):
        raise BadName("serve.name.letters")
    return name


def _is_fit(letter: str) -> bool:
    """Letters (with what is put on them), digits and what stands in names of people; nothing that is invisible."""
    return letter in " -_.'’·" or unicodedata.category(letter)[0] in "LNM"


def same_name(name: str) -> str:
    """Two names with the same result are one pupil's."""
    return unicodedata.normalize("NFKC", name).casefold()


def folder_name(name: str) -> str:
    """The folder of a pupil's home: the name, where that is a plain file name, and different for different pupils."""
    key = same_name(name)
    plain = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in key)
    if plain == key and len(plain.encode()) <= _LONGEST_FOLDER and not plain.startswith("-"):
        return plain
    return f"{plain.encode()[:_LONGEST_FOLDER].decode(errors='ignore').strip('-')}-{crc32(key.encode()):08x}"
