"""Tab: what may stand where the cursor is, and how it is quoted."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.shell.line.completion import Completer, current_words, quoted
from day6_core.shell.outward.real_completion import answers, functions

FILES = "mkdir -p one/in 'two dirs' .hidden; touch one/a.py one/b.txt only.py 'sp ace' '$x' .rc; alias tt=true"


def completed(machine: Any, line: str) -> tuple[list[str], int]:
    found: list[tuple[list[str], int]] = []
    machine.shell.variables["PATH"] = "/no/programs"

    async def main(session: Any) -> int:
        found.append(await Completer(machine.shell, session).complete(line))
        return 0

    from day6_core.session.streams import InputStream
    from day6_core.shell.language.redirection import Streams

    streams = Streams(InputStream(), machine.out, machine.err)
    program = machine.desk.start_program(["tab"], main, streams, env=machine.shell.environment, cwd=machine.shell.cwd)
    machine.wait(lambda: program.status is not None)
    return found[0]


@pytest.mark.parametrize(
    ("line", "choices", "start"),
    [
        ("cat on", ["one/", "only.py"], 4),
        ("cat one/", ["one/a.py", "one/b.txt", "one/in/"], 4),
        ("cat one/a", ["one/a.py"], 4),
        ("cd o", ["one/"], 3),
        ("cd one/", ["one/in/"], 3),
        ("rmdir o", ["one/"], 6),
        ("mkdir o", ["one/"], 6),
        ("cat .", [".hidden/", ".rc"], 4),
        ("cat sp", ["sp\\ ace"], 4),
        ("cat 'sp", ["'sp ace'"], 4),
        ('cat "sp', ['"sp ace"'], 4),
        ("cat tw", ["two\\ dirs/"], 4),
        ("cat 'tw", ["'two dirs/"], 4),
        ("cat nothing", [], 4),
        ("cat no/where", [], 4),
        ("cat ~/only", ["~/only.py"], 4),
        ("ls ~/", ["~/$x", "~/one/", "~/only.py", "~/ros2_ws/", "~/sp ace", "~/two dirs/"], 3),
        ("echo a > on", ["one/", "only.py"], 9),
        ("cat < onl", ["only.py"], 6),
        ("whoam", ["whoami"], 0),
        ("echo a | whoam", ["whoami"], 9),
        ("true && whoam", ["whoami"], 8),
        ("true;whoam", ["whoami"], 5),
        ("X=1 whoam", ["whoami"], 4),
        ("sudo whoam", ["whoami"], 5),
        ("which whoam", ["whoami"], 6),
        ("sudo cat onl", ["only.py"], 9),
        ("tt", ["tt"], 0),
        ("./onl", ["./only.py"], 0),
        ("~/onl", ["~/only.py"], 0),
        ("echo $ROS_DI", ["$ROS_DISTRO"], 5),
        ("echo $LOGN", ["$LOGNAME"], 5),
        ("echo $NOPE", [], 5),
    ],
)
def test_the_words_that_fit_are_offered_in_order(machine: Any, line: str, choices: list[str], start: int) -> None:
    machine.run(FILES)
    found = completed(machine, line)
    assert ([choice.replace("\\", "") for choice in found[0]] if line == "ls ~/" else found[0]) == choices
    assert found[1] == start


def test_an_empty_line_offers_every_command_but_the_signs(machine: Any) -> None:
    choices, start = completed(machine, "")
    assert start == 0 and choices == sorted(choices)
    assert {"ros2", "cd", "ll", "grep"} <= set(choices)
    assert not {".", ":", "["} & set(choices)


@pytest.mark.parametrize("command", ["kill", "fg", "bg", "wait"])
def test_jobs_are_offered_behind_a_percent_sign(machine: Any, command: str) -> None:
    machine.run("sleep 50 & sleep 60 & true")
    assert completed(machine, f"{command} %") == (["%1", "%2"], len(command) + 1)
    assert completed(machine, "echo %")[0] == []


def test_ros2_and_colcon_offer_their_own_words_and_files_where_these_are_wanted(machine: Any) -> None:
    machine.run(FILES)
    assert completed(machine, "ros2 top") == (["topic"], 5)
    assert completed(machine, "ros2 topic ec") == (["echo"], 11)
    assert "turtlesim" in completed(machine, "ros2 run turt")[0]
    assert completed(machine, "ros2 nothing x") == ([], 13)
    assert completed(machine, "colcon bui") == (["build"], 7)
    assert completed(machine, "ros2 bag play on")[0] == ["one/", "only.py"]
    assert completed(machine, "ros2 run turtlesim turtlesim_node ./on")[0] == ["./one/", "./only.py"]


@pytest.mark.parametrize(
    ("line", "words", "start", "quote"),
    [
        ("", [""], 0, ""),
        ("a", ["a"], 0, ""),
        ("a ", ["a", ""], 2, ""),
        ("a b", ["a", "b"], 2, ""),
        ("a  b", ["a", "b"], 3, ""),
        ("a 'b c", ["a", "b c"], 2, "'"),
        ('a "b c', ["a", "b c"], 2, '"'),
        ("a b\\ c", ["a", "b c"], 2, ""),
        ("a | b", ["b"], 4, ""),
        ("a | b c", ["b", "c"], 6, ""),
        ("a; b", ["b"], 3, ""),
        ("a && ", [""], 5, ""),
        ("a > ", ["", ""], 4, ""),
        ("a > b", ["", "b"], 4, ""),
        ("a > b c", ["a", "c"], 6, ""),
        ("X=1 Y=2 a b", ["a", "b"], 10, ""),
        ("X=1", ["X=1"], 0, ""),
        ("a $x", ["a", "$x"], 2, ""),
        ("a\nb c", ["b", "c"], 4, ""),
    ],
)
def test_the_words_of_the_command_being_typed(line: str, words: list[str], start: int, quote: str) -> None:
    assert current_words(line) == (words, start, quote)


@pytest.mark.parametrize(
    ("text", "quote", "typed"),
    [
        ("plain", "", "plain"),
        ("a b", "", "a\\ b"),
        ("a(b)&;|<>*?[]#!`$'\"\\", "", "a\\(b\\)\\&\\;\\|\\<\\>\\*\\?\\[\\]\\#\\!\\`\\$\\'\\\"\\\\"),
        ("a b", "'", "'a b'"),
        ("it's", "'", "'it'\\''s'"),
        ("a b/", "'", "'a b/"),
        ('a"$`\\b', '"', '"a\\"\\$\\`\\\\b"'),
        ("{data: 1}", "", '"{data: 1}"'),
        ("a/", "", "a/"),
    ],
)
def test_a_completed_word_is_quoted_as_it_must_be_typed(text: str, quote: str, typed: str) -> None:
    assert quoted(text, quote) == typed


def test_the_real_shell_asks_for_ros2_colcon_and_day6_tui(machine: Any) -> None:
    found: dict[str, list[str]] = {}

    async def main(session: Any) -> int:
        for line in ("ros2 topic e", "day6-tui ros2 topic e", "day6-tui ex", "ls x", "colcon te", "ros2 'to"):
            found[line] = await answers(
                line, session, lambda words: ["exec", "env", "shell"] if len(words) == 1 else []
            )
        return 0

    from day6_core.session.streams import InputStream
    from day6_core.shell.language.redirection import Streams

    streams = Streams(InputStream(), machine.out, machine.err)
    program = machine.desk.start_program(["tab"], main, streams, env=machine.shell.environment, cwd=machine.shell.cwd)
    machine.wait(lambda: program.status is not None)
    assert found == {
        "ros2 topic e": ["echo"],
        "day6-tui ros2 topic e": ["echo"],
        "day6-tui ex": ["exec"],
        "ls x": [],
        "colcon te": ["test", "test-result"],
        "ros2 'to": ["'topic'"],
    }


def test_what_the_real_shells_read_names_every_command_and_quotes_ours() -> None:
    bash, zsh = (functions(shell, ["/a b/python", "-m", "x"]) for shell in ("bash", "zsh"))
    assert "'/a b/python' -m x complete bash" in bash and bash.endswith("_day6_complete ros2 colcon day6-tui\n")
    assert "'/a b/python' -m x complete zsh" in zsh and zsh.endswith("compdef _day6_complete ros2 colcon day6-tui\n")
    fish, powershell = (functions(shell, ["/a b/python", "-m", "x"]) for shell in ("fish", "powershell"))
    assert "'/a b/python' -m x complete fish" in fish and "for name in ros2 colcon day6-tui\n" in fish
    assert (
        "'/a b/python' -m x complete powershell" in powershell and "-CommandName ros2, colcon, day6-tui " in powershell
    )
    assert "{{" not in bash + zsh + fish + powershell


@pytest.mark.parametrize(
    ("shell", "line", "printed"),
    [
        ("bash", "ros2 topic ec", "echo"),
        ("bash", "ros2 'topi", "topic"),
        ("zsh", "ros2 'topi", "'topic'"),
        ("fish", "day6-tui --lang zh ros2 'topi", "topic"),
        ("powershell", "day6-tui --distro=kilted colcon te", "test test-result"),
    ],
)
def test_day6_tui_complete_prints_a_word_on_each_line(
    shell: str, line: str, printed: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.shell.outward import real_completion

    monkeypatch.setenv("DAY6_LINK", "off")
    assert real_completion.complete(shell, line, lambda words: []) == 0
    assert capsys.readouterr().out.split() == printed.split()
