"""Assignments, on the teacher's page: {"t":"assign","do"}; every answer is {"t":"assign"}, too.

`do` is new (`kind`, `names`, `to`, `due`, `title`, and for a folder `upload`), collect, grade or return (`id`, `names`),
word (`id`, `name`, `mark`, `line`), close (`id`, `on`) or show (`id`): how everybody stands. The rows say which assignments
there are, and by `version` that something has changed.

class/assignments/upload takes a file of a folder that is to be handed out; class/assignments/ID.csv is the table of one.
"""

from __future__ import annotations

import asyncio
import contextlib
import random
import re
import secrets
import time
from collections.abc import Callable, Coroutine, Iterable
from typing import Any

from aiohttp import web

from day6_core.classroom.handed import clean_file_name
from day6_core.classroom.homes import same_name
from day6_core.classroom.journal import ALL
from day6_core.lessons.catalogue import offer
from day6_core.lessons.exam import new_exam
from day6_core.lessons.work import DRILL, EXAM, FOLDER, KINDS, LESSON, Task
from day6_core.reason import named_reason
from day6_core.session.harmless import one_line
from day6_tui.locale import Texts
from day6_tui.web import pages
from day6_tui.web.assignment_desk import AssignmentDesk
from day6_tui.web.assignment_standing import Standing, result_of
from day6_tui.web.assignment_texts import as_csv
from day6_tui.web.assignments import (
    LONGEST_LINE,
    LONGEST_MARK,
    LONGEST_TITLE,
    Assignment,
    AssignmentStore,
    TooMany,
    Word,
)
from day6_tui.web.class_part import Answer, Hear
from day6_tui.web.collecting import Collector
from day6_tui.web.gate import Gate
from day6_tui.web.grading_room import GradingRoom
from day6_tui.web.pupil_files import BadPath, parts_of
from day6_tui.web.sessions import Sessions
from day6_tui.web.tokens import TEACHER

LARGEST_FILE, LARGEST_UPLOAD, MOST_FILES = 1 << 20, 10 << 20, 200
"""Bytes of one file that is handed out, of all together, and how many."""
UPLOAD_SECONDS = 600.0
MOST_UPLOADS = 5
MOST_NAMES = 200
LONGEST_PROBLEM = 200


LOGGED = {"collect": "collected", "grade": "graded", "return": "gave_back"}
"""What the log of the lesson calls what the teacher has done."""


class ClassAssignments:
    """Lets the teacher hand out, collect, grade and give back."""

    def __init__(self, gate: Gate, sessions: Sessions, texts: Callable[[web.Request], Texts]) -> None:
        self._gate = gate
        self._page_texts = texts
        self._settings = settings = sessions.settings
        self._feed = sessions.feed
        self._background = sessions.background
        store = AssignmentStore(sessions.places.assignments)
        room = GradingRoom(sessions.mode, sessions.places, settings.limits)
        collector = Collector(sessions.files, sessions.places, store)
        self.desk = AssignmentDesk(store, sessions, collector, room, settings.lessons, Texts(settings.lang))
        self._uploads: dict[str, Upload] = {}
        self._steps: dict[str, int] = {}
        """How many steps each lesson has."""
        self._does: dict[str, Hear] = {
            "new": self._new,
            "collect": self._working("collect", lambda standing, names: self.desk.collect(standing, names)),
            "grade": self._working("grade", lambda standing, names: self.desk.grade(standing, names)),
            "return": self._working("return", lambda standing, names: self.desk.give_back(standing, names)),
            "word": self._word,
            "close": self._close,
            "show": self._show,
        }

    async def begin(self) -> None:
        """Find what is kept, and look after it from now on."""
        await asyncio.to_thread(self.desk.load)
        self.desk.begin()

    def hears(self) -> dict[str, Hear]:
        return {"assign": self._hear}

    def routes(self) -> list[web.RouteDef]:
        return [
            web.put("/class/assignments/upload", self._upload),
            web.get("/class/assignments/{id}.csv", self._table),
        ]

    def state(self, texts: Texts) -> dict[str, Any]:
        """Which there are, in short."""
        found = [_short(each, len(self.desk.names(each))) for each in self.desk.standings.values()]
        return {"assignments": {"version": self.desk.version, "list": found}}

    async def _hear(self, found: dict[str, Any]) -> Answer:
        answer = await self._does[found["do"]](found)
        return None if answer is None else {"t": "assign", "do": found["do"], **answer}

    def _standing(self, found: dict[str, Any]) -> Standing:
        return self.desk.standings[str(found["id"])]

    # -- what is asked -------------------------------------------------------------------------------------------------

    async def _new(self, found: dict[str, Any]) -> Answer:
        kind, due = found["kind"], float(found["due"] or 0)
        if kind not in KINDS or not 0 <= due < 1e11:
            raise ValueError(kind)
        to = None if found["to"] == "*" else tuple(str(each) for each in list(found["to"])[:MOST_NAMES])
        own = one_line(str(found["title"]))[:LONGEST_TITLE].strip()
        upload = self._uploads.pop(str(found.get("upload", "")), None)
        try:
            task, title = await asyncio.to_thread(
                self._task, kind, [str(each) for each in list(found["names"])[:50]], upload
            )
            title = {"zh": own, "en": own} if own else title
            made = await self.desk.hand_out(task, title, to, due, {} if upload is None else upload.files)
        except TooMany:
            return {"wrong": "many"}
        except Unknown as error:
            return {"wrong": str(error)}
        except OSError as error:
            return {"wrong": "disk", "why": named_reason(error)[:LONGEST_PROBLEM]}
        self._log("assigned", made, to)
        return {"id": made.id}

    def _log(self, what: str, assignment: Assignment, names: Iterable[str] | None) -> None:
        """Have it in the log of the lesson."""
        text = assignment.title.get(self._settings.lang, "") or assignment.task.name
        self._feed.roster.journal.note(what, ALL if names is None else ", ".join(names), text)

    def _task(self, kind: str, names: list[str], upload: Upload | None) -> tuple[Task, dict[str, str]]:
        """What is meant, and its titles. Raises Unknown."""
        if kind == FOLDER:
            if upload is None or not upload.files:
                raise Unknown("empty")
            return Task(FOLDER, (upload.place,)), {"zh": upload.name, "en": upload.name}
        known = offer(self._settings.lessons)
        if kind == EXAM:
            drills = tuple(names) or new_exam(known.drills, random.Random()).drills
            if any(known.named(each) is None for each in drills) or not drills or len(drills) != len(set(drills)):
                raise Unknown("unknown")
            self._steps |= dict.fromkeys(drills, 1)
            return Task(EXAM, drills), {language: Texts(language)("assign.exam") for language in ("zh", "en")}
        lesson = known.named(names[0]) if names else None
        if lesson is None or lesson.is_drill != (kind == DRILL):
            raise Unknown("unknown")
        return Task(kind, (lesson.name,)), dict(lesson.title)

    def _working(self, what: str, work: Callable[[Standing, list[str] | None], Coroutine[Any, Any, list[str]]]) -> Hear:
        async def begin(found: dict[str, Any]) -> Answer:
            standing = self._standing(found)
            names = None if found["names"] == "*" else [str(each) for each in list(found["names"])[:MOST_NAMES]]
            if standing.working_lock.locked():
                return {"id": standing.assignment.id, "wrong": "busy"}

            self._log(LOGGED[what], standing.assignment, names)

            async def whole() -> None:
                failed = await work(standing, names)
                if failed:
                    title = standing.assignment.title.get(self._settings.lang, "") or standing.assignment.task.name
                    self._feed.say(f"assign.failed.{what}", title=title, names=", ".join(failed))

            self._background.begin("serve.failed.assignments", whole())
            return None

        return begin

    async def _word(self, found: dict[str, Any]) -> Answer:
        mark, line = one_line(str(found["mark"]))[:LONGEST_MARK], one_line(str(found["line"]))[:LONGEST_LINE]
        standing, name = self._standing(found), str(found["name"])
        if same_name(name) not in map(same_name, self.desk.names(standing)):
            return None  # removed from the class meanwhile
        try:
            await self.desk.word(standing, name, mark=mark.strip(), line=line.strip())
        except OSError as error:
            why = named_reason(error)[:LONGEST_PROBLEM]
            return {"id": standing.assignment.id, "name": name, "wrong": "disk", "why": why}
        return None

    async def _close(self, found: dict[str, Any]) -> Answer:
        await self.desk.close(self._standing(found), found["on"] is True)
        return None

    async def _show(self, found: dict[str, Any]) -> Answer:
        standing = self._standing(found)
        rows = await self._rows(standing)
        return {"version": self.desk.version, "rows": rows, **_short(standing, len(rows))}

    async def _rows(self, standing: Standing) -> list[dict[str, Any]]:
        task = standing.assignment.task
        if task.name not in self._steps and task.kind in (LESSON, DRILL):
            lesson = await asyncio.to_thread(self.desk.lesson, task)
            self._steps[task.name] = 0 if lesson is None else len(lesson.steps)
        steps = {EXAM: len(task.names), FOLDER: 0}.get(task.kind, self._steps.get(task.name, 0))
        return [self._row(standing, name, steps) for name in self.desk.names(standing)]

    def _row(self, standing: Standing, name: str, steps: int) -> dict[str, Any]:
        key, row = same_name(name), self._feed.roster.row(name)
        collected, word = standing.collected.get(key), standing.words.get(key, Word())
        lesson = row.note.lesson if row is not None and row.is_here and row.note is not None else None
        at = lesson.step if lesson is not None and lesson.name in standing.assignment.task.names else 0
        grade = result_of(collected)
        return {
            "name": name,
            "here": row is not None and row.is_here,
            "state": _state(standing, key, at, grade),
            "at": at,
            "steps": steps,
            "solved": None if collected is None else collected.solved,
            "collected": None if collected is None else collected.when,
            "late": collected is not None and collected.late,
            "changed": key in standing.changed,
            "left_out": 0 if collected is None else collected.left_out,
            "trouble": standing.trouble.get(key, "")[:LONGEST_PROBLEM],
            **{what: grade.get(what) for what in ("points", "most", "unplayed")},
            "weak": grade.get("shielded") is False,
            "refused": (grade.get("refused") or {}).get(self._settings.lang, ""),
            "mark": word.mark,
            "line": word.line,
            "remark": word.line,
            "returned": word.returned,
            "news": self.desk.has_news(standing, name),
        }

    # -- the addresses -------------------------------------------------------------------------------------------------

    async def _table(self, request: web.Request) -> web.StreamResponse:
        texts = self._page_texts(request)
        if self._gate.ticket(request, TEACHER) is None:
            return pages.message(texts, "serve.wrong.stranger", status=403, up="../../")
        standing = self.desk.standings.get(request.match_info["id"])
        if standing is None:
            raise web.HTTPNotFound
        body = as_csv(await self._rows(standing), texts)
        name = f"{standing.assignment.id}-{time.strftime('%Y-%m-%d')}.csv"
        return web.Response(
            body=body, content_type="text/csv", headers={"Content-Disposition": f'attachment; filename="{name}"'}
        )

    async def _upload(self, request: web.Request) -> web.StreamResponse:
        """One file of a folder: `?upload=KEY&path=FOLDER/FILE`. The first makes the key, which is 0 then."""
        if self._gate.ticket(request, TEACHER) is None:
            return web.Response(status=403, text="No token.\n")
        self._uploads = {key: each for key, each in self._uploads.items() if time.monotonic() < each.until}
        key = request.query.get("upload", "")
        upload = Upload() if key == "0" and len(self._uploads) < MOST_UPLOADS else self._uploads.get(key)
        if upload is None:
            return web.json_response({"wrong": "busy"}, status=429)
        data = await self._gate.body(request, LARGEST_FILE)
        if data is None or not upload.take(request.query.get("path", ""), data):
            return web.json_response({"wrong": "large"}, status=413, headers={"Connection": "close"})
        key = secrets.token_hex(8) if key == "0" else key
        self._uploads[key] = upload
        return web.json_response({"upload": key})


class Unknown(Exception):
    """There is no such thing to be handed out; the message says what is wrong: unknown, empty."""


class Upload:
    """A folder that is being sent by the teacher's page."""

    def __init__(self) -> None:
        self.until = time.monotonic() + UPLOAD_SECONDS
        self.name = ""
        self.files: dict[str, bytes] = {}

    @property
    def place(self) -> str:
        """Where it goes in a home: packages where they are built."""
        return f"ros2_ws/src/{self.name}" if "package.xml" in self.files else self.name

    def take(self, path: str, data: bytes) -> bool:
        """Take a file of the folder; False if it is too much. Hidden files are left out."""
        with contextlib.suppress(BadPath):
            top, *inside = parts_of(path)
            if not inside or any(part.startswith(".") for part in inside):
                return True
            self.name = self.name or re.sub(r"\s+", "_", clean_file_name(top))
            if len(self.files) >= MOST_FILES or sum(map(len, self.files.values())) + len(data) > LARGEST_UPLOAD:
                return False
            self.files["/".join(map(clean_file_name, inside))] = data
        return True


def _state(standing: Standing, key: str, at: int, grade: dict[str, Any]) -> str:
    """In one word: returned, graded, collected, missing, working, given, waiting (not yet here)."""
    collected, word = standing.collected.get(key), standing.words.get(key, Word())
    if word.returned:
        return "returned"
    if grade:
        return "graded"
    if collected is not None and collected.begun:
        return "collected"
    if collected is not None or standing.assignment.due_taken:
        return "missing"
    if at:
        return "working"
    return "given" if key in standing.assignment.given else "waiting"


def _short(standing: Standing, everybody: int) -> dict[str, Any]:
    assignment = standing.assignment
    return {
        "id": assignment.id, "kind": assignment.task.kind, "title": dict(assignment.title), "due": assignment.due,
        "closed": assignment.closed, "all": everybody, "given": len(assignment.given),
        "collected": sum(each.begun for each in standing.collected.values()), "working": standing.working,
        "done": standing.done, "of": standing.all,
    }  # fmt: skip
