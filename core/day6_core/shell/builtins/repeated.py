"""xargs and watch: commands that run another command again and again."""

from __future__ import annotations

import shlex
from itertools import chain

from day6_core.session.session import Session
from day6_core.session.streams import InputStream
from day6_core.shell.builtins.options import UsageError, complain, parse
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.subshells import subshell_main

MOST_ARGUMENTS = 5000
"""Most arguments of one command that xargs runs."""


async def xargs(session: Session) -> int:
    """`xargs [-0r] [-n N] [-L N] [-I TEXT] [-d CHARACTER] [COMMAND …]`: words of the standard input become arguments."""
    split = _first_operand(session.argv, "nIdPL")
    try:
        # Among our tools `-3` is short for `-n 3`; here -0 is an option of its own.
        words = ["--null" if word == "-0" else word for word in session.argv[:split]]
        options, _ = parse(words, "0rt", "nIdPL", {"--null": "0", "--no-run-if-empty": "r"})
        most = int(options.get("L", options.get("n", MOST_ARGUMENTS)))
    except (UsageError, ValueError) as error:
        complain(session, error)
        return 1
    command = session.argv[split:] or ["echo"]
    text = await session.stdin.read_all()
    try:
        words = _words(text, options)
    except ValueError:
        complain(session, "unmatched quote; by default quotes are special to xargs unless you use the -0 option")
        return 1
    if "I" in options:
        calls = [[part.replace(options["I"], word) for part in command] for word in words]
    elif "L" in options:
        lines = [shlex.split(line) for line in text.splitlines() if line.strip()]
        calls = [[*command, *chain(*lines[at : at + most])] for at in range(0, len(lines), most)]
    else:
        calls = [[*command, *words[at : at + most]] for at in range(0, len(words), most)]
    if not calls and "r" not in options and "I" not in options:
        calls = [command]
    status = 0
    for call in calls:
        if "t" in options:
            session.print_error(shlex.join(call))
        ended = await _run(session, shlex.join(call))
        if ended == 255:
            complain(session, f"{call[0]}: exited with status 255; aborting")
            return 124
        status = status or (123 if 1 <= ended <= 125 else ended)
    return status


def _words(text: str, options: dict[str, str]) -> list[str]:
    if "0" in options or "d" in options:
        separator = "\0" if "0" in options else options["d"].encode().decode("unicode_escape")
        return [word for word in text.removesuffix("\n").split(separator) if word or separator != "\0"]
    if "I" in options:
        return [line.strip() for line in text.splitlines() if line.strip()]
    return shlex.split(text)


async def watch(session: Session) -> int:
    """`watch [-n SECONDS] [-t] COMMAND …`: shows the command's output, refreshed every two seconds, until Ctrl-C."""
    split = _first_operand(session.argv, "n")
    try:
        options, _ = parse(session.argv[:split], "tcdex", "n", {"--interval": "n", "--no-title": "t"})
        seconds = max(0.1, float(options.get("n", "2")))
    except (UsageError, ValueError) as error:
        complain(session, error)
        return 1
    line = " ".join(session.argv[split:])
    if not line:
        session.print_error("Usage: watch [options] command")
        return 1
    shell = shell_of(session)
    if session.stdout.isatty():
        session.stdout.control("\x1b[?1049h")
        session.defer(lambda: session.stdout.control("\x1b[?1049l"))
    while True:
        inner = shell.clone()
        session.on_interrupt = inner.interrupt
        found = await inner.output_of(line, Streams(InputStream(), session.stdout, session.stdout))
        session.on_interrupt = None
        title = "" if "t" in options else f"Every {seconds:.1f}s: {line}\n\n"
        if session.stdout.isatty():
            session.stdout.control("\x1b[H\x1b[2J")
        session.stdout.write(f"{title}{found}\n")
        await session.sleep(seconds)


async def _run(session: Session, line: str) -> int:
    inner = shell_of(session).clone()
    streams = Streams(InputStream(), session.stdout, session.stderr)
    return (await subshell_main(inner, lambda: inner.run(line, streams))(session)) or 0


def _first_operand(argv: list[str], with_value: str) -> int:
    """Where the command begins: behind the options and their values."""
    at = 1
    while at < len(argv) and argv[at].startswith("-") and argv[at] != "-":
        takes_next = len(argv[at]) == 2 and argv[at][1] in with_value
        at += 2 if takes_next else 1
    return min(at, len(argv))
