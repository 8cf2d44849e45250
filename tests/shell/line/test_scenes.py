"""What is on the screen after keys: lines being edited, history, Tab, prompts, pages, lists. The scenes are in `scenes.jsonl`.

`python -m tests.shell.line.test_scenes` plays them all and writes what it sees; look at the difference before you keep it.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import pytest

SCENES = Path(__file__).parent / "scenes.jsonl"


class Scene(NamedTuple):
    """A terminal of so many columns and rows, and what is typed there in turn; two numbers are a new size of the window."""

    name: str
    size: list[int]
    keys: list[str | list[int]]
    screen: list[str]
    cursor: list[int]
    above: int
    """Lines in the scrollback."""


def read() -> list[Scene]:
    return [Scene(**json.loads(line)) for line in SCENES.read_text(encoding="utf-8").splitlines()]


def played(seat: Any, scene: Scene) -> Scene:
    """Return the scene as it looks now."""
    seat.type("PS1='$ '; clear\r")
    for keys in scene.keys:
        if isinstance(keys, str):
            seat.type(keys)
        else:
            seat.terminal.resize(*keys)
            seat.settle()
    rows = seat.look().split("\n")
    screen = seat.terminal.screen
    return scene._replace(screen=rows, cursor=[screen.cursor.x, screen.cursor.y], above=len(screen.scrollback))


@pytest.mark.parametrize("scene", read(), ids=lambda scene: scene.name)
def test_the_screen_shows(machine: Any, scene: Scene) -> None:
    from tests.shell.conftest import Seat

    assert played(Seat(machine.desk, *scene.size), scene) == scene


if __name__ == "__main__":
    from tests.shell.conftest import Machine, Seat

    lines = []
    for scene in read():
        with tempfile.TemporaryDirectory() as folder:
            machine = Machine(Path(folder) / "home")
            lines.append(json.dumps(played(Seat(machine.desk, *scene.size), scene)._asdict(), ensure_ascii=False))
            machine.desk.close()
    SCENES.write_text("\n".join([*lines, ""]), encoding="utf-8")
