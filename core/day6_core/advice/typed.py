"""Slips of a typed line itself: a prompt typed with it, a missing blank, a Chinese sign, an answer, a name nearly right."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from day6_core.facts.names import CLOSE, nearest
from day6_core.ros.environment import SHARE_PATH
from day6_urdf.chinese import PUNCTUATION

SHORTEST = 4
"""Letters of a command that can be taken for another's slip."""

_PROMPT = re.compile(r"[\w.-]+@[\w.-]+:\S*[$%#]|[\w./~-]*[$%]")
_OPTION = re.compile(r"-[A-Za-z]{1,2}|--[a-z][\w-]*")
_TAKE_A_NAME = frozenset({"mkdir", "touch", "python3", "source", "nano", "export", "rmdir"})
"""Commands that are nothing without what follows, long enough to be seen in front of it."""

_TAKE_A_PATH = frozenset({"cd", "ls", "cat", "source", "nano", "tree", "mkdir"})
_TAKE_A_NUMBER = frozenset({"sleep", "kill", "fg", "bg"})
_COLCON_VERBS = frozenset({"build", "test", "list", "graph", "info"})
_SHORTEST_NAME = 3
"""Letters after a command that are no slip of its own name."""


class Slip(NamedTuple):
    """What is wrong: the key of its text with its values, and the whole line put right ('' if it is not known)."""

    key: str
    values: dict[str, str]
    right: str = ""


def slip_of_command(name: str, line: str, commands: Iterable[str], letters: str = "") -> Slip | None:
    """Return why there is no command `name`, with which `line` begins; `letters` are the answers that a question waits for."""
    known = list(commands)
    if name in known or not name:
        return None
    if line.strip() == name and len(name) == 1 and name.lower() in letters:
        return Slip("command.answer", {"name": name.lower()})
    if (slip := lacking_in_shell(name)) is not None:
        return slip
    if (
        (setting := re.match(r"(\w+)\s+=\s*(\S.*)$", line.strip())) is not None
        and setting[1] == name
        and name.isidentifier()
    ):
        right = f"{name}={setting[2]}"
        return Slip("command.variable", {"right": right}, right)
    for rule in (_prompt, _apart) if "/" in name else (_prompt, _apart, _other_case, _turned, _near):
        if (slip := rule(name, line, known)) is not None:
            return slip
    return None


def chinese_sign(words: Sequence[str], line: str) -> Slip | None:
    """Return the Chinese punctuation in a word that is English otherwise: such a word is no text, but a slip of the keyboard."""
    for word in words:
        odd = [char for char in word if not char.isascii()]
        if not odd or len(odd) == len(word) or not all(map(_in_code, odd)):
            continue
        right = "".join(_in_code(char) or char for char in line)
        wrong = odd[0]
        if wrong in "。，、．；" and word.endswith(wrong):  # the end of a sentence that was copied with the command
            right = line.replace(word, word.rstrip("。，、．；"))
            return Slip("chinese.end", {"wrong": wrong, "right": word.rstrip("。，、．；")}, right)
        if wrong.isspace():
            return Slip("chinese.blank", {}, right)
        return Slip("chinese.typed", {"wrong": wrong, "right": _in_code(wrong)}, right)
    return None


def lacking_in_shell(line: str) -> Slip | None:
    """Return what a line uses of bash that this terminal does not have, None if it uses nothing of it."""
    plain = re.sub(r"'[^']*'|\"[^\"$]*\"", "''", line)
    if (word := re.match(r"(?:coproc)(?![\w.-])", plain.strip())) is not None:
        return Slip("shell.lacks", {"word": word[0]})
    return None


def near_choice(name: str, choices: Sequence[str]) -> str:
    """Return the one of a few words that was meant; '' if none is near."""
    turned = [choice for choice in choices if _is_turned(name, choice)]
    return turned[0] if turned else nearest(name, choices)


def _in_code(char: str) -> str:
    """The counterpart of a Chinese sign in a command; '' for what has none. A Chinese keyboard gives 、 for the key /."""
    right = "/" if char == "、" else PUNCTUATION.get(char) or unicodedata.normalize("NFKC", char)
    return right if right.isascii() and not char.isascii() and not right.isalnum() else ""


def _prompt(name: str, line: str, commands: list[str]) -> Slip | None:
    """The `$` of a book, or a whole prompt; `$ros2`, which the shell takes for an empty variable."""
    if _PROMPT.fullmatch(name):
        return Slip("command.prompt", {"name": name}, line.strip().removeprefix(name).strip())
    glued = re.match(r"\$(\w+)(?=\s|$)", line.strip())
    if glued is not None and glued[1] in commands and glued[1] != name:
        return Slip("command.prompt", {"name": "$"}, line.strip()[1:])
    return None


def _apart(name: str, line: str, commands: list[str]) -> Slip | None:
    """`cd..`, `ls-l`, `ros2topic`, `mkdirfoo`, `echo"a"`: a command, and what follows without a blank."""
    typed = line.strip()
    for command in sorted(commands, key=len, reverse=True):
        rest = name.removeprefix(command)
        if not rest or rest == name:
            continue
        quoted = typed.startswith((f'{command}"', f"{command}'"))
        if not (quoted or _may_follow(command, rest)):
            continue
        if command == "ros2":
            rest = rest.lstrip("-_")
        shown = f"{command} {rest}" if not quoted else f"{command} {typed[len(command) :].split()[0]}"
        if quoted:
            right = f"{command} {typed[len(command) :]}"
        else:
            right = f"{command} {rest}{typed[len(name) :]}" if typed.startswith(name) else ""
        return Slip("command.blank", {"name": name, "command": command, "right": shown}, right)
    return None


def _may_follow(command: str, rest: str) -> bool:
    """Whether it is certain that a blank is missing between these two."""
    if command == "ros2":
        return rest.lstrip("-_").isalpha() and (SHARE_PATH / f"ros2{rest.lstrip('-_')}").is_dir()
    if command == "colcon":
        return rest.lstrip("-_") in _COLCON_VERBS and rest.isalpha()
    if _OPTION.fullmatch(rest):
        return True
    if rest in (".", "..") or rest.startswith(("../", "./", "~/", "/")) or rest == "~":
        return command in _TAKE_A_PATH
    if rest.isdigit():
        return command in _TAKE_A_NUMBER
    return command in _TAKE_A_NAME and len(rest) >= _SHORTEST_NAME and rest[0].isalpha()


def _other_case(name: str, line: str, commands: list[str]) -> Slip | None:
    small = name.lower()
    if small == name or small not in commands:
        return None
    return Slip("command.case", {"name": name, "near": small}, _again(name, line, small))


def _turned(name: str, line: str, commands: list[str]) -> Slip | None:
    """Short commands: two letters that changed places (`sl`), a number left out (`ros`)."""
    for near in sorted(commands):
        if _is_turned(name, near) or (len(name) > 2 and near.startswith(name) and near[len(name) :].isdigit()):
            return _meant(name, line, near)
    return None


def _near(name: str, line: str, commands: list[str]) -> Slip | None:
    near = nearest(name, commands, CLOSE) if len(name) >= SHORTEST else ""
    return _meant(name, line, near) if near not in ("", name) else None


def _is_turned(one: str, other: str) -> bool:
    """Whether two names differ by two neighbours that have changed places."""
    if len(one) != len(other) or one == other:
        return False
    differ = [index for index, (a, b) in enumerate(zip(one, other, strict=True)) if a != b]
    return len(differ) == 2 and differ[1] == differ[0] + 1 and sorted(one) == sorted(other)


def _meant(name: str, line: str, near: str) -> Slip:
    return Slip("command.near", {"name": name, "near": near}, _again(name, line, near))


def _again(name: str, line: str, right: str) -> str:
    typed = line.strip()
    return right + typed[len(name) :] if typed.startswith(name) else ""
