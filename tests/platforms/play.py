"""Plays a feature as a user does: types its commands and keys, and looks at what comes."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from day6_core.parts import PROJECTS
from tests.e2e.keys import KEYS
from tests.e2e.mouse import Mouse
from tests.e2e.place import DAY6, Place
from tests.platforms.features import REASONS, Feature
from tests.support.free_port import free_port
from tests.support.waiting import run, until

LIMIT = 120.0
"""Seconds that a command may take, with a core to itself; `colcon build` takes 40 under Wine."""
MOST = 2000
"""Characters kept of what came instead."""
YES = "yes"
_ACT = re.compile(r"(\w*)([$>]) ?(.*)")


class Act(NamedTuple):
    """What is typed, and what must be seen then."""

    where: str
    sign: str
    typed: str
    seen: list[str]


def acts(feature: Feature) -> list[Act]:
    """Return what its text says."""
    found: list[Act] = []
    for line in feature.typed.strip().splitlines():
        if act := _ACT.fullmatch(line):
            where = act[1] or (found[-1].where if act[2] == ">" else "")
            found.append(Act(where, act[2], act[3], []))
        else:
            found[-1].seen.append(line)
    return found


def play(feature: Feature, folder: Path) -> str:
    """Return "yes"; or "no: " and the words in which day6-tui says that it isn't there; or "fails: " and how."""
    try:
        with ExitStack() as stack:
            _Player(feature, folder, stack).play()
    except ModuleNotFoundError as error:  # a library that the tests need, too
        top = str(error.name).partition(".")[0]
        said = f"needs {PROJECTS.get(top, top)}, which isn't installed"
    except (
        Exception,
        pytest.skip.Exception,
    ) as error:  # whatever it is on a system that nobody has seen: the others go on
        # A command that doesn't end tells what it has printed beside it (`communicate`).
        parts = (part for each in error.args for part in (each if isinstance(each, tuple) else [each]))
        said = "\n".join(map(str, parts)) or repr(error)
    else:
        return YES
    said = re.sub(r"-\n\s*", "-", said)  # where a line of the screen ended
    for pattern, _ in REASONS:
        if found := re.search(rf"[^\n│]*{pattern}", said):
            return f"no: {' '.join(found[0].split())[-MOST:]}"
    return f"fails: {said[-MOST:]}"


class _Player:
    def __init__(self, feature: Feature, folder: Path, stack: ExitStack) -> None:
        self._acts, self._files, self._folder, self._stack = acts(feature), feature.files, folder, stack
        self._places: dict[str, Place] = {}
        self._screens: dict[str, Any] = {}
        self._printed = folder / "printed.txt"
        """What goes on in the background prints."""
        self._port = str(free_port())

    def play(self) -> None:
        for number, (where, sign, typed, seen) in enumerate(self._acts):
            typed, seen = typed.replace("PORT", self._port), [text.replace("PORT", self._port) for text in seen]
            if sign == ">":
                self._type(self._screens[where], typed)
            elif where == "browser":
                self._screens[where] = self._page(self._link(typed))
            elif typed.endswith(" &"):
                process = self._start(where, typed[:-2])
                until(lambda: self._has_said(seen) or process.poll() is not None, LIMIT, every=0.1, told=self._read)  # noqa: B023
                assert self._has_said(seen), f"{typed}:\n{self._read()}"
                continue
            elif where or (self._acts[number + 1 : number + 2] and self._acts[number + 1].sign == ">"):
                self._screens[where] = self._open(where, typed)
            else:
                self._run(where, typed, seen)
                continue
            if typed == "Esc":  # what the last key has opened goes
                self._screens[where].wait_gone(*self._acts[number - 1].seen, limit=LIMIT)
            self._screens[where].wait(*seen, limit=LIMIT)
        for screen in self._screens.values():
            screen.quit()
            assert screen.wait_end(LIMIT) == 0, f"it ended with status {screen.status}: {screen.look()}"

    # -- where it is typed ---------------------------------------------------------------------------------------------

    def _place(self, where: str) -> Place:
        if where not in self._places:
            folder = self._folder / (where or "here")
            folder.mkdir()
            self._places[where] = place = Place(folder)
            self._stack.callback(place.close)
            place.home.mkdir()
            place.link = os.environ.get("DAY6_LINK")
            for name, text in self._files.items():
                place.file(name, text)
        return self._places[where]

    def _words(self, where: str, typed: str) -> tuple[Place, list[str], dict[str, str | None]]:
        """A place, the words after `day6-tui`, and variables: nothing is the user's own, neither ROS nor the home."""
        place, words = self._place(where), shlex.split(typed)
        home = str(place.home)
        env = {name: None for name in os.environ if name.startswith(("DAY6_", "ROS_", "XDG_"))} | {"DAY6_LANG": "en"}
        env |= place.environment(HOME=home, USERPROFILE=home, LOCALAPPDATA=home)
        while "=" in words[0]:
            name, _, env[name] = words.pop(0).partition("=")
        assert words.pop(0) == "day6-tui"
        return place, words, env

    # -- commands ------------------------------------------------------------------------------------------------------

    def _run(self, where: str, typed: str, seen: list[str]) -> None:
        place, words, env = self._words(where, typed.removeprefix("! "))
        done = run([*DAY6, *words], "", LIMIT, cwd=place.work, env=place.variables(**env))
        printed = done.stdout + done.stderr
        missing = [text for text in seen if text not in printed]
        assert bool(done.returncode) == typed.startswith("! ") and not missing, (
            f"{typed}: status {done.returncode}, no {missing} in\n{printed}"
        )

    def _start(self, where: str, typed: str) -> subprocess.Popen[Any]:
        place, words, env = self._words(where, typed)
        with self._printed.open("a", encoding="utf-8") as printed:
            process = subprocess.Popen(
                [*DAY6, *words],
                stdin=subprocess.DEVNULL,
                stdout=printed,
                stderr=subprocess.STDOUT,
                cwd=place.work,
                env=place.variables(**env),
            )
        self._stack.callback(_end, process)
        return process

    def _read(self) -> str:
        return self._printed.read_text(encoding="utf-8", errors="replace")

    def _has_said(self, seen: list[str]) -> bool:
        printed = self._read()
        return all(text in printed for text in seen)

    def _link(self, name: str) -> str:
        """The link that `serve` printed."""
        return next(line.rpartition(" ")[2] for line in self._read().splitlines() if f": {name}: http" in line)

    # -- screens -------------------------------------------------------------------------------------------------------

    def _open(self, where: str, typed: str) -> Any:
        place, words, env = self._words(where, typed)
        if os.name == "posix":
            screen: Any = place.terminal(*words, **env)
        else:
            from tests.windows.console import Console

            screen = Console([sys.executable, "-m", "day6_tui.main", *words], place.work, place.variables(**env))
        self._stack.enter_context(screen)
        if where == "pixels":
            from tests.platforms.screens import Pixels

            return Pixels(screen)
        return screen

    def _page(self, link: str) -> Any:
        from tests.platforms.screens import Page

        return self._stack.enter_context(Page(link))

    def _type(self, screen: Any, typed: str) -> None:
        if typed.startswith("click "):
            Mouse(screen).click_on(typed[6:])
        elif typed:
            screen.send(KEYS.get(typed, f"{typed}\r"))


def _end(process: subprocess.Popen[Any]) -> None:
    process.terminate()
    try:
        process.wait(20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
