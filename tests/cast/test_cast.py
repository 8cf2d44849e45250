"""`day6-tui cast`: files that are no casts, the picture at a time, SVG that is XML, and nothing of a file unfiltered."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from day6_core.session.harmless import one_line
from day6_core.shell.screen.rows import runs_of
from day6_core.shell.screen.screen import Screen
from day6_tui.cast import command
from day6_tui.cast.file import CastError, read
from day6_tui.cast.film import Film
from day6_tui.cast.svg import picture
from day6_tui.locale import Texts

HEAD = {"version": 2, "width": 20, "height": 4}


def cast(folder: Path, *events: list[object], head: object = HEAD) -> Path:
    path = folder / "a.cast"
    path.write_text("\n".join(json.dumps(line) for line in (head, *events)) + "\n", encoding="utf-8")
    return path


WRONG: list[tuple[str, bytes, int, str]] = [
    ("nothing", b"", 1, "head"),
    ("a_text", b"hello\n", 1, "head"),
    ("a_list", b"[]\n", 1, "head"),
    ("version_1", b'{"version": 1, "width": 8, "height": 2, "stdout": []}\n', 1, "version"),
    ("version_3", b'{"version": 3, "term": {"cols": 8}}\n', 1, "version"),
    ("a_hostile_version", b'{"version": "\\u001b]0;x\\u0007"}\n', 1, "version"),
    ("no_size", b'{"version": 2}\n', 1, "size"),
    ("no_columns", b'{"version": 2, "width": 0, "height": 2}\n', 1, "size"),
    ("a_huge_screen", b'{"version": 2, "width": 100000, "height": 100000}\n', 1, "size"),
    ("a_size_in_words", b'{"version": 2, "width": "80", "height": 24}\n', 1, "size"),
    ("a_size_that_is_true", b'{"version": 2, "width": true, "height": 24}\n', 1, "size"),
    ("no_json", b'{"version": 2, "width": 8, "height": 2}\n[0, "o"\n[1, "o", "x"]\n', 2, "json"),
    ("an_object", b'{"version": 2, "width": 8, "height": 2}\n[0, "o", "a"]\n{}\n', 3, "event"),
    ("two_parts", b'{"version": 2, "width": 8, "height": 2}\n[0, "o"]\n', 2, "event"),
    ("a_number", b'{"version": 2, "width": 8, "height": 2}\n[0, "o", 7]\n', 2, "event"),
    ("a_time_in_words", b'{"version": 2, "width": 8, "height": 2}\n["0", "o", "x"]\n', 2, "time"),
    ("nan", b'{"version": 2, "width": 8, "height": 2}\n[NaN, "o", "x"]\n', 2, "time"),
    ("infinity", b'{"version": 2, "width": 8, "height": 2}\n[1e999, "o", "x"]\n', 2, "time"),
    ("a_year", b'{"version": 2, "width": 8, "height": 2}\n[31536000, "o", "x"]\n', 2, "time"),
    ("a_very_long_number", b'{"version": 2, "width": 8, "height": 2}\n[' + b"9" * 5000 + b', "o", "x"]\n', 2, "json time"),
    ("before_zero", b'{"version": 2, "width": 8, "height": 2}\n[-1, "o", "x"]\n', 2, "time"),
    ("backwards", b'{"version": 2, "width": 8, "height": 2}\n[2, "o", "x"]\n[1, "o", "x"]\n', 3, "time"),
    ("a_wrong_size", b'{"version": 2, "width": 8, "height": 2}\n[0, "r", "99999x2"]\n', 2, "size"),
    ("a_deep_list", b'{"version": 2, "width": 8, "height": 2}\n' + b"[" * 100_000 + b"\n[0, \"o\", \"\"]\n", 2, "json"),
    ("latin_1", b'{"version": 2, "width": 8, "height": 2}\n[0, "o", "\xe4"]\n', 2, "text"),
]  # fmt: skip


@pytest.mark.parametrize(("data", "line", "key"), [each[1:] for each in WRONG], ids=[each[0] for each in WRONG])
@pytest.mark.parametrize("language", ["zh", "en"])
def test_what_is_wrong_is_told_with_its_line(
    tmp_path: Path, capsys, data: bytes, line: int, key: str, language
) -> None:
    path = tmp_path / "wrong.cast"
    path.write_bytes(data)
    with pytest.raises(CastError) as raised:
        read(path)
    assert raised.value.line == line and raised.value.key in key.split()
    assert command.main([str(path), "--at", "0", "--lang", language]) == 1
    told = capsys.readouterr().err
    assert told.startswith(f"day6-tui: {path}:{line}: ") and one_line(told.rstrip("\n")) == told.rstrip("\n")
    assert "Traceback" not in told


def test_a_file_that_is_not_there_or_a_folder_is_told(tmp_path: Path, capsys) -> None:
    assert command.main([str(tmp_path / "no.cast"), "--at", "0"]) == 1
    assert command.main([str(tmp_path), "--at", "0"]) == 1
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 2 and all(line.startswith(f"day6-tui: {tmp_path}") for line in told)


def test_every_fault_has_its_words_in_both_languages() -> None:
    values = {"most": 1, "version": 1}
    for language in ("zh", "en"):
        for key in ("large", "text", "head", "version", "size", "long", "json", "event", "time"):
            assert Texts(language)(f"cast.fault.{key}", **values)


def test_a_recording_that_was_killed_plays_up_to_there(tmp_path: Path) -> None:
    path = cast(tmp_path, [0, "o", "whole"])
    path.write_bytes(path.read_bytes() + b'[1.5, "o", "cut o')
    assert [event.text for event in read(path).events] == ["whole"]


def test_the_picture_at_a_time_also_backwards(tmp_path: Path) -> None:
    film = Film(read(cast(tmp_path, [1, "o", "one"], [2, "i", "secret"], [2, "o", "\r\ntwo"], [3, "r", "10x2"])))
    texts = []
    for seconds in (0.5, 1.0, 2.5, 9.0, 1.5):
        film.go_to(seconds)
        texts.append(["".join(text for text, _ in row).rstrip() for row in film.rows()])
    assert [text[:2] for text in texts] == [["", ""], ["one", ""], ["one", "two"], ["one", "two"], ["one", ""]]
    assert len(texts[3]) == 2 and len(texts[4]) == 4


HOSTILE = (
    "\x1b]0;title\x07\x1b]52;c;aGk=\x07\x1b[?1000h\x1b[5n\x1bP+q544e\x1b\\\x1b[21t\x9b6n"
    "\u202egnp.exe\u202c <script>alert('&amp;')</script> \x00\x07\x7f \ud83d ]]> \ufffe"
)


@pytest.mark.parametrize("svg", [False, True])
def test_nothing_of_a_file_comes_out_as_it_is(tmp_path: Path, capfd, svg: bool) -> None:
    path = cast(tmp_path, [0, "o", HOSTILE], head={**HEAD, "width": 200})
    out = tmp_path / "out.svg"
    assert command.main([str(path), "--at", "1", *(["--svg", str(out)] if svg else [])]) == 0
    text = out.read_text(encoding="utf-8") if svg else capfd.readouterr().out
    assert all(one_line(line) == line for line in text.splitlines())
    if svg:
        root = ElementTree.fromstring(text)
        assert not [element for element in root.iter() if element.tag.endswith("script")]
        assert "<script>alert('&amp;')</script>" in "".join(root.itertext()).replace("\n", "")


def drawn(text: str, columns: int = 8, rows: int = 4) -> str:
    screen = Screen(columns, rows)
    screen.feed(text)
    return picture([[runs_of(screen.row(y)) for y in range(rows)]], (columns, rows))


def paths(svg: str) -> dict[str, str]:
    """What is filled with each colour."""
    return dict(re.findall(r'<path fill="(#[0-9a-f]+)" shape-rendering="crispEdges" d="([^"]*)"/>', svg))


def test_svg_has_colours_wide_characters_and_marks() -> None:
    svg = drawn("\x1b[1;4;38;2;1;2;3;48;5;196m海a\x1b[0;7m x \x1b[31my")
    assert re.search(
        r'<g fill="#010203" font-weight="bold"><text class="w" x="0.6"[^>]*>海</text><text x="16"[^>]*>a<', svg
    )
    assert paths(svg)["#ff0000"] == "M0 0h24v16h-24z", "the ground of three cells is one rectangle"
    assert paths(svg)["#010203"] == "M0 14h24v1h-24z", "and so is the line below them"
    ElementTree.fromstring(svg)


def test_every_wide_character_has_its_place_and_every_word_its_width() -> None:
    svg = drawn("海龟 go on  ▸x", 20)
    assert '<text class="w" x="0.6 16.6" y="12.5">海龟</text>' in svg
    assert '<text x="40" y="12" textLength="40">go on</text>' in svg
    assert '<text x="96" y="12" textLength="8" lengthAdjust="spacingAndGlyphs">▸</text>' in svg
    assert '<text x="104" y="12">x</text>' in svg


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ("█\r\n█", "M0 0h8v32h-8z"),
        ("▀▄", "M0 0h8v8h-8zM8 8h8v8h-8z"),
        ("▂▌", "M0 12h8v4h-8zM8 0h4v16h-4z"),
        ("▟", "M0 8h8v8h-8zM4 0h4v8h-4z"),
        ("⠁⢀", "M0 0h3v3h-3zM12 12h3v3h-3z"),
        ("──┓\r\n  ┃", "M0 7h16v1h-16zM16 7h5v2h-5zM19 7h2v25h-2z"),
        ("━━╸", "M0 7h21v2h-21z"),
        ("╼", "M0 7h4v1h-4zM3 7h5v2h-5z"),
    ],
)
def test_blocks_braille_and_lines_are_shapes_without_seams(text: str, path: str) -> None:
    svg = drawn(f"\x1b[38;2;1;2;3m{text}")
    found = paths(svg)["#010203"]
    assert area(found) == area(path) and "<text" not in svg
    assert found.count("M") <= path.count("M")


def area(path: str) -> set[tuple[int, int]]:
    """The units that a path covers."""
    rects = [tuple(map(int, rect)) for rect in re.findall(r"M(\d+) (\d+)h(\d+)v(\d+)h-\d+z", path)]
    return {(column, row) for x, y, w, h in rects for column in range(x, x + w) for row in range(y, y + h)}


def test_shades_are_mixed_colours_and_round_corners_are_strokes() -> None:
    svg = drawn("\x1b[38;2;200;100;0;48;2;0;0;0m░\x1b[0;38;2;1;2;3m╭╯")
    assert paths(svg) == {"#321900": "M0 0h8v16h-8z"}
    assert re.search(r'<path fill="none" stroke="#010203" d="M11.5 16[^M]*M19.5 0[^M]*"/>', svg)


def test_a_moving_svg_shows_every_picture_once_and_the_last_to_who_wants_no_motion(tmp_path: Path) -> None:
    path = cast(tmp_path, [0, "o", "\x1b[2;1Hstays"], *([number, "o", f"\x1b[1;1H{number}"] for number in range(5)))
    out = tmp_path / "out.svg"
    assert command.main([str(path), "--svg", str(out), "--frames", "5"]) == 0
    svg = out.read_text()
    groups = {
        "".join(group.itertext()).strip(): group.get("class", "")
        for group in ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}g")
        if "fill" not in group.attrib and "transform" not in group.attrib
    }
    assert sorted(groups) == ["0", "1", "2", "3", "4", "stays"] and not groups["stays"], "what stays is written once"
    assert "@media(prefers-reduced-motion:reduce)" in svg
    for number in range(5):
        name = groups[str(number)]
        steps = re.search(rf"@keyframes {name}{{(.*?)}}}}", svg)
        assert steps is not None
        shown = [
            float(at) for at, seen in re.findall(r"([\d.]+)%{visibility:(\w+)", steps[1] + "}") if seen == "visible"
        ]
        assert shown == [20 * number]
        hidden = re.search(rf"\.{name}{{[^}}]*visibility:hidden}}", svg)
        assert (hidden is None) == (number == 4)


def test_an_existing_picture_is_overwritten_by_force_alone(tmp_path: Path, capsys) -> None:
    path, out = cast(tmp_path, [0, "o", "x"]), tmp_path / "out.svg"
    out.write_text("mine")
    assert command.main([str(path), "--svg", str(out)]) == 1 and out.read_text() == "mine"
    assert "--force" in capsys.readouterr().err
    assert command.main([str(path), "--svg", str(out), "--force"]) == 0 and out.read_text().startswith("<?xml")


@pytest.mark.parametrize(
    "words", [["--at", "x"], ["--at", "nan"], ["--at", "-1"], ["--frames", "0"], ["--frames", "9" * 99]]
)
def test_numbers_that_are_none_are_refused(tmp_path: Path, words: list[str], capsys) -> None:
    with pytest.raises(SystemExit) as raised:
        command.main([str(cast(tmp_path)), "--svg", str(tmp_path / "o.svg"), *words])
    assert raised.value.code == 2 and "isn't a number" in capsys.readouterr().err
