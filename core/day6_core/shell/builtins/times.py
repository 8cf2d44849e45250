"""sleep, timeout, date. Time is the world's: it stands still while the world is paused."""

from __future__ import annotations

import time

from day6_core.session.clock import NANOSECONDS, nanoseconds
from day6_core.session.session import Session
from day6_core.session.signals import NUMBERS
from day6_core.session.task import wait_for
from day6_core.shell.builtins.options import UsageError, complain, parse
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.language.redirection import Streams

_UNITS = {"s": 1, "m": 60, "h": 3600, "d": 86400}


def _seconds(text: str) -> float:
    """`1.5`, `2m`: raises ValueError for anything else."""
    unit = _UNITS.get(text[-1:], 0)
    value = float(text[:-1] if unit else text)
    if not 0 <= value < 1e9:
        raise ValueError(text)
    return value * (unit or 1)


MOST_SECONDS = 1e8
"""Three years: the length of `sleep infinity`, and the longest wait that every clock can represent."""


async def sleep(session: Session) -> int:
    if len(session.argv) < 2:
        session.print_error("sleep: missing operand\nTry 'sleep --help' for more information.")
        return 1
    total = 0.0
    for word in session.argv[1:]:
        try:
            total += MOST_SECONDS if word in ("inf", "infinity") else min(_seconds(word), MOST_SECONDS)
        except ValueError:
            session.print_error(f"sleep: invalid time interval ‘{word}’\nTry 'sleep --help' for more information.")
            return 1
    await session.sleep(total)
    return 0


async def timeout(session: Session) -> int:
    """`timeout [-s SIGNAL] [-k SECONDS] SECONDS COMMAND …`: 124 when the time was up."""
    from day6_core.shell.commands import find_command

    try:
        split = _operand_index(session.argv)
        options, _ = parse(
            session.argv[:split], "v", "sk", {"--signal": "s", "--kill-after": "k", "--preserve-status": "v"}
        )
        limit = _seconds(session.argv[split])
        grace = _seconds(options["k"]) if "k" in options else 2.0
    except UsageError as error:
        complain(session, error)
        return 125
    except ValueError as error:
        complain(
            session,
            f"invalid time interval ‘{error.args[0] if not str(error).startswith('could') else session.argv[split]}’"
            "\nTry 'timeout --help' for more information.",
        )
        return 125
    except IndexError:
        session.print_error("Try 'timeout --help' for more information.")
        return 125
    argv = session.argv[split + 1 :]
    if not argv:
        session.print_error("Try 'timeout --help' for more information.")
        return 125
    name = options.get("s", "TERM")
    number = int(name) if name.isdigit() else NUMBERS.get(name.upper().removeprefix("SIG"), 15)
    shell = shell_of(session)
    streams = Streams(session.stdin, session.stdout, session.stderr)
    program = shell.desk.start_program(
        argv, find_command(argv[0], shell), streams, env=session.env, cwd=session.cwd, shell=shell
    )
    shell.note(program.session)

    def interrupt() -> bool:
        program.interrupt()
        return True

    def on_stop(stopped: bool) -> None:
        (program.stop if stopped else program.resume)()

    session.on_interrupt, session.on_stop = interrupt, on_stop
    program.session.on_own_stop = session.on_own_stop
    session.defer(program.kill)
    deadline = session.clock.steady_ns() + nanoseconds(limit) if limit else None
    if await wait_for(program.done, deadline):
        if program.killed_by == 2:
            raise KeyboardInterrupt
        return program.status or 0
    program.send(number)
    if not await session.wait(program.done, grace):
        program.kill()
        await program.wait()
        return 137
    return (program.status or 0) if "v" in options else 124


def _operand_index(argv: list[str]) -> int:
    """Index of the first word that is neither an option nor the value of one. Raises IndexError if there is none."""
    index = 1
    while argv[index].startswith("-"):
        index += 2 if argv[index] in ("-s", "-k", "--signal", "--kill-after") else 1
    return index


async def date(session: Session) -> int:
    """`date [-u] [+FORMAT]`, by the real clock, like the stamps of logs."""
    words = session.argv[1:]
    utc = "-u" in words
    words = [word for word in words if word != "-u"]
    now = session.clock.now_ns()
    moment = (time.gmtime if utc else time.localtime)(now // NANOSECONDS)
    pattern = "+%a %b %e %I:%M:%S %p %Z %Y" if not words else words[0]
    if not pattern.startswith("+"):
        session.print_error(f"date: invalid date ‘{pattern}’")
        return 1
    pattern = pattern.replace("%N", f"{now % NANOSECONDS:09d}").replace("%s", str(now // NANOSECONDS))
    if utc:
        pattern = pattern.replace("%Z", "UTC")  # which Python calls GMT
    session.print(time.strftime(pattern[1:].replace("%e", f"{moment.tm_mday:>2}"), moment))
    return 0
