"""Whatever UTF-8 text a file holds: opened and saved it is the same bytes, and an edit changes nothing but its own place."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from day6_core.shell.editing.file import CannotEdit, put_together, taken_apart
from day6_core.shell.editing.model import Editor
from day6_tui.textual_private.document import ColouredLines, PlainDocument
from tests.editor.editor_bench import Bench

ENDS = [
    "\n",
    "\r\n",
    "\r",
    "\f",
    "\v",
    "\x1c",
    "\x1d",
    "\x1e",
    "\x85",
    "\u2028",
    "\u2029",
    "\ufeff",
    "\0",
    "\t",
    "\x1b",
]
TEXTS = st.lists(st.one_of(st.sampled_from(ENDS), st.text(max_size=4)), max_size=30).map("".join)
SHAPES = [
    b"",
    b"\n",
    b"\r",
    b"\r\n",
    b"no end",
    b"\xef\xbb\xbf",
    b"\xef\xbb\xbf\xef\xbb\xbfx\r\n",
    b"a\r\nb\nc\r\n",
    b"a\r\r\nb\r\n",
    b"a\rb\rc",
    b"a\x0cb\x0bc\x1cd\x1de\x1ef\n",
    "a\x85b\u2028c\u2029d".encode(),
    b"\x00\x00\n\x00",
    b"x = 1\r\ny = '\x0c'\r\n",
]


def a_document(text: str, language: str) -> PlainDocument:
    if not language:
        return PlainDocument(text)
    tree_sitter = pytest.importorskip("tree_sitter")
    python = pytest.importorskip("tree_sitter_python")
    return ColouredLines(text, tree_sitter.Language(python.language()))


@settings(deadline=None)
@given(TEXTS)
def test_form_and_text_together_are_the_file(whole: str) -> None:
    form, text = taken_apart(whole)
    assert put_together(form, text) == whole
    assert form.newline == "\n" or "\r\n" in whole


@pytest.mark.parametrize("language", ["", "python"])
@settings(deadline=None)
@given(TEXTS, TEXTS, st.data())
def test_a_document_is_its_text_also_after_edits_and_their_undoing(
    language: str, text: str, new: str, data: st.DataObject
) -> None:
    document = a_document(text, language)
    assert document.text == text
    first, last = sorted(data.draw(st.tuples(*[st.integers(0, len(text))] * 2)))
    done = document.replace_range(document.get_location_from_index(first), document.get_location_from_index(last), new)
    assert done.replaced_text == text[first:last]
    assert document.text == text[:first] + new + text[last:]
    assert document.get_index_from_location(done.end_location) == first + len(new)
    document.replace_range(document.get_location_from_index(first), done.end_location, done.replaced_text)
    assert document.text == text


@settings(max_examples=300, deadline=None)
@given(TEXTS, st.data())
def test_a_save_writes_the_bytes_that_were_read_and_the_edit(whole: str, data: st.DataObject) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.txt")
        path.write_bytes(whole.encode())
        editor = Editor(Path(folder), Path(folder, "state"), "nano")
        editor.open(path)
        document = PlainDocument(editor.text)
        editor.save(document.text)
        assert path.read_bytes() == whole.encode()
        at = data.draw(st.integers(0, len(editor.text)))
        place = document.get_location_from_index(at)
        document.replace_range(place, place, "#")
        editor.save(document.text)
        assert editor.file is not None
        mark, newline = editor.file.form
        before = len(mark) + len(editor.saved[:at].replace("\n", newline))
        assert path.read_bytes() == (whole[:before] + "#" + whole[before:]).encode()
        editor.close()


@pytest.mark.long
@pytest.mark.parametrize("data", SHAPES, ids=repr)
@pytest.mark.parametrize("name", ["a.py", "a.txt"])
def test_a_file_is_unchanged_on_the_screen_and_a_save_gives_the_same_bytes(
    tmp_path: Path, data: bytes, name: str
) -> None:
    path = tmp_path / name
    path.write_bytes(data)

    async def act(bench: Bench) -> None:
        assert not bench.pane.changed
        await bench.press("ctrl+s")
        assert path.read_bytes() == data and not bench.pane.changed
        await bench.press("#", "ctrl+s")
        mark = 3 if data.startswith(b"\xef\xbb\xbf") else 0
        assert path.read_bytes() == data[:mark] + b"#" + data[mark:]
        await bench.press("ctrl+z", "ctrl+s")
        assert path.read_bytes() == data

    Bench(tmp_path, file=name).run(act)


@pytest.mark.parametrize("data", [b"caf\xe9\n", "轮子\n".encode("gbk"), b"\xed\xa0\x80", b"ok\n\xff"])
def test_what_is_not_utf_8_is_refused_and_not_touched(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "a.txt"
    path.write_bytes(data)
    with pytest.raises(CannotEdit, match="not UTF-8 text"):
        Editor(tmp_path, tmp_path / "state", "nano").open(path)
    assert path.read_bytes() == data and [path.name for path in tmp_path.iterdir()] == ["a.txt"]


def test_a_pasted_text_has_the_line_ends_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_bytes(b"end\r\n")

    async def act(bench: Bench) -> None:
        await bench.paste("a\rb\r\nc\u2028d\n")
        await bench.press("ctrl+s")
        assert path.read_bytes() == "a\r\nb\r\nc\u2028d\r\nend\r\n".encode()

    Bench(tmp_path, file="a.txt").run(act)


def test_an_unsaved_text_comes_back_with_its_form_also_when_the_file_is_gone(tmp_path: Path) -> None:
    path, state = tmp_path / "a.txt", tmp_path / "state"
    path.write_bytes(b"\xef\xbb\xbfa\r\nb\r\n")
    editor = Editor(tmp_path, state, "nano")
    editor.open(path)
    editor.keep("a\nb\nc\n")
    editor.close()
    path.unlink()
    again = Editor(tmp_path, state, "nano")
    again.open(path)
    assert again.recovered
    again.save(again.text)
    assert path.read_bytes() == b"\xef\xbb\xbfa\r\nb\r\nc\r\n"


def test_saved_under_another_name_it_keeps_its_line_ends(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes(b"a\r\n")
    editor = Editor(tmp_path, tmp_path / "state", "nano")
    editor.open(tmp_path / "a.txt")
    editor.save_as(tmp_path / "b.txt", editor.text)
    assert (tmp_path / "b.txt").read_bytes() == b"a\r\n"
