"""What checks of lessons were told by a real machine, written down, and a `Live` that tells it to them again without one.

`RecordingLive` takes a moment: the answers that the last look at the checks asked for. `ToldLive` shows such moments. Times are
microseconds since the lesson began, the home folder is `HOME`, and of messages and outputs only so much is kept that the checks
judge as they did (`compact`).
"""

from __future__ import annotations

import json
import os
import re
import shlex
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from copy import deepcopy
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from rosidl_runtime_py.convert import message_to_ordereddict
from rosidl_runtime_py.set_message import set_message_fields
from rosidl_runtime_py.utilities import get_message

from day6_core.lessons.checks import Condition, Verdict
from day6_core.lessons.checks.drawing import Stroke, _strokes
from day6_core.lessons.live import Arrival, Heard, Live
from day6_core.lessons.texts import Say
from day6_core.ros.programs.rviz2.model.status import StatusList
from day6_core.ros.programs.turtlesim.model import PIXELS_PER_METRE
from day6_core.shell.language.syntax import SimpleCommand
from day6_core.shell.language.words import Word
from day6_core.shell.runs import Ran, Run

ROOT = Path(__file__).resolve().parents[2]
HOME = "/home/student"
BEGAN_NS = 1_700_000_000 * 10**9
"""When every lesson begins that is told again."""

BETWEEN_NS = 1_500_000_000
"""How far the wall clock goes on from one moment to the next: a check that asks a program again does so each time."""

MESSAGES = (2, 6, 20, 60, 200, 500)
CHARACTERS = (0, 200, 1000, 4000, 40_000)
"""How much is tried to be kept: new messages of a topic in one moment, the end of what a line printed."""

LONG = 40
"""From how many characters on what comes twice in a history is written down once."""

VARIABLES = ("AMENT_PREFIX_PATH",)
"""Variables of terminals that checks ask for."""

Json = Any


def verdict_json(verdict: Verdict, home: Path) -> Json:
    """A verdict as it is compared: whether it holds, what is wanted, what was seen."""
    found: Json = same_everywhere([verdict.ok, _said(verdict.wanted), _said(verdict.saw)], home)
    return found


def _said(value: Any) -> Json:
    if isinstance(value, Say):
        return {"say": value.key, **{name: _said(each) for name, each in value.values.items()}}
    if isinstance(value, (tuple, list)):
        return [_said(each) for each in value]
    return value if value is None or isinstance(value, (bool, int, float, str)) else str(value)


def say_of(told: Json) -> Say | None:
    """The text that was written down."""
    return None if told is None else Say(told["say"], **{name: _value(told[name]) for name in told if name != "say"})


def _value(told: Json) -> Any:
    if isinstance(told, dict):
        return say_of(told)
    return tuple(map(_value, told)) if isinstance(told, list) else told


def said(say: Say | None, home: Path) -> Json:
    """A text as it is compared."""
    return same_everywhere(_said(say), home)


def keys_of(verdicts: Json) -> Json:
    """Of verdicts what may not change when less is written down: whether they hold, and which texts they give."""
    return [[ok, wanted["say"], saw and saw["say"]] for ok, wanted, saw in verdicts]


def same_everywhere(told: Json, home: Path) -> Json:
    """The same without what is another on every machine: places, stamps of logs."""
    if isinstance(told, str):
        places = {str(home): HOME, str(ROOT): "/usr/lib/day6_tui", sys.prefix: "/usr", sys.base_prefix: "/usr"}
        for place in sorted(places, key=len, reverse=True):
            told = told.replace(place, places[place])
        told = re.sub(rf"{re.escape(tempfile.gettempdir())}/[\w.-]+", "/scratch", told)
        return re.sub(r"\[\d{10}\.\d{9}\]", "[1700000000.000000000]", told)
    if isinstance(told, dict):
        return {same_everywhere(key, home): same_everywhere(each, home) for key, each in told.items()}
    if isinstance(told, float):
        return round(told, 6)
    return [same_everywhere(each, home) for each in told] if isinstance(told, (list, tuple)) else told


# -- writing down ----------------------------------------------------------------------------------------------------------


class RecordingLive(Live):
    """A real machine that keeps what it was asked since `forget`, and what it answered."""

    def __init__(self, *arguments: Any) -> None:
        self._told: dict[str, Any] = {}
        self._looked: set[str] = set()
        self._given: dict[str, int] = {}
        self._begun = False
        self._ended: dict[str, Json] = {}
        super().__init__(*arguments)
        self._start, self.desk.start_program = self.desk.start_program, self._started  # type: ignore[method-assign]

    def begin_step(self) -> None:
        super().begin_step()
        self._given.clear()
        self._ended.clear()
        self._begun = True

    def forget(self) -> None:
        """A new look begins."""
        self._told, self._looked = {}, set()

    # -- what is asked -------------------------------------------------------------------------------------------------

    def _note(self, kind: str, key: str, answer: Any) -> Any:
        self._told.setdefault(kind, {})[key] = answer
        return answer

    def nodes(self) -> list[str]:
        found: list[str] = self._note("nodes", "", super().nodes())
        return found

    def topics(self) -> dict[str, list[str]]:
        before = {kind: dict(each) for kind, each in self._told.items()}
        found = super().topics()
        self._told = before  # who has an end there was asked by this question only
        self._note("topics", "", found)
        return found

    def publishers(self, topic: str) -> list[str]:
        found: list[str] = self._note("publishers", topic, super().publishers(topic))
        return found

    def subscribers(self, topic: str) -> list[str]:
        found: list[str] = self._note("subscribers", topic, super().subscribers(topic))
        return found

    def servers(self, service: str) -> list[str]:
        found: list[str] = self._note("servers", service, super().servers(service))
        return found

    def parameter(self, node: str, name: str) -> tuple[bool, Any]:
        answer = super().parameter(node, name)
        self._note("parameters", f"{node} {name}", list(answer))
        return answer

    def heard(self, topic: str) -> Heard:
        self._looked.add(f"heard {topic}")
        return super().heard(topic)

    @property
    def terminals(self) -> Any:
        self._looked.add("terminals")
        return super().terminals

    def runs(self, since_ns: int, *, new: bool = False) -> list[Run]:
        self._looked.add("terminals")
        return super().runs(since_ns, new=new)

    def places(self, since_ns: int) -> list[list[Path]]:
        self._looked |= {"terminals", "files"}
        return super().places(since_ns)

    def variables(self) -> list[dict[str, str]]:
        self._looked.add("files")  # `sourced` looks whether a package is there
        return super().variables()

    def windows(self, kind: str | None = None) -> Any:
        self._looked.add("windows")
        return super().windows(kind)

    def path(self, text: str) -> Path:
        found = super().path(text)
        self._looked |= {"files", f"path {os.path.normpath(found)}"}
        return found

    def _started(self, words: list[str], *arguments: Any, **keywords: Any) -> Any:
        program = self._start(words, *arguments, **keywords)
        if len(words) == 2 and self.folder.resolve() in Path(words[1]).parents:
            return _RecordedProgram(program, self._ended, Path(words[1]).name)
        return program

    # -- what is kept --------------------------------------------------------------------------------------------------

    def signature(self, checks: Sequence[Condition], verdicts: Sequence[Verdict]) -> tuple[bool, ...]:
        """Which checks hold, and which have held once: whenever this changes a moment matters."""
        every = [part for check in checks for part in check.every()]
        return (*(each.ok for each in verdicts), *("held" in self.memory(part) for part in every))

    def moment(self, verdicts: Sequence[Verdict], also: Iterable[str] = ()) -> Json:
        """What the last look was told; `also`: what is kept though it was not asked for."""
        looked = self._looked | set(also)
        found: dict[str, Json] = {"at": self._since(self.now_ns()), **self._told}
        if self._begun:
            found["began"], self._begun = self._since(self.step_began_ns), False
        for topic in sorted(each[6:] for each in looked if each.startswith("heard ")):
            found.setdefault("heard", {})[topic] = self._new(topic)
        if "terminals" in looked or "files" in looked:
            found["terminals"] = [self._terminal(each) for each in self.desk.terminals]
        if "windows" in looked:
            found["windows"] = [_window(each) for each in super().windows()]
        if "files" in looked:
            found["files"] = _tree(self.home, {Path(each[5:]) for each in looked if each.startswith("path ")})
        if self.answer:
            found["answer"] = self.answer
        if self._ended:
            found["python"] = dict(self._ended)
        told: dict[str, Json] = same_everywhere(found, self.home)
        told["verdicts"] = [verdict_json(each, self.home) for each in verdicts]
        return told

    def _since(self, time_ns: int | None) -> int | None:
        return None if time_ns is None else (time_ns - self.lesson_began_ns) // 1000

    def _new(self, topic: str) -> Json:
        heard = self._heard[topic]
        arrivals = heard.arrivals(self._given.get(topic, 0))
        self._given[topic] = heard.count
        return [[self._since(each.when), self._message(each.message), each.sender] for each in arrivals]

    def _message(self, message: Any) -> Json:
        kind = type(message)
        module = kind.__module__.split(".")
        content = _changed(_plain(message_to_ordereddict(message)), _plain(message_to_ordereddict(kind())))
        return [f"{module[0]}/msg/{kind.__name__}", _shifted(content, self.lesson_began_ns)]

    def _terminal(self, terminal: Any) -> Json:
        variables = terminal.shell.environment
        return {
            "closed": terminal.closed,
            "running": list(terminal.running),
            "variables": {name: variables[name] for name in VARIABLES if name in variables},
            "cwd": str(terminal.shell.cwd),
            "runs": [
                [each.number, each.source, self._since(each.began_ns), self._since(each.ended_ns), each.status, each.output,
                 [self._ran(ran) for ran in each.commands]]
                for each in terminal.runs.all
            ],
        }  # fmt: skip

    def _ran(self, ran: Ran) -> Json:
        times = self._since(ran.began_ns), self._since(ran.ended_ns)
        return [
            list(ran.argv),
            ran.source,
            str(ran.cwd),
            *times,
            ran.status,
            ran.is_function,
            ran.screen,
            ran.elsewhere,
        ]


class _RecordedProgram:
    """A program of a lesson: how it ended is known from when the check has seen it."""

    def __init__(self, program: Any, ended: dict[str, Json], name: str) -> None:
        self._program, self._ended, self._name = program, ended, name
        self.session, self.kill = program.session, program.kill

    @property
    def status(self) -> int | None:
        found: int | None = self._program.status
        if found is not None:
            self._ended[self._name] = [found, self.session.stdout.text]
        return found


def _plain(value: Any) -> Json:
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return round(value, 6) if isinstance(value, float) else value


def _changed(content: Json, default: Json) -> Json:
    """The fields that are not as in an empty message."""
    found = {}
    for key, value in content.items():
        if value != default.get(key):
            found[key] = _changed(value, default[key]) if isinstance(value, dict) else value
    return found


def _shifted(content: Json, began_ns: int) -> Json:
    """Stamps of today as if the lesson had begun at `BEGAN_NS`."""
    if isinstance(content, list):
        return [_shifted(each, began_ns) for each in content]
    if not isinstance(content, dict):
        return content
    if content and set(content) <= {"sec", "nanosec"} and content.get("sec", 0) > 1_000_000_000:
        stamp = content["sec"] * 10**9 + content.get("nanosec", 0) - began_ns + BEGAN_NS
        return {"sec": stamp // 10**9, "nanosec": stamp % 10**9}
    return {key: _shifted(each, began_ns) for key, each in content.items()}


def _window(window: Any) -> Json:
    """The kind of a window, with what checks look at in its model."""
    model = window.model
    if window.kind == "turtlesim":
        strokes = _strokes(model, {})
        found = {"kind": window.kind, "trail": [_straightened(each.points) for each in strokes]}
        jumps = {str(at): _jump(each) for at, each in enumerate(strokes) if _jump(each)}
        return {**found, "jumps": jumps} if jumps else found
    if window.kind == "rviz2":
        displays = [
            [each.type, each.enabled, [[line.level, line.name, line.value] for line in each.statuses.lines]]
            for each in model.displays
        ]
        return {"kind": window.kind, "frame": model.fixed_frame, "displays": displays}
    return {"kind": window.kind}


def _jump(stroke: Stroke) -> str:
    return "drew" if stroke.jumped else "before" if stroke.cut else ""


def _straightened(stroke: Sequence[tuple[float, float]]) -> Json:
    """The points of a stroke without those on a straight line between two others."""
    kept = [stroke[0]]
    for at in range(1, len(stroke) - 1):
        (ax, ay), (bx, by), (cx, cy) = kept[-1], stroke[at], stroke[at + 1]
        if abs((bx - ax) * (cy - by) - (by - ay) * (cx - bx)) > 1e-7:
            kept.append(stroke[at])
    kept.append(stroke[-1])
    return [[round(x, 4), round(y, 4)] for x, y in kept]


_TEXTS = ("package.xml", "setup.py", "colcon_build.rc")
_UNSEEN = re.compile(r"\..*|log|__pycache__|.*\.egg-info|build|install")


def _tree(home: Path, asked: set[Path]) -> Json:
    """The files that checks may look at: for each when it was changed, as a rank, and the text if it matters."""
    paths = {path for path in asked if os.path.lexists(path)}
    for folder, folders, names in os.walk(home):
        here = Path(folder)
        if "build" in folders or "install" in folders:
            paths |= {each for each in here.glob("build/*/*") if each.is_symlink() or each.name == "colcon_build.rc"}
            paths |= {*here.glob("install/*/share/*/package.xml"), *here.glob("install/share/*/package.xml")}
        folders[:] = [each for each in folders if not _UNSEEN.fullmatch(each)]
        paths |= {here / name for name in names if not name.startswith(".")}
    times = sorted({path.lstat().st_mtime_ns for path in paths})
    found: dict[str, Json] = {}
    for path in sorted(paths):
        name = path.relative_to(home).as_posix()
        if path.is_symlink() and "build" in path.parts:
            found[name] = "link"
        elif path.is_dir():
            found[name] = "folder"
        elif path.is_file():
            is_read = path in asked or path.name in _TEXTS
            text = path.read_text(encoding="utf-8", errors="replace") if is_read else ""
            found[name] = [times.index(path.lstat().st_mtime_ns), text]
    return found


# -- telling it again ------------------------------------------------------------------------------------------------------


class ToldDesk(SimpleNamespace):
    """What `Live` asks the machine for, as it was at one moment."""

    def __init__(self, home: Path) -> None:
        super().__init__(home=home, login_home=home, terminals=[], display=SimpleNamespace(windows=[]), programs={})
        self.closed_runs: list[Any] = []
        self.now_ns = self.wall_ns = BEGAN_NS
        self.python: dict[str, Json] = {}
        self.clock = SimpleNamespace(
            now_ns=lambda: self.now_ns, wall_ns=lambda: self.wall_ns, steady_ns=lambda: self.wall_ns
        )

    def environment(self) -> dict[str, str]:
        """Variables for a program; nobody reads them."""
        return {}

    def start_program(self, words: Sequence[str], *_: Any, **__: Any) -> Any:
        """The program of a lesson, which has ended as it ended then."""
        return _ToldProgram(self.python, Path(words[1]).name)


class _ToldProgram:
    """A program of a lesson: `status` and what it printed are as the moment says."""

    def __init__(self, ended: dict[str, Json], name: str) -> None:
        self._ended, self._name = ended, name
        self.session = SimpleNamespace(stdout=self)

    @property
    def status(self) -> int | None:
        return self._ended[self._name][0] if self._name in self._ended else None

    @property
    def text(self) -> str:
        return str(self._ended[self._name][1])


class ToldLive(Live):
    """Tells checks what a real machine told them. `show` a moment before they are asked; `desk` is a ToldDesk."""

    def __init__(self, desk: Any, session: Any, folder: Path) -> None:
        self._told: dict[str, Any] = {}
        super().__init__(desk, session, folder)
        self._desk: ToldDesk = desk
        self._laid: dict[str, Json] = {}

    def show(self, moment: Json) -> None:
        """Make it that moment."""
        desk = self._desk
        if "began" in moment:
            desk.now_ns = _time(moment["began"])
            self.begin_step()
        desk.now_ns = _time(moment["at"])
        desk.wall_ns += BETWEEN_NS
        desk.terminals[:] = [self.terminal(each) for each in moment.get("terminals", ())]
        desk.display.windows = [_told_window(each) for each in moment.get("windows", ())]
        desk.python.clear()
        desk.python.update(moment.get("python", {}))
        self._told = moment
        self.answer = moment.get("answer", "")
        for topic, arrivals in moment.get("heard", {}).items():
            heard = self._heard.setdefault(topic, Heard())
            for when, (kind, content), sender in arrivals:
                heard.add(Arrival(_time(when), _message_of(kind, content), sender))
        if "files" in moment:
            self.lay(moment["files"])

    def nodes(self) -> list[str]:
        return list(self._told["nodes"][""])

    def topics(self) -> dict[str, list[str]]:
        return dict(self._told["topics"][""])

    def publishers(self, topic: str) -> list[str]:
        return list(self._told["publishers"][topic])

    def subscribers(self, topic: str) -> list[str]:
        return list(self._told["subscribers"][topic])

    def servers(self, service: str) -> list[str]:
        return list(self._told["servers"][service])

    def parameter(self, node: str, name: str) -> tuple[bool, Any]:
        answered, value = self._told["parameters"][f"{node} {name}"]
        return answered, value

    def _listen(self, topic: str) -> None:
        """What came is in the moments."""

    def terminal(self, told: Json) -> Any:
        """A terminal as it was."""
        variables = {name: value.replace(HOME, str(self.home)) for name, value in told["variables"].items()}
        return SimpleNamespace(
            closed=told["closed"],
            running=told["running"],
            runs=SimpleNamespace(all=[self._run(each) for each in told["runs"]]),
            shell=SimpleNamespace(environment=variables, cwd=self._place(told.get("cwd", HOME))),
        )

    def _place(self, told: str) -> Path:
        return Path(told.replace(HOME, str(self.home)))

    def _run(self, told: Json) -> Run:
        number, source, began, ended, status, output, *commands = told
        run = Run(number, source, self.home, _time(began))
        run.status, run.ended_ns = status, None if ended is None else _time(ended)
        run.keep(output)
        for each in (
            commands[0] if commands else [[shlex.split(source), source, HOME, began, ended, status, False, output, ""]]
        ):
            run.note(self._ran(each))
        return run

    def _ran(self, told: Json) -> Ran:
        argv, source, cwd, began, ended, status, is_function, screen, elsewhere = told
        argv = [word.replace(HOME, str(self.home)) for word in argv]
        command = SimpleCommand(words=[Word((), source)])
        ran = Ran(argv, command, self._place(cwd), _time(began), is_function)
        ran.keep(screen)
        ran.keep_elsewhere(elsewhere)
        ran.status, ran.ended_ns = status, None if ended is None else _time(ended)
        return ran

    def lay(self, files: Json) -> None:
        """Make the files of the home folder that moments are about what they were."""
        home = self.home
        for name in sorted(self._laid.keys() - files.keys(), reverse=True):
            (home / name).rmdir() if self._laid[name] == "folder" else (home / name).unlink()
        for name, what in files.items():
            path, before = home / name, self._laid.get(name)
            if what == before:
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            if before is not None and (before == "folder") != (what == "folder"):
                path.rmdir() if before == "folder" else path.unlink()
            if what == "folder":
                path.mkdir(exist_ok=True)
            elif what == "link":
                path.unlink(missing_ok=True)
                path.symlink_to("elsewhere")
            else:
                path.write_text(what[1], encoding="utf-8")
                os.utime(path, ns=(BEGAN_NS, BEGAN_NS + what[0] * 10**9))
        self._laid = files


def _time(since: int) -> int:
    return BEGAN_NS + since * 1000


def _message_of(kind: str, content: Json) -> Any:
    message = get_message(kind)()
    set_message_fields(message, deepcopy(content))  # it makes messages of what it is given
    return message


def _told_window(told: Json) -> Any:
    model: Any = None
    if "trail" in told:
        pieces: list[Any] = []
        jumps = []
        for at, stroke in enumerate(told["trail"]):
            begin = len(pieces)
            pieces += [
                SimpleNamespace(
                    x1=ax * PIXELS_PER_METRE,
                    y1=-ay * PIXELS_PER_METRE,
                    x0=bx * PIXELS_PER_METRE,
                    y0=-by * PIXELS_PER_METRE,
                )
                for (ax, ay), (bx, by) in pairwise(stroke)
            ]
            if jump := told.get("jumps", {}).get(str(at)):
                jumps.append((begin, len(pieces) if jump == "drew" else begin))
        trail = SimpleNamespace(
            generation=0, drawn=len(pieces), jumps=jumps, segments_since=lambda seen: pieces[seen:]
        )  # fmt: skip
        model = SimpleNamespace(trail=trail)
    elif "displays" in told:
        model = SimpleNamespace(fixed_frame=told["frame"], displays=[_display(*each) for each in told["displays"]])
    return SimpleNamespace(kind=told["kind"], model=model)


def _display(kind: str, enabled: bool, lines: Json) -> Any:
    statuses = StatusList("Status")
    for level, name, text in lines:
        statuses.put(level, name, text)
    return SimpleNamespace(type=kind, enabled=enabled, statuses=statuses)


def judged_again(moments: Sequence[Json], checks: Sequence[Condition], home: Path, folder: Path) -> list[Json]:
    """The verdicts of the checks of one step in each of its moments."""
    desk = ToldDesk(home)
    live = ToldLive(desk, None, folder)
    found = []
    for moment in moments:
        live.show(moment)
        found.append([verdict_json(check.judge(live), home) for check in checks])
    return found


# -- small and the same ----------------------------------------------------------------------------------------------------


def thinned(told: Json, messages: int, characters: int) -> Json:
    """The same with at most so many new messages of a topic in a moment, and so much of the end of an output."""
    if isinstance(told, list):
        return [thinned(each, messages, characters) for each in told]
    if not isinstance(told, dict):
        return told
    found = {key: thinned(each, messages, characters) for key, each in told.items() if key not in ("heard", "runs")}
    if "heard" in told:
        found["heard"] = {topic: _some(each, messages) for topic, each in told["heard"].items()}
    if "runs" in told:
        found["runs"] = [
            [*run[:5], _end(run[5], characters), [_thinned(ran, characters) for ran in run[6]]] for run in told["runs"]
        ]
    return found


def _thinned(ran: Json, characters: int) -> Json:
    return [*ran[:-2], *(_end(text, characters) for text in ran[-2:])]


def _end(text: str, characters: int) -> str:
    return text[-characters:] if characters else ""


def _some(arrivals: Json, most: int) -> Json:
    if len(arrivals) <= most:
        return arrivals
    last = len(arrivals) - 1
    return [arrivals[round(at * last / (most - 1))] for at in range(most)]


def compact(told: Json, wrong: Callable[[Json], Sequence[Json]]) -> Json:
    """As little of it as has nothing `wrong` still. Raises ValueError if not even all of it is judged as the machine was."""
    if found := wrong(told):
        raise ValueError(f"what was written down is judged otherwise than the machine was: {found[0]}")
    messages = next(each for each in MESSAGES if not wrong(thinned(told, each, CHARACTERS[-1])))
    characters = next(each for each in CHARACTERS if not wrong(thinned(told, messages, each)))
    return thinned(told, messages, characters)


def packed(value: Json) -> Json:
    """The same with everything that is long and comes more than once in a table, once."""
    counts: Counter[str] = Counter()

    def count(each: Json) -> None:
        text = _text(each)
        counts[text] += 1
        if counts[text] > 1:
            return
        for inner in each.values() if isinstance(each, dict) else each if isinstance(each, list) else ():
            count(inner)

    count(value)
    table: list[Json] = []
    numbers: dict[str, int] = {}

    def put(each: Json) -> Json:
        text = _text(each)
        shared = isinstance(each, (str, list, dict)) and len(text) >= LONG and counts[text] > 1
        if shared and text in numbers:
            return {"=": numbers[text]}
        if isinstance(each, dict):
            each = {key: put(inner) for key, inner in each.items()}
        elif isinstance(each, list):
            each = [put(inner) for inner in each]
        if not shared:
            return each
        numbers[text] = len(table)
        table.append(each)
        return {"=": numbers[text]}

    told = put(value)
    return {"table": table, "told": told}


def unpacked(value: Json) -> Json:
    """What `packed` was given."""
    table: list[Json] = []

    def take(each: Json) -> Json:
        if isinstance(each, dict):
            return table[each["="]] if "=" in each else {key: take(inner) for key, inner in each.items()}
        return [take(inner) for inner in each] if isinstance(each, list) else each

    for each in value["table"]:
        table.append(take(each))
    return take(value["told"])


def _text(value: Json) -> str:
    return json.dumps(value, ensure_ascii=False, sort_keys=True)


def read_lines(path: Path) -> list[Json]:
    """The histories of a file, one a line."""
    return [unpacked(json.loads(line)) for line in path.read_text(encoding="utf-8").splitlines()]


def write_lines(path: Path, histories: Sequence[Json]) -> None:
    path.write_text("".join(f"{_text(packed(each))}\n" for each in histories), encoding="utf-8")
