"""tput, stty, dircolors, lesspipe: the commands with which a .bashrc queries the terminal and its colours."""

from __future__ import annotations

from day6_core.session.session import Session
from day6_core.shell.language.refusals import Refused

_SEQUENCES = {
    "clear": "\x1b[H\x1b[2J",
    "bold": "\x1b[1m",
    "dim": "\x1b[2m",
    "smul": "\x1b[4m",
    "rmul": "\x1b[24m",
    "rev": "\x1b[7m",
    "sgr0": "\x1b(B\x1b[m",
    "civis": "\x1b[?25l",
    "cnorm": "\x1b[?25h",
}


async def tput(session: Session) -> int:
    """`tput NAME [NUMBER]`: the sequence of the terminal, or its size."""
    words = session.argv[1:]
    if not words:
        session.print_error("usage: tput [-V] [-S] [-T terminal-type] capname")
        return 2
    name = words[0]
    numbers = [int(word) for word in words[1:] if word.isdigit()]
    if name in ("cols", "lines", "colors"):
        rows = session.stdout.terminal.rows if session.stdout.terminal is not None else 24
        session.print({"cols": session.stdout.columns, "lines": rows, "colors": 256}[name])
        return 0
    if name in ("setaf", "setab") and numbers:
        kind = 3 if name == "setaf" else 4
        colour = f"{kind}{numbers[0]}" if numbers[0] < 8 else f"{kind}8;5;{numbers[0]}"
        session.stdout.control(f"\x1b[{colour}m")
        return 0
    if name not in _SEQUENCES:
        session.print_error(f"tput: unknown terminfo capability '{name}'")
        return 4
    session.stdout.control(_SEQUENCES[name])
    return 0


async def stty(session: Session) -> int:
    """`stty size`; what switches Ctrl-S off is accepted, for a .bashrc."""
    terminal, words = session.stdin.terminal_of(), session.argv[1:]
    if terminal is None:
        session.print_error("stty: 'standard input': Inappropriate ioctl for device")
        return 1
    if words == ["size"]:
        session.print(f"{terminal.rows} {terminal.columns}")
    elif set(words) - {"-ixon", "ixon", "sane", "erase", "^?"} or not words:
        session.print_error(Refused(" ".join(session.argv)).told(session.env))
        return 1
    return 0


async def dircolors(session: Session) -> int:
    """`dircolors -b`: commands that set LS_COLORS; `ls` has its own colours here."""
    session.print("LS_COLORS='';\nexport LS_COLORS")
    return 0


async def lesspipe(session: Session) -> int:
    """Do nothing: the real one prints variables with which less shows archives; ours shows text files only."""
    return 0
