"""Checks that somebody else decides: the pupil's answer to a question, a Python file of the lesson."""

from __future__ import annotations

import re
from string import ascii_lowercase
from typing import TYPE_CHECKING

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.terminals import plain_output
from day6_core.lessons.texts import Say
from day6_core.shell.runs import Run

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

SECONDS = 20
"""How long a Python file may take."""

AGAIN = 1.0
"""Seconds until it is asked again."""


@check("answer", event=True, one_of={"letter": tuple(ascii_lowercase)})
def answer(live: Live, letter: str) -> Verdict:
    ok = live.answer == letter
    saw = Say("answer.saw", letter=live.answer) if live.answer else None
    return Verdict(ok, Say("answer"), None if ok else saw)


@check("python", event=True)
def python(live: Live, file: str, zh: str = "", en: str = "") -> Verdict:
    wanted = Say("python.wanted", zh=zh or en, en=en or zh) if zh or en else Say("python", name=file)
    memory = live.remembered
    path = (live.folder / file).resolve()
    if live.folder.resolve() not in path.parents or not path.is_file():
        return Verdict(False, wanted, Say("python.missing", name=file), broken=True)
    now = live.desk.clock.wall_ns()
    if "program" not in memory and now >= memory.get("again", 0):
        memory["program"], memory["run"] = _start(live, str(path)), Run(0, file, live.home, now)
        memory["output"] = memory["program"].session.stdout
        memory["late"] = now + SECONDS * 1_000_000_000
    program = memory.get("program")
    if program is None:
        return memory.get("verdict") or Verdict(False, wanted, Say("python.running"))
    if program.status is None:
        if now <= memory["late"]:
            return memory.get("verdict") or Verdict(False, wanted, Say("python.running"))
        program.kill()
        memory["verdict"] = Verdict(False, wanted, Say("python.late", seconds=SECONDS), broken=True)
    else:
        memory["run"].keep(memory["output"].text)
        last = plain_output(memory["run"]).strip().split("\n")[-1][:200]
        memory["verdict"] = Verdict(program.status == 0, wanted, _said(last) if last else Say("python.silent"))
    del memory["program"]
    memory["again"] = now + AGAIN * 1_000_000_000
    verdict: Verdict = memory["verdict"]
    return verdict


def _said(line: str) -> Say:
    """What a program says at last, in the language of whoever reads it if that is `Chinese (English)`."""
    both = re.fullmatch(r"(.*[\u4e00-\u9fff].*) \(([^()]+)\)", line)
    return Say("python.saw", zh=both[1] if both else line, en=both[2] if both else line)


def _start(live: Live, path: str) -> object:
    from day6_core.session.session import Session
    from day6_core.session.streams import Captured, InputStream
    from day6_core.shell.language.redirection import Streams

    output = Captured()

    async def main(session: Session) -> int:
        return await session.run_python([path])

    environment = live.desk.environment()
    environment["PYTHONNOUSERSITE"] = "1"  # what the pupil installed must not change the lesson's program
    return live.desk.start_program(
        ["python3", path], main, Streams(InputStream(), output, output), env=environment, cwd=live.home
    )
