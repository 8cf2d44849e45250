"""Telling the commands of a block from the output that stands below them, and what kind of command each is."""

from __future__ import annotations

import re

_WORDS = """
ros2 colcon rosdep source . export echo cd mkdir git wget curl sudo apt apt-get python3 python pip pip3 rviz2 rqt
rqt_graph rqt_console rqt_plot rqt_topic rqt_bag check_urdf urdf_to_graphviz xacro printenv touch ls cat vcs killall
env unset tree chmod cp mv rm pytest docker gz tc nano gedit vim install brew code
"""
FIRST_WORDS = frozenset(_WORDS.split())
"""What a line at a prompt begins with."""
SHELLS = frozenset(("console", "bash", "shell", "sh", "text", "none", "default", ""))
_ASSIGNMENT = re.compile(r"[A-Z_]+=\S* +(ros2|colcon|python3)\b")
_PLACEHOLDER = re.compile(
    r"(?<![<>&\d])<[A-Za-z_][\w\-. |/]*>"
    r"|\[[a-z_]+ ?\.\.\.\]|\[-[a-z]|\[\w+\] \[\w+\]|\[package_selection_args\]"
    r"|\bYOUR_\w+|/path/to\b|--x x\b|\bmodel\.xacro\b"
    r"|^ros2 (topic echo|node info|pkg create|topic pub)$"
)
"""What stands for something that a reader chooses; or a command that is only mentioned."""
_RUNS_ON = re.compile(
    r"\bros2 (run|launch|bag (record|play)|service echo|action echo|topic (echo|hz|bw|delay)(?!.*--once))\b"
    r"|\bros2 topic pub(?!.* (--once|-1|--times|-t) )"
    r"|^(\S+=\S+ )*(rqt\w*|rviz2|gz)\b|^python3 (?!-c)|--spin-time"
)
_WINDOW = re.compile(
    r"^(\S+=\S+ )*(rqt\w*|rviz2)\b|^ros2 run (rqt\w*|rviz2|joint_state_publisher_gui)\b|^ros2 launch .*(rviz|\bdisplay\.launch)"
)


def split(text: str) -> list[tuple[str, str]] | None:
    """Return the commands of a block, each with the output shown below it; None for a block that has no command."""
    found: list[tuple[str, list[str]]] = []
    lines = text.splitlines()
    at = 0
    while at < len(lines):
        line = lines[at]
        at += 1
        bare = line.strip()
        if is_command(bare):
            bare = bare.removeprefix("$ ")
            while at < len(lines) and _unfinished(bare):
                if bare.endswith("\\"):
                    bare = bare[:-1].rstrip() + " " + lines[at].strip()
                else:
                    bare += "\n" + lines[at]
                at += 1
            found.append((bare, []))
        elif found:
            if not (bare.startswith("#") and len(found[-1][1]) == 0):
                found[-1][1].append(line)
        elif bare and not bare.startswith("#"):
            return None
    return [(command, "\n".join(output).strip("\n")) for command, output in found] or None


def is_command(line: str) -> bool:
    """Say whether a line is typed at a prompt."""
    if line.startswith("$ "):
        return True
    words = line.split()
    if not words or (words[0] == "." and len(words) < 2):
        return False
    return words[0] in FIRST_WORDS or bool(_ASSIGNMENT.match(line))


def _unfinished(line: str) -> bool:
    return line.endswith("\\") or (line.count("'") % 2 == 1 and line.count('"') == 0) or line.count('"') % 2 == 1


def is_form(command: str) -> bool:
    """Say whether a command shows only how such commands look (`ros2 topic echo <topic_name>`)."""
    return bool(_PLACEHOLDER.search(command))


def runs_on(command: str) -> bool:
    """Say whether a command ends only by Ctrl-C, as far as its words tell."""
    return bool(_RUNS_ON.search(command))


def opens_window(command: str) -> bool:
    """Say whether a command's result is to be seen in a window."""
    return bool(_WINDOW.search(command))
