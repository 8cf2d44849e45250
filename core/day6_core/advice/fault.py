"""Finds the uncaught exceptions in what a program wrote to its terminal, and where each came from.

Only places in the pupil's own files are told: a line of Python's `inspect.py` helps nobody, and is taken for a line of the
program. What the program had called when it failed says which of two causes of one message it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from day6_core.facts.folders import names_in
from day6_core.ros.environment import python_folders
from day6_core.session.plain import without_sequences

LONGEST = 16 * 1024
"""Characters at the end of an output in which a traceback is looked for."""

_LAUNCHED = re.compile(r"^\[[\w.-]+-\d+\] ", re.MULTILINE)
"""What launch puts before each line of a node."""
_BEGIN = re.compile(
    r"^(?:\[\w+\] \[launch\]: )?(?:Traceback \(most recent call last\):|Caught exception in launch).*\n", re.M
)
_CAUGHT = re.compile(
    r"^(?:Caught exception in launch \(see debug for traceback\): | - )?(?:[\w.]+\.)?(\w*(?:Error|Exception))(?:: (.+))?$"
)
"""An exception as launch names it."""
_RAISED = re.compile(r"^(?:[A-Za-z_][\w.]*\.(?=\w)|(?=[A-Z_]))(\w+)(?:: (.*))?$")
"""The line below a traceback: the only one that begins at the margin."""
_SPINS = re.compile(r"(?:.*\W)?(?:spin\w*|main)\(")
"""A line of the pupil's that only lets others work: what failed is not there."""
_OF_SYNTAX = ("SyntaxError", "IndentationError", "TabError")
_PLACE = re.compile(r'^ *File "([^"]+)", line (\d+)', re.MULTILINE)
_IN_LAUNCH = re.compile(r" \((\S+), line (\d+)\)$")
"""How an exception itself names the place of a syntax error."""

_FOREIGN = re.compile(r".*[\\/](?:site-packages|dist-packages|python3\.\d+)[\\/](\w+)")
"""A module of another Python, in a traceback from another machine."""
_INSTALLED = re.compile(r"(?:^|[\\/])install[\\/](?:.+[\\/])?(?:site|dist)-packages[\\/]")
"""What colcon has built of a workspace: Python calls its folders the same, but it is the pupil's."""
_WRAPPER = re.compile(r"(?:^|[\\/])install[\\/](?:.+[\\/])?(?:lib|bin)[\\/](?:[^\\/]+[\\/])?[^\\/.]+$")
"""The program that setuptools writes for an entry point."""
_OURS = frozenset({"day6_core", "day6_tui", "day6_urdf"})


class _Place(NamedTuple):
    """A place in a traceback."""

    file: str
    line: int
    source: str = ""


@dataclass(frozen=True)
class Fault:
    """One exception: its class without the module, its message, and the last place of its traceback in a file of the pupil."""

    kind: str
    message: str
    file: str = ""
    """'' and line 0 where no file of the pupil took part."""
    line: int = 0
    said: str = ""
    """Its line of the output, as the program wrote it."""
    through: tuple[str, ...] = ()
    """The modules that this place had called when it failed, the innermost last; none if it failed there itself."""
    source: str = ""
    """The line there, as the report shows it."""
    number: int = 0
    """Its number, even where it only lets others work."""

    @property
    def in_words_of_tools(self) -> bool:
        """Whether its message is one of ROS or of the system, and not the program's own words."""
        return not _of_ros().isdisjoint(self.through) or self.message.startswith("[Errno ")

    @property
    def own(self) -> bool:
        """Whether the pupil's own line raised it."""
        return bool(self.line) and not self.through


def fault_in(output: str) -> Fault | None:
    """Return the last exception that a program did not catch, None if its output does not end with one."""
    return next(iter(faults_in(output)), None)


def faults_in(output: str) -> list[Fault]:
    """Return the exceptions in an output, the last first."""
    text = _LAUNCHED.sub("", without_sequences(output[-LONGEST:]).replace("\r\n", "\n"))
    begins = [found.start() for found in _BEGIN.finditer(text)]
    if not begins:  # a syntax error of the program itself has no traceback, only its place
        places = list(_PLACE.finditer(text))
        if not places:
            return []
        begins = [places[-1].start()]
    ends = [*begins[1:], len(text)]
    found = [_fault(text[begin:end]) for begin, end in zip(begins, ends, strict=True)]
    headed = _BEGIN.search(text) is not None
    return [fault for fault in reversed(found) if fault is not None and (headed or fault.kind in _OF_SYNTAX)]


def _fault(text: str) -> Fault | None:
    """The exception of one report, with whatever was printed after it."""
    shape = _CAUGHT if "Caught exception in launch" in text.partition("\n")[0] else _RAISED
    places: list[_Place] = []
    for line in text.split("\n"):
        if (place := _PLACE.match(line)) is not None:
            places.append(_Place(place[1], int(place[2])))
        elif places and not places[-1].source and line.startswith("    "):
            places[-1] = places[-1]._replace(source=line.strip())
        elif (said := shape.match(line.partition("[launch]: ")[2] or line)) is not None:
            return _with_place(said[1], said[2] or "", line, places)
    return None


def _with_place(kind: str, message: str, said: str, places: list[_Place]) -> Fault:
    inner = _IN_LAUNCH.search(message)
    if inner is not None and not places:
        message, places = message[: inner.start()], [_Place(inner[1], int(inner[2]))]
    owners = [module_of(place.file) for place in places]
    if (
        places and places[-1].file == "<string>" and owners[-2:-1] == ["setuptools"]
    ):  # it hands setup.py to exec() as a text
        places[-1], owners[-1] = places[-1]._replace(file="setup.py"), ""
    last = max((index for index, owner in enumerate(owners) if not owner), default=-1)
    place, through = places[last] if last >= 0 else _Place("", 0), tuple(owners[last + 1 :])
    shown = 0 if through and _SPINS.match(place.source) else place.line
    return Fault(kind, message, place.file, shown, said, through, place.source, place.line)


def own_places(output: str) -> Iterator[tuple[str, int]]:
    """Yield the places in files of the pupil that an output names, file and line."""
    for file, line in _PLACE.findall(output):
        if not module_of(file):
            yield file, int(line)


def module_of(file: str) -> str:
    """Return the module outside the pupil's program that a file of a traceback belongs to: 'rclpy'; '' for the pupil's own."""
    if file.startswith("<"):  # nobody can open it
        return file.strip("<>").removeprefix("frozen ").partition(".")[0] or file
    if _INSTALLED.search(file):
        return ""
    path = Path(file)
    for folder in _libraries():
        if folder in path.parents:
            return path.relative_to(folder).parts[0].partition(".")[0]
    if (foreign := _FOREIGN.match(file)) is not None:
        return foreign[1]
    if _WRAPPER.search(file):
        return "setuptools"
    return next((part for part in path.parts if part in _OURS), "")


@lru_cache(maxsize=1)
def _of_ros() -> frozenset[str]:
    """The modules of ROS."""
    return frozenset(name.partition(".")[0] for folder in python_folders() for name in names_in(Path(folder)))


@lru_cache(maxsize=1)
def _libraries() -> tuple[Path, ...]:
    """The folders of this Python and of our ROS, the deepest first."""
    import sysconfig  # few programs fail, and every desktop starts

    names = ("stdlib", "platstdlib", "purelib", "platlib")
    folders = {*map(Path, python_folders()), *(Path(sysconfig.get_path(name)) for name in names)}
    return tuple(sorted(folders, key=lambda folder: -len(folder.parts)))
