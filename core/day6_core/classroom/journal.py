"""The log of a class: what happened, to whom, and who did it; a file a day, which only this user can read.

A line of JSON for each event is in the file before anybody is answered, so nothing is lost when the program is killed; half a
line that was written last (a power cut) is dropped. What a full disk does not take waits in memory for the next event.
"""

from __future__ import annotations

import json
import os
import re
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from datetime import date, datetime
from pathlib import Path
from typing import NamedTuple

from day6_core.language import Pair
from day6_core.whole_file import append_private, make_private_folder

LARGEST = 16 << 20
"""Bytes of one day. The last quarter is kept for what pupils don't do."""
BURST, SECONDS_EACH = 200, 5.0
"""So many events of one pupil are written as they come; then one every five seconds, and how many were left out."""
LONGEST_TEXT = 1000
MOST_WAITING = 1000
"""Events that a full disk has not taken."""
MOST_PUPILS = 1000
"""Whose events are counted at a time."""

PUPIL, TEACHER, SERVER = "pupil", "teacher", "server"
ALL = ""
"""In place of a pupil's name: the whole class."""


class Kind(NamedTuple):
    """A kind of event: who does it, what it is called in the log, and the order of a teacher (`order.py`) that is one."""

    by: str
    text: Pair
    order: str = ""


KINDS = {
    "began": Kind(SERVER, ("the class page's server started", "班级服务器启动")),
    "left_out": Kind(SERVER, ("events not written, there were too many", "事件太多，没有记下的条数")),
    "came": Kind(PUPIL, ("came", "来了")),
    "left": Kind(PUPIL, ("left", "走了")),
    "lesson": Kind(PUPIL, ("opened a lesson", "打开课程")),
    "solved": Kind(PUPIL, ("step solved", "完成一步")),
    "solved_typing": Kind(PUPIL, ("step solved while the teacher was typing", "完成一步（当时老师在代打字）")),
    "step": Kind(PUPIL, ("next step", "下一步")),
    "step_typing": Kind(PUPIL, ("next step while the teacher was typing", "下一步（当时老师在代打字）")),
    "error": Kind(PUPIL, ("error", "出错")),
    "mended": Kind(PUPIL, ("error fixed", "错误已解决")),
    "hand": Kind(PUPIL, ("hand up", "举手")),
    "lowered": Kind(PUPIL, ("hand down", "手放下")),
    "answered": Kind(PUPIL, ("answered", "回答")),
    "allowed": Kind(PUPIL, ("let the teacher type", "允许老师代打字")),
    "declined": Kind(PUPIL, ("did not let the teacher type", "不允许老师代打字")),
    "allowed_show": Kind(PUPIL, ("let the class see the screen", "允许全班看自己的屏幕")),
    "declined_show": Kind(PUPIL, ("did not let the class see the screen", "不允许全班看自己的屏幕")),
    "took_back": Kind(PUPIL, ("stopped the teacher typing", "不再允许老师代打字")),
    "attended": Kind(TEACHER, ("opened the class", "打开全班的页面")),
    "away": Kind(TEACHER, ("closed the class; nobody is frozen any more", "关闭全班的页面，全部解除锁定")),
    "said": Kind(TEACHER, ("said", "发消息"), "say"),
    "gave_link": Kind(TEACHER, ("handed out a link", "发了链接"), "link"),
    "gave_file": Kind(TEACHER, ("handed out a file", "发了文件"), "file"),
    "froze": Kind(TEACHER, ("froze the screen", "锁定屏幕")),
    "unfroze": Kind(TEACHER, ("unfroze the screen", "解除锁定")),
    "started_scene": Kind(TEACHER, ("started a scene", "让学生打开场景"), "scene"),
    "started_lesson": Kind(TEACHER, ("started a lesson", "让学生打开课程"), "lesson"),
    "asked": Kind(TEACHER, ("asked to type", "请求代打字"), "ask_to_type"),
    "typed": Kind(TEACHER, ("began to type", "开始代打字")),
    "stopped": Kind(TEACHER, ("stopped typing", "不再打字"), "stop_typing"),
    "saw_hand": Kind(TEACHER, ("lowered the hand", "放下学生的手"), "lower_hand"),
    "ended": Kind(TEACHER, ("ended the desktop", "结束桌面"), "end"),
    "showed": Kind(TEACHER, ("showed a screen to the class", "向全班展示屏幕")),
    "assigned": Kind(TEACHER, ("handed out an assignment", "布置作业")),
    "collected": Kind(TEACHER, ("collected an assignment", "收作业")),
    "graded": Kind(TEACHER, ("had an assignment graded", "批改作业")),
    "gave_back": Kind(TEACHER, ("gave marks back", "发还成绩")),
    "restarted": Kind(TEACHER, ("restarted the desktop", "重新启动桌面")),
    "cleared": Kind(TEACHER, ("cleared the desk", "清空桌面")),
    "reset_lesson": Kind(TEACHER, ("had the lesson start over", "让课程从头开始")),
    "reset_home": Kind(TEACHER, ("gave an empty home; the old one is in", "换成空的主目录；原来的在")),
    "let_in": Kind(TEACHER, ("let in", "准许进入")),
    "turned_away": Kind(TEACHER, ("turned away", "拒绝进入")),
    "removed": Kind(TEACHER, ("removed from the class", "移出课堂")),
}
"""What is in the log. A new kind is a row here; an order that has one is written down when it was sent."""

WHILE_TYPING = {"solved": "solved_typing", "step": "step_typing"}
"""What these are called where the teacher's keys may have done them."""

OF_ORDER = {kind.order: what for what, kind in KINDS.items() if kind.order}


class ClassEvent(NamedTuple):
    """Something that happened; `time` in seconds since 1970, `name` the pupil whom it is about (ALL: everybody)."""

    time: float
    name: str
    what: str
    """A key of KINDS."""
    text: str = ""

    @property
    def by(self) -> str:
        """Who did it: PUPIL, TEACHER or SERVER."""
        return KINDS[self.what].by


class Journal:
    """Writes the log and reads it. Without a folder it is kept in memory only. Not for several threads."""

    def __init__(
        self,
        folder: Path | None = None,
        failed: Callable[[OSError], None] = lambda error: None,
        *,
        wall: Callable[[], float] = time.time,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._folder = folder
        self._failed = failed
        self._has_failed = False
        self._wall = wall
        self._clock = clock
        self._mended: Path | None = None
        """The file whose end is known to be that of a line."""
        self._waiting: deque[ClassEvent] = deque(maxlen=MOST_WAITING)
        self._counts: dict[str, _Allowance] = {}

    # -- writing -------------------------------------------------------------------------------------------------------

    def note(self, what: str, name: str = ALL, text: str = "") -> None:
        """Write down what happened, now. `failed` is told once if that cannot be done; the event waits for the next one then."""
        if KINDS[what].by == PUPIL:
            allowance = self._allowance(name)
            if not allowance.take(self._clock()):
                return
            if left_out := allowance.spend():
                self._write(ClassEvent(self._wall(), name, "left_out", str(left_out)))
        self._write(ClassEvent(self._wall(), name, what, text[:LONGEST_TEXT]))

    def _allowance(self, name: str) -> _Allowance:
        if name not in self._counts and len(self._counts) >= MOST_PUPILS:
            self._counts.clear()
        return self._counts.setdefault(name, _Allowance(self._clock()))

    def _write(self, event: ClassEvent) -> None:
        self._waiting.append(event)
        if self._folder is None:
            return
        try:
            while self._waiting:
                self._append(self._waiting[0])
                self._waiting.popleft()
        except OSError as error:
            if not self._has_failed:
                self._has_failed = True
                self._failed(error)

    def _append(self, event: ClassEvent) -> None:
        """Raises OSError."""
        path = self._path(date.fromtimestamp(event.time))
        make_private_folder(path.parent)
        if path != self._mended:
            _drop_half_a_line(path)
            self._mended = path
        size = path.stat().st_size if path.exists() else 0
        if size < (LARGEST * 3 // 4 if event.by == PUPIL else LARGEST):
            found = {"time": round(event.time, 3), "by": event.by, "name": event.name, "what": event.what}
            line = json.dumps(found | {"text": event.text} if event.text else found, ensure_ascii=False)
            append_private(path, line.encode(errors="replace") + b"\n")

    # -- reading -------------------------------------------------------------------------------------------------------

    def days(self) -> list[date]:
        """The days of which there is a log, the last one first; without a folder, or before the first event, none."""
        names = os.listdir(self._folder) if self._folder is not None and self._folder.is_dir() else []
        found = []
        for name in names:
            if name.endswith(".jsonl") and re.fullmatch(r"\d{4}-\d\d-\d\d", name[:-6]):
                with suppress(ValueError):
                    found.append(date.fromisoformat(name[:-6]))
        return sorted(found, reverse=True)

    def events(self, day: date | None = None) -> list[ClassEvent]:
        """What happened on a day (None: today), the oldest first. Any thread. Raises OSError."""
        day = date.fromtimestamp(self._wall()) if day is None else day
        found: list[ClassEvent] = []
        if self._folder is not None:
            with suppress(FileNotFoundError), open(self._path(day), "rb") as file:
                *lines, _half = file.read(LARGEST + (1 << 16)).split(b"\n")
                found = [event for line in lines if (event := _event_of(line)) is not None]
        waiting = (event for event in tuple(self._waiting) if date.fromtimestamp(event.time) == day)
        return [*found, *waiting]

    def _path(self, day: date) -> Path:
        assert self._folder is not None
        return self._folder / f"{day.isoformat()}.jsonl"


class _Allowance:
    """How many events of one pupil may still be written, and how many were not."""

    def __init__(self, now: float) -> None:
        self._room = float(BURST)
        self._at = now
        self._left_out = 0

    def take(self, now: float) -> bool:
        """Whether one more may be."""
        self._room = min(BURST, self._room + (now - self._at) / SECONDS_EACH)
        self._at = now
        if self._room < 1:
            self._left_out += 1
            return False
        self._room -= 1
        return True

    def spend(self) -> int:
        """Return how many were left out since this was asked last."""
        found, self._left_out = self._left_out, 0
        return found


def _drop_half_a_line(path: Path) -> None:
    """End a file with its last whole line. Raises OSError."""
    with suppress(FileNotFoundError), open(path, "r+b") as file:
        size = end = file.seek(0, os.SEEK_END)
        while end:
            begin = max(0, end - (1 << 16))
            file.seek(begin)
            place = file.read(end - begin).rfind(b"\n")
            if place >= 0:
                end = begin + place + 1
                break
            end = begin
        if end < size:
            file.truncate(end)


def _event_of(line: bytes) -> ClassEvent | None:
    """Read a line; None for one that is damaged, or of a kind that this version doesn't know."""
    try:
        found = json.loads(line)
        event = ClassEvent(float(found["time"]), str(found["name"]), str(found["what"]), str(found.get("text", "")))
        datetime.fromtimestamp(event.time)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError, OverflowError, OSError):
        return None
    return event if event.what in KINDS else None
