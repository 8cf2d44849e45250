"""The keys of a class on the wire.

day6_class/up/anna/…        from the pupil anna: tokens and messages of her graph, and the four below
day6_class/up/anna/join     a question: may I be anna?
day6_class/up/anna/here/ID  a token: anna is here, and this is the session
day6_class/up/anna/note     what her desktop says of itself
day6_class/down/anna/…      to her: tokens and messages of the teacher that concern her graph, and
day6_class/down/anna/order  what the teacher asks of her desktop
day6_class/down/anna/file   a question: will you take this file?
day6_class/down/teacher/ID  a token: the teacher is here
day6_class/down/teacher/shown  to all pupils: the screen that is shown to the class
"""

from __future__ import annotations

import re

UP, DOWN = "day6_class/up", "day6_class/down"
WIRE_DOMAIN = "0"
"""Stands for everybody's domain in the keys of a graph, so that pupils and teacher need not have the same."""
TEACHER = "teacher"
"""No pupil's name: the teacher's nodes are below /teacher in a pupil's graph."""
SHOWN = f"{DOWN}/{TEACHER}/shown"
LONGEST_NAME = 32
_NAME = re.compile(rf"[A-Za-z][A-Za-z0-9_]{{0,{LONGEST_NAME - 1}}}", re.ASCII)


def is_name(name: str) -> bool:
    """Return whether a pupil may have this name: one part of a ROS name, so that it can be a namespace."""
    return _NAME.fullmatch(name) is not None and "__" not in name and name.lower() != TEACHER


def join_key(name: str) -> str:
    """Return the key of the question whether a pupil may have this name; `*` means all."""
    return f"{UP}/{name}/join"


def here_token(name: str, zid: str) -> str:
    """Return the token of a pupil who is here; `*` means all."""
    return f"{UP}/{name}/here/{zid}"


def teacher_token(zid: str) -> str:
    """Return the token of the teacher's session; `*` means any."""
    return f"{DOWN}/{TEACHER}/{zid}"


def note_key(name: str) -> str:
    """Return the key of a pupil's notes; `*` means all."""
    return f"{UP}/{name}/note"


def order_key(name: str) -> str:
    """Return the key of the orders to a pupil."""
    return f"{DOWN}/{name}/order"


def file_key(name: str) -> str:
    """Return the key of the files for a pupil."""
    return f"{DOWN}/{name}/file"


def name_in(key: str) -> str | None:
    """Return the pupil's name in a key that begins with UP or DOWN; None if there is no valid one."""
    parts = key.split("/", 3)
    return parts[2] if len(parts) > 3 and f"{parts[0]}/{parts[1]}" in (UP, DOWN) and is_name(parts[2]) else None
