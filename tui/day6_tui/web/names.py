"""What pupils may be called, and which names mean the same pupil."""

from __future__ import annotations

import hashlib
import re
import unicodedata

from day6_core.classroom.homes import same_name

TEACHERS = "@teacher"
"""The desktop of the teacher: it is called what no pupil can be, and no pupil's folder."""

LONGEST = 32
"""Characters of a name."""

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


def who_is(name: str) -> str:
    """What stands for a pupil in the addresses of tabs and the names of cookies: no secret."""
    return hashlib.sha256(same_name(name).encode()).hexdigest()[:12]
