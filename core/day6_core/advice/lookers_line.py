"""Lookers that look at the line that was typed: commands that do not exist, verbs that are nearly right, `--ros-args`."""

from __future__ import annotations

import re
import shlex

from day6_core.advice import known
from day6_core.advice.looking import Found, Situation, found, looker
from day6_core.advice.typed import Slip, chinese_sign, lacking_in_shell, near_choice, slip_of_command
from day6_core.ros.differences import value
from day6_core.ros.program_index import executables, packages

_KEYS = {"command.near": "command.meant", "command.blank": "command.blank_here"}
"""Texts of hints that repeat what a card has said already -> those for the card."""

_TAKES_ONE = ("-p", "--param", "-r", "--remap", "--params-file", "--log-level", "-e", "--enclave", "--log-config-file")


@looker
def command(scene: Situation) -> Found | None:
    """A command that does not exist: a file of this folder, a prompt, a missing blank, an answer, a slip of another name."""
    name = scene.value("name")
    here = scene.cwd / name
    if here.is_file() and name.endswith(".py"):
        return found("command.python", shlex.join(["python3", name]), name=name)
    if here.is_file():
        return found("command.here", shlex.quote(f"./{name}"), name=name)
    slip = slip_of_command(name, scene.command or name, scene.commands, scene.letters)
    return of_slip(slip) if slip is not None else None


def of_slip(slip: Slip) -> Found:
    """Return a slip as the cause of a card."""
    return Found(_KEYS.get(slip.key, slip.key), slip.values, slip.right)


def chinese_cause(scene: Situation) -> Found | None:
    """Return the Chinese sign in a command that failed; whatever the card, this is why."""
    if scene.command.isascii():
        return None
    words = scene.words() or scene.command.split()
    slip = chinese_sign(words, scene.command)
    return of_slip(slip) if slip is not None else None


@looker
def shell_lacks(scene: Situation) -> Found | None:
    """Something of bash that this terminal does not have."""
    slip = lacking_in_shell(scene.line or scene.command)
    return of_slip(slip) if slip is not None else None


@looker
def choice(scene: Situation) -> Found | None:
    """A verb that is nearly one of those that can stand there."""
    name = scene.value("name")
    near = near_choice(name, re.findall(r"[\w.-]+", scene.value("choices")))
    if not near:
        return None
    return found("choice.near", scene.with_word(name, near), name=name, near=near)


@looker
def bag_topics(scene: Situation) -> Found | None:
    """`ros2 bag record /a /b`, as until Kilted."""
    words, names = scene.words(), scene.value("names").split()
    unknown = value("bag.positional_topics") != "removed" or any(name.startswith("-") for name in names)
    if words[:3] != ["ros2", "bag", "record"] or unknown:
        return None
    rest = [word for word in words if word not in names]
    return found("bag.topics", shlex.join([*rest, "--topics", *names]))


@looker
def on_change(scene: Situation) -> Found | None:
    """`ros2 topic echo /a --on-change`: a wish that the real command has no option for."""
    words = scene.words()
    asked = {word for word in words if word.partition("=")[0] in _ON_CHANGE}
    if words[:3] != ["ros2", "topic", "echo"] or not asked:
        return None
    rest = [word for word in words if word not in {*asked, "--csv"}]
    return found("echo.on_change", f"{shlex.join([*rest, '--csv'])} | uniq")


_ON_CHANGE = ("--on-change", "--on-changed", "--on-changes", "--only-changes", "--changes")


@looker
def runnable(scene: Situation) -> Found | None:
    """`ros2 run` with one name only: a program without its package, or a package without its program."""
    words = scene.words()
    if words[:2] != ["ros2", "run"] or len(words) != 3:
        return None
    name = words[2]
    homes = [package for package in packages() if name in executables(package)]
    if homes:
        return found("run.package", shlex.join(["ros2", "run", homes[0], name]), name=name, package=homes[0])
    if any((share / name / "package.xml").is_file() for share in known.shares(scene.variables)):
        return found("run.program", shlex.join(["ros2", "pkg", "executables", name]), name=name)
    return None


@looker
def ros_args(scene: Situation) -> Found | None:
    """What stands after `--ros-args` without its own -p or -r, or with = for :=."""
    words = scene.words()
    if "--ros-args" not in words:
        return None
    begin = words.index("--ros-args") + 1
    right: list[str] = words[:begin]
    key, first = "", ""
    for index, word in enumerate(words[begin:], begin):
        before = words[index - 1]
        if word == "--":
            right += words[index:]
            break
        if before in ("-p", "--param") and ":=" not in word and re.match(r"[\w.]+=.", word):
            key, first = key or "ros_args.colon", first or word
            word = word.replace("=", ":=", 1)
        elif ":=" in word and before not in _TAKES_ONE:
            option = "-r" if re.match(r"(?:\S*/|__)", word.partition(":=")[0]) else "-p"
            key, first = key or "ros_args.option", first or word
            right.append(option)
        right.append(word)
    if not key:
        return None
    option = right[right.index(first) - 1] if first in right else "-p"
    return found(key, shlex.join(right), word=first, option=option, right=first.replace("=", ":=", 1))
