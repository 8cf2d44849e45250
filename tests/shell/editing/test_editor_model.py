"""The model of an editor window: which file, what is unsaved, what was checked, which files a folder offers."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest

from day6_core.shell.editing import model as model_module
from day6_core.shell.editing.checks import check, language_of
from day6_core.shell.editing.file import CannotEdit
from day6_core.shell.editing.model import Editor


@pytest.fixture
def editor(tmp_path: Path) -> Editor:
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "a.py").write_text("one\n")
    made = Editor(tmp_path / "src", tmp_path / "state", "gedit", tmp_path)
    made.open(tmp_path / "src" / "a.py")
    return made


def test_an_opened_file_is_shown_as_it_is(editor: Editor) -> None:
    assert (editor.text, editor.saved, editor.recovered, editor.version) == ("one\n", "one\n", False, 1)
    assert editor.title() == "a.py" and editor.exists() and not editor.changed_outside()


def test_before_a_file_is_chosen_the_folder_is_the_title(tmp_path: Path) -> None:
    editor = Editor(tmp_path / "src", tmp_path / "state", "code")
    assert editor.title() == "src"
    assert editor.check("def") is None and not editor.exists() and not editor.changed_outside()
    editor.keep("nothing to keep it for")
    assert not editor.is_outside(Path("/etc/passwd"))


def test_a_file_elsewhere_is_called_by_its_name_and_is_outside(editor: Editor, tmp_path: Path) -> None:
    inner = tmp_path / "src" / "pkg" / "b.py"
    inner.parent.mkdir()
    inner.write_text("")
    editor.open(inner)
    assert editor.title() == "pkg/b.py" and editor.version == 2
    other = tmp_path / "other.py"
    other.write_text("x")
    editor.open(other)
    assert editor.title() == "other.py"
    assert not editor.is_outside(other) and editor.is_outside(Path("/etc/hosts"))


def test_save_writes_the_text_and_forgets_the_copy(editor: Editor, tmp_path: Path) -> None:
    editor.keep("two\n")
    assert len(list((tmp_path / "state").glob("*.json"))) == 1
    editor.save("two\n")
    assert (tmp_path / "src" / "a.py").read_text() == "two\n"
    assert (editor.saved, editor.text, editor.recovered) == ("two\n", "two\n", False)
    assert list((tmp_path / "state").glob("*.json")) == []


def test_a_kept_text_comes_back_and_is_called_recovered(editor: Editor, tmp_path: Path) -> None:
    editor.keep("unsaved\n")
    editor.close()
    again = Editor(tmp_path / "src", tmp_path / "state", "gedit")
    again.open(tmp_path / "src" / "a.py")
    assert (again.text, again.saved, again.recovered) == ("unsaved\n", "one\n", True)
    again.keep("one\n")  # as it is on the disk: there is nothing to keep
    assert list((tmp_path / "state").glob("*.json")) == []
    editor.keep("one\n")
    again.open(tmp_path / "src" / "a.py")
    assert not again.recovered and again.version == 2


def test_save_as_goes_on_with_the_new_file(editor: Editor, tmp_path: Path) -> None:
    editor.keep("draft\n")
    editor.save_as(tmp_path / "src" / "new" / "b.py", "draft\n")
    assert (tmp_path / "src" / "new" / "b.py").read_text() == "draft\n"
    assert (tmp_path / "src" / "a.py").read_text() == "one\n"
    assert (editor.title(), editor.version, editor.saved, editor.text) == ("new/b.py", 2, "draft\n", "draft\n")
    assert list((tmp_path / "state").glob("*.json")) == []


def test_what_somebody_else_wrote_is_noticed_and_can_be_read_again(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "src" / "a.py").write_text("their text\n")
    assert editor.changed_outside()
    assert editor.reload() == "their text\n"
    assert (editor.saved, editor.text) == ("their text\n", "their text\n") and not editor.changed_outside()
    (tmp_path / "src" / "a.py").unlink()
    assert editor.changed_outside() and not editor.exists()


def test_a_file_that_cannot_be_opened_leaves_the_one_before(editor: Editor, tmp_path: Path) -> None:
    with pytest.raises(CannotEdit, match=r"src is a directory$"):
        editor.open(tmp_path / "src")
    assert editor.title() == "a.py" and editor.version == 1


def test_keys_of_the_terminal_wait_for_the_window(editor: Editor) -> None:
    editor.keys("ab")
    editor.keys("c")
    editor.resize(80, 24)
    assert editor.take_typed() == "abc" and editor.take_typed() == ""
    assert not editor.wants_signal_keys()


def test_a_folder_offers_what_a_person_edits_in_order(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("b.py", "a.yaml", ".hidden", "x.pyc", "p.png", "d.stl", "sub/c.py", "build/no.py", "install/no.py",
                 "log/no", "__pycache__/no.py", "node_modules/no", ".git/no", "m.mcap", "d.db3", "m.dae"):  # fmt: skip
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    editor = Editor(tmp_path, tmp_path / "state", "code")
    assert [path.relative_to(tmp_path).as_posix() for path in editor.files()] == ["a.yaml", "b.py", "sub/c.py"]
    monkeypatch.setattr(model_module, "MOST_FILES", 2)
    assert len(editor.files()) == 2


@pytest.mark.parametrize(
    ("name", "language"),
    [("a.py", "python"), ("a.PYI", "python"), ("a.xml", "xml"), ("r.urdf", "xml"), ("r.xacro", "xml"), ("l.launch", "xml"),
     ("w.world", "xml"), ("m.sdf", "xml"), ("p.yaml", "yaml"), ("p.yml", "yaml"), ("v.rviz", "yaml"), ("s.sh", "bash"),
     ("s.bash", "bash"), (".bashrc", "bash"), (".profile", "bash"), (".bash_aliases", "bash"), ("R.md", "markdown"),
     ("CMakeLists.txt", "")],
)  # fmt: skip
def test_the_name_of_a_file_says_its_language(name: str, language: str) -> None:
    assert language_of(Path(name)) == language


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("a.py", "x = 1\n", None),
        ("a.py", "", None),
        ("a.py", "x = 1\n  y = 2\n", (2, 0, "IndentationError: unexpected indent")),
        ("a.py", "\nprint('a'\n", (2, 6, "SyntaxError: '(' was never closed")),
        ("a.py", "'\\d'\n", None),
        ("a.xml", "<a><b></a>", (1, 9, "mismatched tag")),
        ("a.xml", "<a>\n <b>\n</a>", (3, 3, "mismatched tag")),
        ("a.xml", "<a/>", None),
        ("a.xml", "<!DOCTYPE a [<!ENTITY x 'y'>]><a/>", (1, 1, "entity definitions are not read here")),
        ("a.yaml", "a: 1\nb: [1, 2\n", (3, 1, "expected ',' or ']', but got '<stream end>'")),
        ("a.yaml", "a: 1\n\tb: 2\n", (2, 1, "found character '\\t' that cannot start any token")),
        ("a.yaml", "a: {b: 1}\n", None),
        ("a.md", "# anything [", None),
        ("r.urdf", "<robot name='r'><link name='a'/></robot>", None),
        ("r.urdf", "<robot name='r'>\n<link name='a'></robot>", (2, 18, "mismatched tag")),
    ],
)
def test_the_first_mistake_of_a_text(name: str, text: str, problem: tuple[int, int, str] | None) -> None:
    found = check(Path(name), text)
    if problem is None:
        assert found is None
    else:
        assert found is not None
        assert (found.line, found.message) == (problem[0], problem[2])
        if problem[1]:
            assert found.column == problem[1]


def test_checking_a_text_warns_nobody() -> None:
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        assert check(Path("a.py"), "x = '\\d' is 'd'\n") is None
    assert heard == []
