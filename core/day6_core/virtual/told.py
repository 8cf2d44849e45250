"""What a user is told of a world in virtual time."""

from __future__ import annotations

import os
import sys

from day6_core.language import language_of
from day6_core.virtual import surroundings

TOLD_AFTER = 2.0
"""Real seconds for which time stands still before that is said."""

Used = tuple[float, float]
"""For how many seconds a process has had a core, and for how many it has wanted one."""

_TEXTS = {
    "en": {
        "busy": "time stands still: {what} has been busy for 2 s without waiting",
        "real": "time stands still: {what} waits for something real",
        "foreign": "time stands still while {what} runs, which isn't a Python program",
        "no_world": "the world of virtual time can't be made or entered: {what}",
        "nothing": "nothing is left to happen: everybody waits for somebody else ({what})",
    },
    "zh": {
        "busy": "时间停住了：{what} 已经忙了 2 秒没有等待",
        "real": "时间停住了：{what} 在等真实世界里的东西",
        "foreign": "{what} 不是 Python 程序，它运行时时间停住",
        "no_world": "虚拟时间的世界建不起来，或者进不去：{what}",
        "nothing": "再也不会有事发生：大家都在等别人（{what}）",
    },
}


def is_computing(before: Used, now: Used) -> bool:
    """Return whether it has computed for so long, however long that took beside other programs."""
    return now[0] - before[0] >= TOLD_AFTER * 0.9


def is_waiting(before: Used, now: Used) -> bool:
    """Return whether it has wanted no core in the meantime, so many seconds."""
    return now[1] - before[1] < TOLD_AFTER / 10


def tell(kind: str, what: str) -> None:
    """Write one line on standard error, or have the desktop say it if this is its process."""
    language = language_of(os.environ)
    colon = {"en": ": ", "zh": "："}[language]
    text = _TEXTS[language][kind].format(what=what)
    if surroundings.pace is not None and (say := surroundings.pace.say) is not None:
        say(text)
        return
    sys.stderr.write(f"day6-tui{colon}{text}\n")
    sys.stderr.flush()
