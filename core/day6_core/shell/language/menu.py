"""`select`: a numbered menu, and an answer for each run of its body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.shell.language import syntax
from day6_core.shell.language.control_flow import run_body
from day6_core.shell.language.redirection import Streams

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


async def run_select(shell: Shell, command: syntax.For, words: list[str], streams: Streams) -> None:
    """Ask until the input ends or the body says `break`."""
    shown = True
    status = 0
    while words:
        if shown:
            streams.stderr.write(menu(words, int(shell.variables.get("COLUMNS") or 80)))
        streams.stderr.write(shell.variables.get("PS3", "#? "))
        if await shell.run("read -r", streams):
            streams.stdout.write("\n")
            status = 1
            break
        reply = shell.variables.get("REPLY", "")
        shown = not reply
        if shown:
            continue
        number = int(reply) if reply.strip().isdigit() else 0
        shell.variables[command.name] = words[number - 1] if 1 <= number <= len(words) else ""
        status, goes_on = await run_body(shell, command.body, streams)
        if not goes_on:
            break
        shown = not shell.variables.get("REPLY")
    shell.status = status


def menu(words: list[str], width: int) -> str:
    """The numbered words, in as many columns as fit."""
    digits = len(str(len(words)))
    room = max(map(len, words)) + digits + 4
    rows = -(-len(words) // max(width // room, 1))
    columns = -(-len(words) // rows)
    if rows == 1:
        rows, columns = columns, 1
    lines = []
    for row in range(rows):
        line, place = "", 0
        for number in range(row, len(words), rows):
            cell = f"{number + 1:>{digits if place else len(str(rows))}}) {words[number]}"
            line += cell
            if number + rows < len(words):
                line += _gap(place + len(cell), place + room)
            place += room
        lines.append(line + "\n")
    return "".join(lines)


def _gap(start: int, end: int) -> str:
    """White space from one column to another, with tabs where they fit."""
    found = ""
    while start < end:
        tab = end // 8 > start // 8
        found += "\t" if tab else " "
        start += 8 - start % 8 if tab else 1
    return found
