"""What `lessons play` tells an author, and what no lesson may do to the machine it is played on."""

from __future__ import annotations

import sys
from collections.abc import Awaitable, Callable
from itertools import count
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.lessons.lag import Lag
from day6_core.lessons.live import Live, OutsideHome
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.rehearsal import Played, rehearse
from day6_core.lessons.stage import Stage
from day6_core.session.session import Session
from day6_core.virtual.surroundings import is_there
from tests.support.waiting import PATIENCE, run

HEAD = "---\nlesson: small\norder: 1\nminutes: 5\ntitle: {zh: 课, en: Lesson}\n---\n"
TEXT = "\n## {language} Title\n\ntext\n\n### do\n\ndo\n\n### hints\n\n1. one\n2. two\n3. three\n"


def play(
    tmp_path: Path, only: str | None = None, told: Callable[[Played], None] = lambda _: None, **steps: str
) -> list[Played]:
    text = HEAD
    for name, block in steps.items():
        text += f"\n# {name}\n\n~~~yaml\n{block}~~~\n{TEXT.format(language='zh')}{TEXT.format(language='en')}"
    path = tmp_path / "lesson.md"
    path.write_text(text, encoding="utf-8")
    return rehearse(read_lesson(path), tmp_path / "home", told, only)


DATED = """check:
  - file: {path: ~/date, has: '2026-01-01 00:00:2'}
solve:
  - type: sleep 20; python3 -c 'import datetime; print(datetime.datetime.utcnow())' > date
"""


@pytest.mark.process
@pytest.mark.skipif(not is_there(), reason="there is no virtual time on this system")
def test_a_lesson_is_played_in_virtual_time_unless_real_time_is_wanted(tmp_path: Path) -> None:
    path = tmp_path / "lesson.md"
    text = f"{HEAD}\n# one\n\n~~~yaml\n{DATED}~~~\n{TEXT.format(language='zh')}{TEXT.format(language='en')}"
    path.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "day6_tui.main", "lessons", "play", str(path)]
    done, again = run(command), run(command)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout
    assert done.stdout == again.stdout and done.stdout.startswith("ok    20.")
    real = text.replace("'2026-01-01 00:00:2'", "real").replace("sleep 20; ", "echo ${DAY6_TIME:-real} > date #")
    path.write_text(real, encoding="utf-8")
    done = run([*command, "--real-time"])
    assert (done.returncode, done.stderr) == (0, ""), done.stdout


@pytest.mark.process
def test_a_step_without_a_solution_is_told_at_once(tmp_path: Path) -> None:
    (played,) = play(tmp_path, one="check:\n  - file: ~/one\n")
    assert played.faults == ["has no 'solve' (the actions that solve it), so it cannot be played"]
    assert played.seconds == 0.0


@pytest.mark.process
def test_a_wrong_answer_is_told_with_its_line_and_with_what_holds(tmp_path: Path) -> None:
    text = "check:\n  - file: ~/one\nsolve:\n  - type: touch one\nwrong:\n  - do:\n      - type: touch one\n    says: There is\n"
    (played,) = play(tmp_path, one=text)
    lines = (tmp_path / "lesson.md").read_text(encoding="utf-8").split("\n")
    line = lines.index("  - do:") + 1
    assert played.faults == [f"takes the wrong answer 1 (line {line}) for right: 'the file ~/one exists' holds"]


@pytest.mark.process
@pytest.mark.parametrize(
    ("stalls", "faults"),
    [
        ([0.0], 1),
        ([0.7, 0.0], 0),
        ([0.7, 0.7, 0.7], 1),
    ],
    ids=["it kept up", "it stood still once", "it stood still each time"],
)
def test_a_wrong_answer_during_which_the_machine_stood_still_is_played_again(
    stalls: list[float], faults: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = [*stalls, 0.0]  # the last one is the solution's

    async def watch(lag: Lag, session: Session) -> None:
        lag.add(left.pop(0))

    monkeypatch.setattr(Lag, "watch", watch)
    once = "" if stalls[-1] else "[ -e twice ] || "
    text = "check:\n  - file: ~/one\nsolve:\n  - type: touch one\nwrong:\n  - do:\n      - type: |\n"
    text += f"          {once}touch one; touch twice\n    says: not yet\n    undo:\n      - type: rm -f one\n"
    (played,) = play(tmp_path, one=text)
    assert left == [] and len(played.faults) == faults
    assert all(("(this machine stood still for 0.7 s)" in fault) == bool(stalls[-1]) for fault in played.faults)


@pytest.mark.process
@pytest.mark.parametrize(
    ("stalls", "faults"),
    [
        ([0.0], 1),
        ([0.2, 0.0], 0),
        ([0.2, 0.2, 0.2], 1),
    ],
    ids=["it kept up", "it stood still once", "it stood still each time"],
)
def test_a_solution_that_goes_wrong_while_the_machine_stands_still_is_played_again(
    stalls: list[float], faults: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = [0.0, stalls[0], 0.0, *stalls[1:]]  # three steps, then the second one again
    number = count()

    def watch(lag: Lag, session: Session) -> Awaitable[None]:
        lag.add(left.pop(0))
        goes_wrong = (at := next(number)) == 1 or (at > 2 and stalls[-1] > 0)  # what goes well may take its time
        monkeypatch.setattr("day6_core.lessons.rehearsal.SOLVED_WITHIN", 0.5 if goes_wrong else PATIENCE)
        return session.sleep(0)

    monkeypatch.setattr(Lag, "watch", watch)
    told: list[str] = []
    works = "false" if stalls[-1] or not any(stalls) else f"test -e {tmp_path}/once"
    steps = {
        "one": "check:\n  - file: ~/one\nsolve:\n  - type: touch one\n",
        "two": f"needs: [one]\ncheck:\n  - file: ~/two\nsolve:\n  - type: {works} && cp one two; touch {tmp_path}/once\n",
        "three": "check:\n  - file: ~/three\nsolve:\n  - type: touch three\n",
    }
    played = play(tmp_path, told=lambda step: told.append(step.step), **steps)
    assert left == [] and [each.step for each in played] == ["one", "two", "three"]
    assert told == (["one", "three", "two"] if stalls[0] else ["one", "two", "three"])
    assert [len(each.faults) for each in played] == [0, faults, 0]
    assert all(("(this machine stood still for 0.2 s)" in fault) == bool(stalls[-1]) for fault in played[1].faults)


UNDONE = """check:
  - file: ~/one
solve:
  - terminal: idle
  - type: test -e undone && touch one
wrong:
  - do:
      - type: ls
    says: not yet
    undo:
      - type: sleep {seconds}; touch undone
"""


@pytest.mark.process
def test_what_cleans_up_after_a_wrong_answer_has_ended_when_the_next_thing_is_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    second.mkdir()
    (played,) = play(first, one=UNDONE.format(seconds=0.5))
    assert played.faults == []
    until_line_ends = Stage.until_line_ends

    async def for_a_moment(stage: Stage) -> None:
        monkeypatch.setattr("day6_core.lessons.stage.LONGEST_WAIT", 0.5)  # only here: terminals begin before
        await until_line_ends(stage)

    monkeypatch.setattr(Stage, "until_line_ends", for_a_moment)
    (played,) = play(second, one=UNDONE.format(seconds=1000))
    (fault,) = played.faults
    assert fault.startswith("could not be played, the wrong answer 1 (line 17), undo: it ends with  sleep 1000  which")


@pytest.mark.process
def test_what_was_seen_is_not_taken_for_what_is_wanted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.lessons.rehearsal.SOLVED_WITHIN", 0.2)
    (played,) = play(tmp_path, one="check:\n  - window: turtlesim\nsolve:\n  - type: ls\n")
    (fault,) = played.faults
    assert "not yet 'the window turtlesim is open' (seen: No window is open.)" in fault.replace("“", "")


@pytest.mark.process
def test_one_step_is_played_after_those_it_needs(tmp_path: Path) -> None:
    steps = {
        "one": "check:\n  - file: ~/one\nsolve:\n  - type: touch one\n",
        "two": "check:\n  - file: ~/two\nsolve:\n  - type: touch two\n",
        "three": "needs: [one]\ncheck:\n  - file: ~/three\nsolve:\n  - type: cp one three\n",
    }
    played = play(tmp_path, "three", **steps)
    assert [(each.step, each.faults) for each in played] == [("three", [])]
    assert not (tmp_path / "home" / "two").exists()


@pytest.mark.process
def test_a_link_does_not_lead_a_lesson_out_of_the_home_folder(tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    steps = f"check:\n  - file: ~/out/x\nsolve:\n  - type: ln -s {outside} out\n  - wait: {{folder: ~/out}}\n"
    (played,) = play(tmp_path, one=f"{steps}  - write: {{file: ~/out/x, text: a}}\n")
    assert played.faults == ["could not be played, solve: ~/out/x is not in the home folder"]
    assert list(outside.iterdir()) == []


@pytest.mark.parametrize("path", ["/etc/passwd", "../../x.txt", "~/../x", "~/a/../../x"])
def test_no_check_and_no_action_looks_outside_of_the_home_folder(tmp_path: Path, path: str) -> None:
    home: Any = SimpleNamespace(home=tmp_path / "home")
    with pytest.raises(OutsideHome, match="is not in the home folder"):
        Live.path(home, path)
    assert Live.path(home, "~/a/../b") == tmp_path / "home" / "a" / ".." / "b"
