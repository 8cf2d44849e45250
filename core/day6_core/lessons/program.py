"""The program behind the lesson window."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.lessons.course import new_course

if TYPE_CHECKING:
    from day6_core.session.session import Main, Session
    from day6_core.shell.desk import Desk


def lessons_of(
    desk: Desk, pupil: str, folder: Path | None, first: str = "", demo: str = "", since_ns: int | None = None
) -> Main:
    """The main function of a program that opens the window.

    `first` is a lesson that is opened at once, or the drills of an exam; with `demo`, a language, it is played by itself from its
    beginning. `since_ns`: when it was asked for, as for `new_course`.
    """

    async def main(session: Session) -> int:
        course = await new_course(desk, session, pupil, folder, since_ns)
        if len(drills := first.split()) > 1:
            course.start_exam(drills)
        elif first:
            course.open(first, "*" if demo else "")
        else:
            course.open_last()
        if demo:
            course.demonstrate(demo)
        if session.display is not None:  # only now: a list needs the keyboard, a step leaves it to the terminal
            session.display.open("lesson", "Lessons", course)
        await course.run()
        return 0

    return main
