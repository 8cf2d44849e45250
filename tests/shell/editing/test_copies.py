"""Copies of unsaved texts: one for each editor, offered once their editor is gone, and never while it lives."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from day6_core.shell.editing.copies import Copies, Form, Holder
from day6_core.shell.editing.model import Editor

OF_AN_EDITOR = """
    import sys, time
    from pathlib import Path
    from day6_core.shell.editing.model import Editor
    editor = Editor(Path(sys.argv[1]), Path(sys.argv[2]), "vim")
    editor.open(Path(sys.argv[1], "a.py"))
    editor.keep("typed in another desktop")
    print("kept", flush=True)
    time.sleep(600)
"""


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A file that is edited."""
    path = tmp_path / "a.py"
    path.write_text("saved\n")
    return path


def opened(path: Path, program: str = "nano") -> Editor:
    editor = Editor(path.parent, path.parent / "state", program)
    editor.open(path)
    return editor


def names(path: Path) -> list[str]:
    """What lies in the folder of copies."""
    return sorted(each.suffix for each in (path.parent / "state").iterdir())


def test_two_editors_of_a_file_have_a_copy_each_and_saving_one_leaves_the_others(path: Path) -> None:
    first, second = opened(path), opened(path, "gedit")
    first.keep("of the first")
    second.keep("of the second")
    first.save("saved by the first")
    assert second.changed_outside() and not first.changed_outside()
    second.close()
    assert opened(path).text == "of the second"


def test_the_copy_of_an_editor_that_is_open_is_not_offered(path: Path) -> None:
    first = opened(path, "gedit")
    first.keep("still being typed")
    second = opened(path)
    assert (second.text, second.recovered, second.left) == ("saved\n", False, [])
    assert second.others() == [Holder("gedit", os.getpid())] and first.others() == [Holder("nano", os.getpid())]
    first.close()
    assert second.others() == []
    third = opened(path)
    assert third.text == "still being typed" and third.recovered


def test_of_several_editors_that_are_gone_no_text_is_lost(path: Path) -> None:
    editors = [opened(path) for _ in range(3)]
    for at, (editor, text) in enumerate(zip(editors, ("one", "two", "three"), strict=True)):
        editor.keep(text)
        (copy,) = (each for each in (path.parent / "state").glob("*.json") if text in each.read_text())
        os.utime(copy, (at, at))
    for editor in editors:
        editor.close()
    editor = opened(path)
    assert (editor.text, [copy.text for copy in editor.left]) == ("three", ["two", "one"])
    editor.choose(editor.left[1])
    assert (editor.text, editor.recovered) == ("one", True)
    editor.save(editor.text)
    editor.close()
    editor = opened(path)
    assert (editor.text, [copy.text for copy in editor.left]) == ("three", ["two"])


def test_what_is_saved_under_another_name_is_offered_no_texts_of_the_old_one(path: Path) -> None:
    for text in ("one", "two"):
        editor = opened(path)
        editor.keep(text)
    editor.close()
    editor = opened(path)
    assert editor.left
    editor.save_as(path.with_name("other.py"), "mine")
    assert (editor.text, editor.left) == ("mine", [])


def test_a_text_that_was_offered_is_still_there_if_that_editor_dies_too(path: Path) -> None:
    editor = opened(path)
    editor.keep("typed")
    for _ in range(3):
        editor.close()
        editor = opened(path)
        assert editor.text == "typed" and names(path) == [".json", ".lock"]
    editor.keep(editor.saved)
    editor.close()
    assert names(path) == [] and not opened(path).recovered


def test_two_editors_do_not_both_take_a_text_that_was_left(path: Path) -> None:
    editor = opened(path)
    editor.keep("typed")
    editor.close()
    both = [Copies(path, path.parent / "state", "nano") for _ in range(2)]
    (copy,) = both[0].left()
    assert both[1].left() == [copy]
    assert both[0].take(copy) and not both[1].take(copy)
    both[1].keep(Form(), "the second's own")
    assert both[0].others() == [Holder("nano", os.getpid())]


def test_a_copy_that_is_in_the_file_by_now_is_not_offered(path: Path) -> None:
    editor = opened(path)
    editor.keep("typed")
    editor.close()
    path.write_text("typed")
    assert not opened(path).recovered and list((path.parent / "state").glob("*.json")) == []


def test_a_copy_of_an_older_day6_tui_is_offered(path: Path) -> None:
    editor = opened(path)
    editor.keep("typed long ago")
    editor.close()
    (copy,) = (path.parent / "state").glob("*.json")
    copy.rename(copy.with_name(copy.name.partition("-")[0] + ".json"))
    again = opened(path)
    assert again.text == "typed long ago"
    again.save(again.text)
    again.close()
    assert names(path) == []


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_file_opened_through_a_link_is_the_same_file(path: Path) -> None:
    link = path.with_name("link.py")
    link.symlink_to(path)
    first, second = opened(path), opened(link)
    assert first.others() and second.others()


def test_where_nothing_can_be_locked_a_text_is_kept_and_offered(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> bool:
        raise OSError(37, "No locks available")

    monkeypatch.setattr("day6_core.link.file_lock._lock", refuse)
    editor = opened(path)
    editor.keep("typed")
    editor.close()
    assert opened(path).text == "typed"


@pytest.mark.process
def test_an_editor_of_another_desktop_lives_until_it_is_killed(path: Path) -> None:
    words = [sys.executable, "-c", textwrap.dedent(OF_AN_EDITOR), str(path.parent), str(path.parent / "state")]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdout is not None and other.stdout.readline() == "kept\n"
        editor = opened(path)
        assert not editor.recovered and editor.others() == [Holder("vim", other.pid)]
        other.send_signal(getattr(signal, "SIGKILL", signal.SIGTERM))
        other.wait()
        assert editor.others() == []
        editor.close()
    assert opened(path).text == "typed in another desktop"
