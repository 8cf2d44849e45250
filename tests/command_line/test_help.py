"""Help: every command explains itself and all it takes, in both languages, in one list that is made from the commands."""

from __future__ import annotations

import argparse
import re
import string
from collections.abc import Iterator

import pytest

from day6_core.command_line.parser import CommandParser
from day6_core.command_line.texts import texts_in
from day6_core.language import LANGUAGES
from day6_core.ros.program_index import COMMANDS
from day6_core.width import text_width
from day6_tui.commands.table import GROUPS, Command, command_named, commands
from day6_tui.main import main

CHINESE = re.compile("[\u4e00-\u9fff]")
ENGLISH_SENTENCE = re.compile(r"\b(?:the|and|of|is|a|an|to|with)\b")
LONGEST_SUMMARY = 56
"""Cells that a line of 80 has left beside the names."""

OURS = [command for command in commands() if command.group != "ros"]


def parsers(language: str) -> Iterator[CommandParser]:
    """Yield the parser of every command and of every verb."""
    for command in OURS:
        parser = command.parser(language)
        assert parser is not None
        yield parser
        yield from parser.verbs.values()


def is_verb(action: argparse.Action) -> bool:
    return isinstance(action, argparse._SubParsersAction)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_option_and_argument_is_explained(language: str) -> None:
    seen = 0
    for parser in parsers(language):
        assert parser.description, parser.prog
        texts = [parser.description, *(action.help or "" for action in parser.actions)]
        for text in texts:
            assert text and text == text.strip(), parser.prog
            assert bool(CHINESE.search(text)) == (language == "zh"), (parser.prog, text)
            assert language == "en" or not ENGLISH_SENTENCE.search(text), (parser.prog, text)
        for action in parser.actions:
            seen += 1
            assert action.nargs == 0 or action.metavar or action.choices, (parser.prog, action.option_strings)
    assert seen > 150


def test_both_languages_have_the_same_options() -> None:
    def shape(language: str) -> list[tuple[object, ...]]:
        return [
            (parser.prog, *action.option_strings, action.dest, action.metavar, action.nargs, str(action.choices or ""))
            for parser in parsers(language)
            for action in parser.actions
            if not is_verb(action)
        ]

    assert shape("zh") == shape("en")


def test_every_command_takes_help_and_a_language_and_no_abbreviations() -> None:
    for parser in parsers("en"):
        assert {"-h", "--help", "--lang"} <= set(parser.known_options()), parser.prog
        assert not parser.allow_abbrev, parser.prog


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_list_has_every_command_once_and_one_line_for_each(
    language: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    with pytest.raises(SystemExit) as end:
        main(["--lang", language, "--help"])
    said = capsys.readouterr()
    assert (end.value.code, said.err) == (0, "")
    lines = said.out.split("\n")
    for command in commands():
        assert text_width(command.summary(language)) <= LONGEST_SUMMARY, command.name
        if command.name:
            pattern = re.escape(command.name) + " +" + re.escape(command.summary(language))
            assert sum(re.fullmatch(f"  {pattern}", line) is not None for line in lines) == 1, command.name


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("columns", [60, 80, 120])
def test_no_line_of_help_is_wider_than_the_terminal(
    columns: int, language: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    for parser in parsers(language):
        for line in parser.format_help().split("\n"):
            known = re.search(r"\S{20,}", line)  # a path or the choices of an option cannot be folded
            assert text_width(line) <= columns or known, (parser.prog, line)


def test_what_a_description_begins_with_is_the_line_in_the_list() -> None:
    for language in LANGUAGES:
        for command in OURS:
            parser = command.parser(language)
            assert parser is not None and parser.description is not None
            assert parser.description.split("\n")[0].rstrip(".。") == command.summary(language)


def test_the_words_of_the_parser_are_in_the_language(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    with pytest.raises(SystemExit):
        main(["lessons", "play", "--help", "--lang", "zh"])
    out = capsys.readouterr().out
    assert out.startswith("用法：day6-tui lessons play ") and "\n参数：\n" in out and "\n选项：\n" in out
    assert not re.search("usage|options:|arguments:|positional", out)
    first, second = out.split("\n")[:2]
    assert second.index("FILE") == text_width(first[: first.index("[-h]")])  # aligned by cells


@pytest.mark.parametrize("command", ["ros2", "colcon"])
def test_the_help_of_a_command_of_ros_is_that_of_ros(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAY6_LINK", "off")
    said = []
    for language in LANGUAGES:
        main(["--lang", language, command, "--help"])
        said.append("".join(capsys.readouterr()))
    assert said[0] == said[1] and said[0] and not CHINESE.search(said[0])


def test_the_table_has_the_programs_of_ros_and_hides_what_is_for_shells() -> None:
    names = [command.name for command in commands()]
    assert set(COMMANDS) < set(names) and "complete" not in names and len(names) == len(set(names))
    assert {command.group for command in commands()} == {"", *GROUPS}
    hidden = command_named("complete")
    assert hidden is not None and command_named("nothing") is None
    assert all(isinstance(command_named(name), Command) for name in names)


def test_the_texts_of_both_languages_have_the_same_keys_and_fields() -> None:
    def fields(text: str) -> set[str]:
        return {name for _, name, _, _ in string.Formatter().parse(text) if name} if "{" in text else set()

    english, chinese = texts_in("en"), texts_in("zh")
    assert list(english) == list(chinese)
    for key in english:
        assert fields(english[key]) == fields(chinese[key]), key
