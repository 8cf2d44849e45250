"""What is wrong with a command line is said in one line, in the user's language, with the nearest word; by argparse, too.

These tests meet argparse by its effects: where another Python words a message otherwise, they fail with it.
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

import pytest

from day6_core.command_line.parser import CommandParser, nearest
from day6_core.command_line.texts import CommandTexts
from day6_core.command_line.values import Values
from day6_core.link.unusable import TEXTS as UNUSABLE
from day6_tui.classes.command import build_parser as class_parser

CHINESE = re.compile("[\u4e00-\u9fff]")


def parser(language: str) -> CommandParser:
    """One of everything that argparse can find wrong."""
    made = CommandParser("day6-tui try", texts=CommandTexts(language), description="")
    made.add_argument("file", nargs="+", metavar="FILE")
    made.add_argument("--one", metavar="X")
    made.add_argument("--maybe", nargs="?", metavar="X")
    made.add_argument("--two", nargs=2, metavar=("X", "Y"))
    made.add_argument("--some", nargs="+", metavar="X")
    made.add_argument("--flag", action="store_true")
    made.add_argument("--pick", choices=("red", "green"))
    made.add_argument("--count", type=int, metavar="N")
    made.add_argument("--must", required=True, metavar="X")
    group = made.options.add_mutually_exclusive_group(required=True)
    group.add_argument("--left", action="store_true")
    group.add_argument("--right", action="store_true")
    return made


CASES = {
    ("f", "--left"): ("the following arguments are required: --must", "缺少参数：--must"),
    ("--left", "--must", "x"): ("the following arguments are required: FILE", "缺少参数：FILE"),
    ("f", "--must", "x"): ("one of the arguments --left --right is required", "这些参数要写一个：--left --right"),
    ("--left", "--right"): (
        "argument --right: not allowed with argument --left",
        "参数 --right：不能和 --left 一起用",
    ),
    ("--one",): ("argument --one: expected one argument", "参数 --one：后面要写一个值"),
    ("--some",): ("argument --some: expected at least one argument", "参数 --some：后面至少要写一个值"),
    ("--two", "1"): ("argument --two: expected 2 arguments", "参数 --two：后面要写 2 个值"),
    ("--flag=1",): ("argument --flag: takes no value, but got '1'", "参数 --flag：不带值，却写了 '1'"),
    ("--pick", "blue"): (
        "argument --pick: invalid choice: 'blue' (choose from red, green)",
        "参数 --pick：没有 'blue' 这个选择（可以选 red, green）",
    ),
    ("--pick", "gren"): (
        "argument --pick: invalid choice: 'gren' (choose from red, green); did you mean green?",
        "参数 --pick：没有 'gren' 这个选择（可以选 red, green）；是不是想写 green？",
    ),
    ("--count", "x"): ("argument --count: invalid value: 'x'", "参数 --count：值不对：'x'"),
    ("f", "--left", "--must", "x", "--zzz"): ("unrecognized arguments: --zzz", "不认识的参数：--zzz"),
    ("f", "--left", "--must", "x", "--pik", "red"): (
        "unrecognized arguments: --pik red; did you mean --pick?",
        "不认识的参数：--pik red；是不是想写 --pick？",
    ),
    ("f", "--left", "--must", "x", "--fla=1"): (
        "unrecognized arguments: --fla=1; did you mean --flag?",
        "不认识的参数：--fla=1；是不是想写 --flag？",
    ),
}


@pytest.mark.parametrize("words", CASES, ids=" ".join)
@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_mistake_is_one_line_in_the_language_with_status_2(
    language: str, words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as end:
        parser(language).parse_args(words)
    said = capsys.readouterr()
    text = CASES[words][language == "zh"]
    assert (end.value.code, said.out) == (2, "")
    assert said.err == {"en": f"day6-tui try: error: {text}\n", "zh": f"day6-tui try: 错误：{text}\n"}[language]


def test_every_message_of_argparse_in_the_table_has_been_met() -> None:
    from day6_core.command_line.parser import _MESSAGES

    met = {key for said, _ in CASES.values() for key in _keys(said)}
    assert {key for _, key in _MESSAGES} - met == {"at_most_one"}  # argparse takes the value of nargs="?" in any case


def _keys(said: str) -> list[str]:
    texts = CommandTexts("en")._texts
    patterns = {
        key.removeprefix("cli.error."): re.sub(r"\\{\w+\\}", ".+", re.escape(text))
        for key, text in texts.items()
        if key.startswith("cli.error.")
    }
    return [key for key, pattern in patterns.items() if re.search(pattern, said)]


def test_a_mistyped_verb_is_answered_with_the_nearest(capsys: pytest.CaptureFixture[str]) -> None:
    from day6_core.lessons.parsers import lessons

    for words, said in (
        (["chek", "a.md"], "argument VERB: invalid choice: 'chek' (choose from list, help, new, check, preview, play)"),
        (["play", "a.md", "--sep", "x"], "unrecognized arguments: --sep x"),
    ):
        with pytest.raises(SystemExit):
            lessons("en").parse_args(words)
        err = capsys.readouterr().err
        assert err.startswith(f"day6-tui lessons: error: {said}; did you mean ") and err.count("\n") == 1


def test_a_message_that_nobody_knows_is_shown_as_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    for message in ("the future speaks differently", "argument --x: the future speaks differently"):
        with pytest.raises(SystemExit):
            parser("en").error(message)
        assert capsys.readouterr().err == f"day6-tui try: error: {message}\n"


def test_no_control_character_of_a_word_reaches_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        parser("zh").parse_args(["f", "--left", "--must", "x", "--a\x1b[2J\nb"])
    err = capsys.readouterr().err
    assert "\x1b" not in err and err.count("\n") == 1


def test_two_dashes_make_no_option_like_another() -> None:
    assert nearest("--nope", ["--home", "--lang"]) is None
    assert nearest("--hom", ["--home", "--lang"]) == "--home"
    assert nearest("", ["--home"]) is None


WRONG = [
    ("folder", "nothing", "'nothing' isn't a folder", "“nothing”不是文件夹"),
    ("home", "a file", "'a file' isn't a folder, and can't become one", "“a file”不是文件夹，也没法建成文件夹"),
    ("home", "a file/x/y", "'a file/x/y' isn't a folder, and can't", "“a file/x/y”不是文件夹，也没法"),
    ("file", "nothing", "there is no file 'nothing'", "没有文件“nothing”"),
    ("file", "a folder", "'a folder' is a folder; a file is needed", "“a folder”是文件夹；这里要写一个文件"),
    ("file", "a\0b", "embedded null", "embedded null"),
    ("seconds", "soon", "'soon' isn't a number of seconds", "“soon”不是秒数"),
    ("seconds", "nan", "'nan' isn't a number of seconds", "“nan”不是秒数"),
    ("minutes", "-1", "'-1' isn't a number of minutes", "“-1”不是分钟数"),
    ("address", "host", "'host' isn't an address", "“host”不是地址"),
    ("secret", "short", "the secret has 5 characters", "口令：只有 5 个字符，至少要 8 个"),
]
if sys.platform != "win32":  # where links need a right, and below a file there is nothing
    WRONG += [
        ("home", "dangling", "'dangling' isn't a folder", "“dangling”不是文件夹"),
        ("file", "a file/x", "'a file/x': Not a directory", "“a file/x”打不开：Not a directory"),
    ]


@pytest.mark.parametrize(("kind", "text", "english", "chinese"), WRONG)
def test_a_wrong_value_is_refused_in_the_language(
    kind: str, text: str, english: str, chinese: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a file").touch()
    Path("a folder").mkdir()
    if text == "dangling":
        Path(text).symlink_to("nowhere")
    for language, said in (("en", english), ("zh", chinese)):
        with pytest.raises(argparse.ArgumentTypeError) as error:
            getattr(Values(CommandTexts(language)), kind)(text)
        assert said in str(error.value)


def test_numbers_are_within_their_limits() -> None:
    values = Values(CommandTexts("zh"))
    assert values.whole(0, 9)("9") == 9 and values.number(1, 120)("2.5") == 2.5
    for read, text in ((values.whole(0, 9), "10"), (values.whole(0, 9), "１"), (values.number(1, 120), "0.5")):
        with pytest.raises(argparse.ArgumentTypeError, match=r"不是 .* 的数"):
            read(text)


def test_a_home_may_still_be_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    values = Values(CommandTexts("en"))
    assert values.home("new/deep") == Path("new/deep") and values.home(".") == Path()
    Path("robot.urdf").touch()
    assert values.file("robot.urdf") == "robot.urdf"


@pytest.mark.parametrize(
    ("text", "chinese"),
    [
        ("nonsense", "'nonsense' 不是 tcp/192.168.1.5:7447 这样的地址"),
        ("quic/a:1", "'quic/a:1' 的协议不认识：请用 tcp, udp 或 ws"),
        ("tcp/a", "'tcp/a' 没有端口：应该写 tcp/a:7447"),
        ("tcp/a:0", "'tcp/a:0' 的端口不是 1 到 65535 的数"),
        ("tcp/::1:1", "'tcp/::1:1' 的 IPv6 地址要加方括号：tcp/[::1]:7447"),
        ("tcp/1.2.3:1", "'tcp/1.2.3:1' 的地址不对：1.2.3"),
        ("tcp/0.0.0.0:1", "'tcp/0.0.0.0:1' 指这台电脑的所有地址，不能用来连接"),
        ("tcp/-a:1", "'tcp/-a:1' 的主机名不对：-a"),
        ("tcp/:1", "'tcp/:1' 没有主机名"),
        ("tcp/a\nb:1", "'tcp/a\\nb:1' 的主机名不对"),
    ],
)
def test_a_wrong_endpoint_is_refused_in_chinese_too(text: str, chinese: str) -> None:
    with pytest.raises(argparse.ArgumentTypeError) as error:
        Values(CommandTexts("zh")).endpoint(listening=False)(text)
    assert str(error.value) == chinese


def test_host_and_port_are_an_endpoint_and_the_host_alone_where_a_port_is_usual() -> None:
    read = Values(CommandTexts("en")).endpoint(listening=True)
    assert [read(text) for text in ("127.0.0.1:7458", "udp/[::1]:1", "[::1]:7458")] == [
        "tcp/127.0.0.1:7458",
        "udp/[::1]:1",
        "tcp/[::1]:7458",
    ]
    for text in ("127.0.0.1", "::1", ":7458", "7458", ""):
        with pytest.raises(argparse.ArgumentTypeError):
            read(text)
    for option in ("--listen", "--join"):
        for text, host in (("127.0.0.1", "127.0.0.1"), ("::1", "[::1]"), ("teacher.local", "teacher.local")):
            found = vars(class_parser().parse_args([option, text]))[option[2:]]
            assert found == f"tcp/{host}:7447"
        assert vars(class_parser().parse_args([option, "192.168.1.5:7458"]))[option[2:]] == "tcp/192.168.1.5:7458"


def test_every_reason_is_there_in_both_languages_with_the_same_fields() -> None:
    for key, texts in UNUSABLE.items():
        english, chinese = (set(re.findall(r"\{(\w+)", text)) for text in texts)
        assert english == chinese and CHINESE.search(texts[1]) and not CHINESE.search(texts[0]), key
