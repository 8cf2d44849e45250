"""Lists of names as teachers have them."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.classroom.homes import folder_name, same_name
from day6_tui.web import class_list
from day6_tui.web.class_list import BadList
from day6_tui.web.names import BadName, clean


def read(folder: Path, data: bytes) -> class_list.ClassList:
    (folder / "pupils.csv").write_bytes(data)
    return class_list.read(folder / "pupils.csv")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "gbk", "utf-16"])
@pytest.mark.parametrize(
    "text",
    [
        "李雷\n韩梅梅\n",
        "学号;姓名\r\n1;李雷\r\n2;韩梅梅\r\n",
        "name\tclass\n李雷\t3\n\n韩梅梅\t3",
        "李雷,3\n韩梅梅,3\n",
    ],
)
def test_one_name_a_line_or_a_table_in_any_usual_encoding(tmp_path: Path, text: str, encoding: str) -> None:
    found = read(tmp_path, text.encode(encoding))
    assert found.names == ["李雷", "韩梅梅"] and not found.bad


def test_lines_without_a_fit_name_are_told_by_their_number_and_what_stands_there(tmp_path: Path) -> None:
    found = read(tmp_path, b"anna\n\x1b[31mred\nAnna\n" + b"x" * 50 + b"\nbert\n")
    assert found.names == ["anna", "bert"]
    assert found.bad == [
        (2, "^[[31mred", "serve.name.letters"),
        (3, "Anna", "serve.class.twice"),
        (4, "x" * 39 + "…", "serve.name.long"),
    ]


def test_a_row_of_a_table_without_a_name_is_shown_whole(tmp_path: Path) -> None:
    found = read(tmp_path, '姓名;组\r\n李雷;1\r\n;2\r\n"a\nb";3\r\n'.encode())
    assert found.names == ["李雷", "a b"]
    assert found.bad == [(3, ";2", "serve.class.nameless")]


@pytest.mark.parametrize("data", [b"", b"\n\n", b"name,group\n"])
def test_a_list_may_be_empty(tmp_path: Path, data: bytes) -> None:
    found = read(tmp_path, data)
    assert not found.names and not found.bad


def test_what_is_no_text_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadList):
        read(tmp_path, b"\xff\xff\xff\n")


def test_names_that_are_one_pupils_have_one_folder_and_others_never() -> None:
    names = ["anna", "Anna", "ａｎｎａ", "a/b", "a b", "a-b", "..", "con", "李雷", "é", "e\u0301"]
    fit = []
    for name in names:
        try:
            fit.append(clean(name))
        except BadName:
            assert name in ("a/b", "..")
    by_name = {same_name(name): folder_name(name) for name in fit}
    assert len(set(by_name.values())) == len(by_name) == len(fit) - 3
    assert all("/" not in folder and not folder.startswith((".", "-")) for folder in by_name.values())
