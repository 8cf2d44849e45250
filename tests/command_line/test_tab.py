"""Tab after `day6-tui` in the user's own shell, after `day6-tui completion SHELL`; PowerShell's script is only read here."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.lessons.catalogue import shipped_names
from day6_core.shell.outward.real_completion import SHELLS
from day6_tui.commands.complete import own_words
from day6_tui.commands.table import commands, names
from day6_tui.main import main
from tests.e2e.place import DAY6, Place

NAMES = names()


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("", NAMES),
        ("--lang zh ", NAMES),
        ("--distro=kilted --lang en ", NAMES),
        ("--lang ", ["zh", "en"]),
        ("--lang=", ["--lang=zh", "--lang=en"]),
        ("--theme ", ["dark", "light", "contrast", "colourblind"]),
        ("--theme dark ", []),
        ("--lesson ", sorted(shipped_names())),
        ("demo ", sorted(shipped_names())),
        ("demo day1 ", []),
        ("serve --isolation ", ["auto", "users", "bubblewrap", "landlock", "none"]),
        ("serve --keep --port ", []),
        ("serve --nothing ", []),
        ("lessons ", ["list", "help", "new", "check", "preview", "play"]),
        ("lessons new ", []),
        ("lessons new --", ["-h", "--help", "--lang", "--drill"]),
        ("lessons --lang zh play a.md b.md --", ["-h", "--help", "--lang", "--step", "--real-time"]),
        ("help ", NAMES),
        ("help serve ", NAMES),
        ("completion ", ["bash", "zsh", "fish", "powershell"]),
        ("cast ", []),
        ("check_urdf ", []),
        ("nothing ", []),
    ],
)
def test_what_may_stand_at_the_end_of_a_line(line: str, offered: list[str]) -> None:
    words = line.split(" ")
    assert own_words([*words[:-1], words[-1]]) == offered


@pytest.mark.parametrize("command", [command for command in commands() if command.group != "ros"], ids=lambda c: c.name)
def test_every_option_of_every_command_is_offered_and_every_choice(command) -> None:
    parser = command.parser("en")
    before = [command.name] if command.name else []
    options = [option for action in parser.actions for option in action.option_strings]
    assert own_words([*before, "-"]) == options and "--help" in options
    for action in parser.actions:
        if action.choices is not None and not isinstance(action, argparse._SubParsersAction) and action.option_strings:
            assert own_words([*before, action.option_strings[0], ""]) == list(action.choices)


@pytest.mark.parametrize(
    ("shell", "line", "printed"),
    [
        *((shell, "day6-tui ser", ["serve"]) for shell in SHELLS),
        ("bash", "day6-tui --lang=z", ["zh"]),  # bash keeps what stands before the =
        ("zsh", "day6-tui --lang=z", ["--lang=zh"]),
        ("fish", "day6-tui 'compl", ["completion"]),
        ("zsh", "day6-tui 'compl", ["'completion'"]),
        ("fish", "true && day6-tui serve --iso", ["--isolation"]),
        ("powershell", "day6-tui lessons p", ["play", "preview"]),
        ("bash", "ls x", []),
    ],
)
def test_complete_prints_a_word_on_each_line_as_the_shell_takes_it(
    shell: str, line: str, printed: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["complete", shell, line]) == 0
    assert capsys.readouterr().out.splitlines() == printed


@pytest.mark.parametrize("shell", SHELLS)
def test_the_script_asks_day6_tui_about_nothing_but_itself(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert f"day6-tui complete {shell} " in script and "ros2" not in script and "colcon" not in script
    assert sys.executable not in script  # it is kept in a file of the user, and an update must not break it


def test_a_shell_without_completion_is_refused_with_the_nearest(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["completion", "zs"])
    assert end.value.code == 2 and capsys.readouterr().err.endswith("did you mean zsh?\n")


START = {
    "bash": (["--norc", "--noprofile", "-i"], "PS1='ready> '; source <(day6-tui completion bash); clear"),
    "zsh": (["-f", "-i"], "PS1='ready> '; source <(day6-tui completion zsh); clear"),
    "fish": (
        ["--no-config", "-i"],
        "function fish_prompt; echo 'ready> '; end; day6-tui completion fish | source; clear",
    ),
}
LINES = (
    (("day6-tui wheelh\t", "day6-tui wheelhouse "),),
    (("day6-tui serve --iso\t", "serve --isolation "), ("ban\b\b\bbub\t", "--isolation bubblewrap ")),
    (("day6-tui lessons pr\t", "lessons preview "), ("mi\t", "preview mine.md")),
    (("day6-tui --lang zh ros2 topi\t", "zh ros2 topic "), ("ec\t", "ros2 topic echo ")),
    (("day6-tui colcon bu\t", "day6-tui colcon build "),),
    (("day6-tui --theme=contr\t", "day6-tui --theme=contrast "),),
)
"""What is typed, and what the line then shows."""


@pytest.fixture
def place(tmp_path: Path) -> Iterator[Place]:
    made = Place(tmp_path)
    yield made
    made.close()


@pytest.mark.person
@pytest.mark.parametrize("name", START)
def test_tab_completes_day6_tui_in_the_users_own_shell(place: Place, name: str) -> None:
    if shutil.which(name) is None:
        pytest.skip(f"there is no {name} here")
    from tests.e2e.terminal import Terminal

    options, first = START[name]
    place.home.mkdir()
    (place.work / "mine.md").write_text("", encoding="utf-8")
    path = os.pathsep.join([os.path.dirname(DAY6[0]), os.environ["PATH"]])
    variables = place.environment(HOME=str(place.home), PATH=path, LC_ALL="C.UTF-8", TERM="xterm-256color")
    screen = Terminal([name, *options], 100, 24, cwd=place.work, env=variables)
    screen.line(first)
    screen.wait(lambda seen: seen.strip().endswith("ready>") and "completion" not in seen)
    for steps in LINES:
        for typed, shown in steps:
            screen.send(typed)
            screen.wait(shown.rstrip())
        screen.press("Ctrl-U")
        screen.wait(lambda seen: seen.rstrip().endswith("ready>"))
