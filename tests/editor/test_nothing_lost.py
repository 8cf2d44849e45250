"""An editor on a full disk, in a folder that vanishes, on a file that became a folder: it says so, and the text stays."""

from __future__ import annotations

import errno
import json
import os
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.shell.editing.model import Editor
from day6_tui.windows.editor.editor import KEEP_SECONDS
from tests.editor.editor_bench import Bench
from tests.tui.screens import screen_text

Disk = Callable[[bool], None]


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch) -> Disk:
    """`disk(True)` makes it full: what was written does not get there, as on a file system that says so late."""
    real = os.fsync
    full = False

    def fsync(number: int) -> None:
        if full:
            raise OSError(errno.ENOSPC, "No space left on device")
        real(number)

    def fill(wanted: bool) -> None:
        nonlocal full
        full = wanted

    monkeypatch.setattr(os, "fsync", fsync)
    return fill


def names(folder: Path) -> list[str]:
    """Every file and folder in `folder`."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


async def keep_now(bench: Bench) -> str:
    """Let the second pass after which the unsaved text is kept; return the screen."""
    bench.pane._edited = bench.pane._unsafe = 1e-9
    await bench.step()
    return screen_text(bench.app)


async def look_now(bench: Bench) -> str:
    """Let the editor look at the disk; return the screen."""
    bench.pane._looked = 0.0
    await bench.step()
    return screen_text(bench.app)


@pytest.mark.parametrize("size", [(80, 24), (40, 16)])
def test_a_save_on_a_full_disk_is_told_and_the_old_file_is_whole(
    tmp_path: Path, disk: Disk, size: tuple[int, int]
) -> None:
    (tmp_path / "talker.py").write_text("old = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        disk(True)
        await bench.press("#")
        assert "not saved" in await bench.press("ctrl+s")
        assert bench.text == "#old = 1\n" and bench.saved == "old = 1\n" and bench.open
        assert [name for name in names(tmp_path) if not name.endswith(".lock")] == ["state", "talker.py"], (
            "nothing is left"
        )
        disk(False)
        assert "not saved" not in await bench.press("ctrl+s")

    assert Bench(tmp_path).run(act, *size).saved == "#old = 1\n"


def test_nano_does_not_leave_when_the_save_fails(tmp_path: Path, disk: Disk) -> None:
    async def act(bench: Bench) -> None:
        disk(True)
        await bench.press("a", "ctrl+x", "y")
        assert "not saved: No space left on device" in await bench.press("enter")
        assert bench.open and bench.text == "a"

    Bench(tmp_path).run(act)


def test_that_no_copy_can_be_kept_is_told_until_there_is_room_again(tmp_path: Path, disk: Disk) -> None:
    async def act(bench: Bench) -> None:
        disk(True)
        await bench.press("a")
        assert "no backup of the text: No space left on device" in await keep_now(bench)
        assert "no backup" in await look_now(bench)
        disk(False)
        assert "no backup" not in await look_now(bench)

    async def again(bench: Bench) -> None:
        assert bench.text == "a" and bench.pane.editor.recovered

    Bench(tmp_path, "gedit").run(act)
    Bench(tmp_path, "gedit").run(again)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_leaving_the_desktop_asks_when_a_text_is_neither_saved_nor_kept(tmp_path: Path, disk: Disk, lang: str) -> None:
    async def act(bench: Bench) -> None:
        left: list[object] = []
        bench.app.exit = lambda *result, **more: left.append(more)
        disk(True)
        await bench.press("a")
        bench.app.actions["quit"]()  # not with ^Q, which closes the file of an editor
        seen = await bench.press()
        assert not left and "talker.py" in seen and "No space" in seen
        await bench.press("n", "escape")
        assert not left and bench.text == "a" and bench.open
        bench.app.actions["quit"]()
        await bench.press("y")
        assert left == [{}]
        disk(False)
        bench.app.actions["quit"]()
        assert len(left) == 2, "a text that is kept needs no question"

    Bench(tmp_path).run(act, lang=lang)


def test_a_signal_ends_the_desktop_with_what_was_typed_last_kept(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a", "b")
        left: list[dict[str, object]] = []
        bench.app.exit = lambda **more: left.append(more)
        bench.app.leaving.end_by_signal()
        assert left == [{}]

    async def again(bench: Bench) -> None:
        assert bench.text == "ab"

    Bench(tmp_path).run(act)
    Bench(tmp_path).run(again)


def test_a_signal_on_a_full_disk_tells_what_was_lost(tmp_path: Path, disk: Disk) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        disk(True)
        left: list[dict[str, object]] = []
        bench.app.exit = lambda **more: left.append(more)
        bench.app.leaving.end_by_signal()
        assert left[0]["return_code"] == 1 and "talker.py (No space left on device)" in str(left[0]["message"])

    Bench(tmp_path).run(act)


def test_a_closed_gedit_asks_a_third_time_when_there_is_no_room_for_a_copy(tmp_path: Path, disk: Disk) -> None:
    async def act(bench: Bench) -> None:
        disk(True)
        await bench.press("a")
        assert "has unsaved changes" in await bench.press("ctrl+w")
        assert "again loses the text" in await bench.press("n") and bench.open
        await bench.press("ctrl+w", "n")
        assert not bench.open

    Bench(tmp_path, "gedit").run(act)


def test_the_cross_and_the_desktops_key_ask_as_the_editors_own_key_does(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        bench.app.actions["close"]()
        await bench.step()
        assert bench.open and "Save modified buffer?" in screen_text(bench.app)
        await bench.press("escape")
        bench.pane.title_right()[-1].action()
        await bench.step()
        assert bench.open and "Save modified buffer?" in screen_text(bench.app)

    Bench(tmp_path).run(act)


def test_a_nano_that_is_ended_from_outside_keeps_what_was_typed_last(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        bench.window.close_by_user()  # as when its terminal is closed
        await bench.step()

    async def again(bench: Bench) -> None:
        assert bench.text == "a"

    Bench(tmp_path).run(act)
    Bench(tmp_path).run(again)


def test_another_file_is_not_opened_over_a_text_that_cannot_be_kept(tmp_path: Path, disk: Disk) -> None:
    (tmp_path / "other.py").write_text("other = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        disk(True)
        await bench.press("a", "ctrl+t")
        await bench.press("enter")
        assert bench.text == "a" and "no backup" in screen_text(bench.app)

    Bench(tmp_path, "gedit").run(act)


def test_a_file_whose_folder_vanishes_stays_in_the_editor_and_can_be_saved(tmp_path: Path) -> None:
    folder = tmp_path / "src"
    folder.mkdir()
    path = folder / "talker.py"
    path.write_text("only = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        path.unlink()
        (folder / "state").is_dir() or folder.rmdir()
        seen = await look_now(bench)
        assert bench.text == "only = 1\n" and "gone from disk" in seen
        await look_now(bench)
        assert bench.text == "only = 1\n" and bench.pane.changed
        await bench.press("ctrl+s")
        await bench.press("ctrl+s")

    bench = Bench(folder)
    bench.state = tmp_path / "state"
    assert bench.run(act).saved == "only = 1\n"


def test_a_file_that_became_a_folder_is_told_and_the_text_stays(tmp_path: Path) -> None:
    path = tmp_path / "talker.py"
    path.write_text("old = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        path.unlink()
        path.mkdir()
        await bench.press("#")
        await bench.press("ctrl+s")
        assert "not saved: Is a directory" in await bench.press("ctrl+s")
        assert bench.text == "#old = 1\n"

    Bench(tmp_path).run(act)
    assert names(tmp_path)[-1] == "talker.py" and not list(path.iterdir())


@pytest.mark.usefixtures("plain_user")
def test_a_read_only_folder_is_told(tmp_path: Path) -> None:
    folder = tmp_path / "locked"
    folder.mkdir()

    async def act(bench: Bench) -> None:
        folder.chmod(0o500)
        await bench.press("a")
        assert "not saved: Permission denied" in await bench.press("ctrl+s")
        assert bench.text == "a"

    bench = Bench(folder)
    bench.state = tmp_path / "state"
    bench.run(act)


@pytest.mark.skipif(os.name != "posix", reason="Windows has no modes")
def test_copies_of_unsaved_texts_are_for_this_user_alone(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    bench.state.mkdir(mode=0o755)

    async def act(bench: Bench) -> None:
        await bench.press("a")
        await keep_now(bench)

    bench.run(act)
    assert stat.S_IMODE(bench.state.stat().st_mode) == 0o700
    assert [stat.S_IMODE(path.stat().st_mode) for path in bench.state.iterdir()] == [0o600]


def kept(bench: Bench) -> list[str]:
    """The texts of all copies."""
    return sorted(json.loads(path.read_text(encoding="utf-8"))["text"] for path in bench.state.glob("*.json"))


def test_who_types_without_a_pause_has_a_copy_nevertheless(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        assert kept(bench) == []
        bench.pane._unsafe -= KEEP_SECONDS
        await bench.press("b")
        assert kept(bench) == ["ab"], "a second after the first key, though the last one was typed just now"
        await bench.press("c")
        assert kept(bench) == ["ab"], "not with every key"
        bench.pane._unsafe -= KEEP_SECONDS
        await bench.press("d")
        assert kept(bench) == ["abcd"]

    Bench(tmp_path).run(act)


def test_a_text_that_goes_out_of_sight_right_after_a_key_has_a_copy(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        assert kept(bench) == []
        bench.pane.display = False  # as behind another tab
        await bench.step()
        assert kept(bench) == ["a"]

    Bench(tmp_path).run(act)


def test_a_file_that_goes_from_the_disk_leaves_a_copy_of_its_text(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("a = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        bench.path.unlink()
        await look_now(bench)
        await keep_now(bench)
        assert kept(bench) == ["a = 1\n"], "it exists nowhere else"

    Bench(tmp_path).run(act)


def test_a_file_that_is_open_elsewhere_is_told_on_both_sides(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        other = Editor(tmp_path, bench.state, "gedit")
        other.open(bench.path)
        assert "also open in another window (gedit)" in await look_now(bench)
        await bench.press("a")
        await keep_now(bench)
        other.keep("b")
        assert kept(bench) == ["a", "b"]
        await bench.press("ctrl+s")
        assert kept(bench) == ["b"] and other.changed_outside()
        other.save("b")
        assert bench.saved == "b"
        assert "a" in await bench.press("x")
        assert "changed elsewhere" in await look_now(bench)
        other.close()
        assert "also open" not in await look_now(bench)

    Bench(tmp_path).run(act)


def test_several_texts_that_were_left_can_be_chosen_from(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    editors = [Editor(tmp_path, bench.state, "nano") for _ in range(2)]
    for at, editor in enumerate(editors):
        editor.open(bench.path)
        editor.keep(f"# text {at}")
    for at, editor in enumerate(editors):
        (copy,) = (path for path in bench.state.glob("*.json") if f"# text {at}" in path.read_text())
        os.utime(copy, (at, at))
        editor.close()

    async def act(bench: Bench) -> None:
        assert "Several texts of this file were not saved" in screen_text(bench.app) and bench.text == "# text 1"
        await bench.press("down", "enter")
        assert bench.text == "# text 0" and "unsaved text restored" in screen_text(bench.app)
        await bench.press("ctrl+s")
        assert (bench.saved, kept(bench)) == ("# text 0", ["# text 1"])

    bench.run(act)
