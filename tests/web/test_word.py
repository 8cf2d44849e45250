"""Where the class word comes from, and who can read it there."""

from __future__ import annotations

import io
import os
import sys
from pathlib import Path

import pytest

from day6_tui.web.options import parse


@pytest.fixture
def file(tmp_path: Path) -> Path:
    made = tmp_path / "word"
    made.write_text(" blue turtle \nsecond line\n", encoding="utf-8")
    made.chmod(0o600)
    return made


def test_only_a_word_on_the_command_line_is_seen_by_others(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("蓝色海龟\nand more\n"))
    found = [parse(["--word", word], "en") for word in ("red turtle", str(file), "-")]
    assert [(each.word, each.word_is_seen) for each in found] == [
        ("red turtle", True),
        ("blue turtle", False),
        ("蓝色海龟", False),
    ]
    assert (parse([], "en").word, parse([], "en").word_is_seen) == (None, False)


@pytest.mark.parametrize(
    ("language", "mode", "text", "said"),
    [
        ("en", 0o644, "blue turtle", "other users can read {file}; do: chmod 600 {file}"),
        ("zh", 0o644, "blue turtle", "别的用户能读 {file}；请运行 chmod 600 {file}"),
        ("en", 0o600, "abc", "{file} has 3 characters, at least 4 are needed"),
        ("zh", 0o600, "\n", "{file}：只有 0 个字符，至少要 4 个"),
    ],
)
@pytest.mark.skipif(os.name != "posix", reason="files have no modes here")
def test_a_file_that_will_not_do_is_told_without_the_word(
    file: Path, capsys: pytest.CaptureFixture[str], language: str, mode: int, text: str, said: str
) -> None:
    file.write_text(text, encoding="utf-8")
    file.chmod(mode)
    with pytest.raises(SystemExit):
        parse(["--word", str(file)], language)
    told = capsys.readouterr().err
    assert said.format(file=file) in told and not (text.strip() and text in told)
