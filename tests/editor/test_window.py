"""The editor's window on a desktop whose frames the test draws: keys of nano, nothing lost, text of every kind."""

from __future__ import annotations

import asyncio
import time
from pathlib import Path

import pytest

from day6_core.shell.editing.model import Editor
from day6_tui.windows.editor.editor import KEEP_SECONDS, LOOK_SECONDS
from tests.editor.editor_bench import Bench
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_text, step

TALKER = "import rclpy\n\n\ndef main():\n    rclpy.init()\n    print('你好')\n"


def test_nano_writes_with_ctrl_o_and_enter_and_leaves_with_ctrl_x(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a", "b")
        assert "File Name to Write" in await bench.press("ctrl+o")
        await bench.press("enter")
        assert bench.saved == "ab" and bench.open
        await bench.press("ctrl+x")
        assert not bench.open

    bench = Bench(tmp_path).run(act)
    assert bench.saved == "ab"


def test_nano_asks_before_it_leaves_and_y_enter_saves(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        assert "Save modified buffer?" in await bench.press("ctrl+x")
        await bench.press("escape", "b")
        assert bench.open and bench.text == "ab"
        assert "talker.py" in await bench.press("ctrl+x", "y")
        await bench.press("enter")
        assert not bench.open

    assert Bench(tmp_path).run(act).saved == "ab"


def test_nano_throws_changes_away_only_when_told_so(tmp_path: Path) -> None:
    path = tmp_path / "talker.py"
    path.write_text(TALKER, encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.press("a", "ctrl+x", "n")
        assert not bench.open

    async def again(bench: Bench) -> None:
        assert bench.text == TALKER and not bench.pane.editor.recovered

    Bench(tmp_path).run(act)
    assert Bench(tmp_path).run(again).saved == TALKER


def test_ctrl_o_with_another_name_saves_there_and_goes_on_with_it(tmp_path: Path) -> None:
    (tmp_path / "old.py").write_text("x = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.press("a", "ctrl+o", "ctrl+u", *"old.py")
        assert "exists" in await bench.press("enter")
        assert (tmp_path / "old.py").read_text(encoding="utf-8") == "x = 1\n"
        assert "nano  old.py" in await bench.press("enter")

    Bench(tmp_path).run(act)
    assert (tmp_path / "old.py").read_text(encoding="utf-8") == "a" and not (tmp_path / "talker.py").exists()


def test_a_closed_gedit_asks_once_and_keeps_the_unsaved_text(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("a")
        assert "talker.py has unsaved changes" in await bench.press("ctrl+w")
        assert "has unsaved changes" not in await bench.press("escape") and bench.open
        await bench.press("ctrl+w", "n")
        assert not bench.open and not bench.path.exists()

    async def again(bench: Bench) -> None:
        assert bench.text == "a"
        assert "unsaved text restored" in screen_text(bench.app)

    Bench(tmp_path, "gedit").run(act)
    Bench(tmp_path, "gedit").run(again)


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_a_long_pasted_program_arrives_as_it_is(tmp_path: Path, line_end: str) -> None:
    program = "".join(f"def f{n}():\n    return {n}  # 第 {n} 个\n" for n in range(400))

    async def act(bench: Bench) -> None:
        await bench.paste(program.replace("\n", line_end))
        await bench.press("ctrl+s")

    assert Bench(tmp_path).run(act).saved == program


def test_a_program_pasted_as_keys_does_not_become_a_staircase(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.burst(TALKER.replace("'你好'", "1"))
        await bench.press("ctrl+s")

    assert Bench(tmp_path).run(act).saved == TALKER.replace("'你好'", "1")


def test_enter_keeps_the_depth_and_goes_deeper_after_a_colon(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        bench.pane.area.load_text("if True:")
        bench.pane.area.move_cursor((0, 8))
        await bench.slowly("enter")
        await bench.press("a")
        await bench.slowly("enter")
        await bench.press("b")

    bench = Bench(tmp_path)
    texts: list[str] = []

    async def look(one: Bench) -> None:
        await act(one)
        texts.append(one.text)

    bench.run(look)
    depth = "    " if bench.pane.area.language == "python" else ""
    assert texts == [f"if True:\n{depth}a\n{depth}b"]


def test_brackets_lead_deeper_and_back_and_backspace_takes_a_whole_step(tmp_path: Path) -> None:
    """Section 3.2: the entry points of setup.py, typed by hand."""

    async def act(bench: Bench) -> None:
        if bench.pane.area.language != "python":
            pytest.skip("the grammars are not installed")
        for line in ("entry_points={", "'console_scripts': [", "'talker = a:main',"):
            await bench.press(*line)
            await bench.slowly("enter")
        await bench.slowly("right_square_bracket")
        await bench.press(",")
        await bench.slowly("enter")
        assert bench.text.endswith("\n    ],\n    ")
        await bench.slowly("backspace")
        assert bench.text.endswith("    ],\n")
        await bench.slowly("right_curly_bracket")
        assert bench.text == "entry_points={\n    'console_scripts': [\n        'talker = a:main',\n    ],\n}"
        bench.app.screen.focused.move_cursor((2, 9))
        await bench.slowly("backspace")
        assert "        'alker" not in bench.text and "        talker" in bench.text

    Bench(tmp_path).run(act)


def test_tab_moves_chosen_lines_and_shift_tab_moves_them_back(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("a\n\nb\n    c\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.press("shift+down", "shift+down", "shift+down", "tab")
        assert bench.text == "    a\n\n    b\n        c\n"
        await bench.press("shift+tab", "shift+tab")
        assert bench.text == "a\n\nb\nc\n"
        await bench.press("ctrl+z")
        assert bench.text == "a\n\nb\n    c\n"
        await bench.press("ctrl+home", "tab")
        assert bench.text.startswith("    a\n")
        assert bench.app.screen.focused is bench.pane.area

    Bench(tmp_path).run(act)


def test_escape_leaves_the_keyboard_in_the_text(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.press("escape", "i")
        assert bench.text == "i" and bench.app.screen.focused is bench.pane.area

    Bench(tmp_path, "vim").run(act)


def test_nano_cuts_lines_and_puts_them_back(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("one\ntwo\nthree\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.press("ctrl+k", "ctrl+k")
        assert bench.text == "three\n"
        await bench.press("down", "ctrl+u")
        assert bench.text == "three\none\ntwo\n"

    Bench(tmp_path).run(act)


def test_keys_of_nanos_terminal_arrive_in_the_text_in_their_order(tmp_path: Path) -> None:
    """On a slow machine one types faster than the window opens."""

    async def act(bench: Bench) -> None:
        bench.pane.editor.keys("imp")
        bench.pane.editor.keys("ort 你好\rx\x7fy\x1b[A\x1b[H#")
        await bench.press("!")
        await bench.step()
        assert bench.text == "#!import 你好\ny"
        bench.pane.editor.keys("\x18")
        await bench.step()
        await bench.step()
        assert "Save modified buffer?" in screen_text(bench.app)

    Bench(tmp_path).run(act)


def test_a_file_with_windows_line_ends_keeps_them(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_bytes(b"a = 1\r\nb = 2\r\n")

    async def act(bench: Bench) -> None:
        await bench.press("#", "ctrl+s")

    Bench(tmp_path).run(act)
    assert (tmp_path / "talker.py").read_bytes() == b"#a = 1\r\nb = 2\r\n"


def test_chinese_is_typed_found_and_named_by_its_line(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        for char in "# 轮子":
            await bench.press("space" if char == " " else char)
        assert bench.text == "# 轮子"
        await bench.press("ctrl+home")
        screen = await bench.press("ctrl+f", "轮", "子", "enter")
        assert bench.pane.area.selected_text == "轮子" and "轮子" in screen

    Bench(tmp_path).run(act, lang="zh")


def test_a_file_outside_the_home_folder_is_saved_only_when_told_twice(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "scratch"))
    (tmp_path / "talker.py").write_text("mine\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        bench.pane.editor.home = tmp_path / "home"
        assert "outside your home folder" in await bench.press("x", "ctrl+s")
        assert bench.path.read_text(encoding="utf-8") == "mine\n"
        await bench.press("ctrl+s")
        assert bench.path.read_text(encoding="utf-8") == "xmine\n"
        await bench.press("y", "ctrl+s")  # told once is enough for a file
        assert bench.path.read_text(encoding="utf-8") == "xymine\n"
        await bench.press("ctrl+o", *"2", "enter")
        assert not (tmp_path / "talker.py2").exists()
        await bench.press("enter")
        assert (tmp_path / "talker.py2").exists()

    Bench(tmp_path).run(act)


def test_ctrl_q_in_the_editor_closes_its_file_and_asks_whether_to_save(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        left: list[object] = []
        bench.app.exit = lambda *result, **more: left.append(more)
        await bench.press("a")
        assert "talker.py has unsaved changes" in await bench.press("ctrl+q")
        await bench.press("enter")
        assert bench.path.read_text(encoding="utf-8") == "a" and not bench.open and left == []

    Bench(tmp_path, "gedit").run(act)


def test_asking_to_save_twice_is_not_asking_to_close(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("mine\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.press("x")
        bench.path.write_text("theirs, longer\n", encoding="utf-8")
        bench.pane._looked = 0.0
        assert "changed elsewhere" in await bench.press("ctrl+s")
        assert "has unsaved changes" in await bench.press("ctrl+w")
        assert bench.open and bench.path.read_text(encoding="utf-8").startswith("theirs")

    Bench(tmp_path, name="gedit").run(act)


def test_what_is_wrong_is_said_with_its_line(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        await bench.paste("def main()\n    pass\n")
        bench.pane._check()
        told = "after if, for, while, def and class"  # a colon is missing
        assert told in screen_text(bench.app) or told in await bench.press("up")

    Bench(tmp_path).run(act)


def test_a_very_long_line_can_be_walked_to_its_end(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("x" * 20_000 + "END\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        assert "END" in await bench.press("end")
        assert "1:20004" in screen_text(bench.app)

    Bench(tmp_path).run(act)


@pytest.mark.long
@pytest.mark.parametrize("size", [(40, 10), (80, 24), (300, 100)])
@pytest.mark.parametrize("language", ["en", "zh"])
def test_every_size_shows_the_text_and_the_question(tmp_path: Path, size: tuple[int, int], language: str) -> None:
    async def act(bench: Bench) -> None:
        assert "hello" in await bench.press(*"hello")
        question = await bench.press("ctrl+x")
        answers = [bench.app.look.texts(f"editor.modified.{answer}") for answer in ("save", "discard")]
        assert all(answer in question for answer in answers) and bench.open

    Bench(tmp_path).run(act, *size, lang=language)


def test_a_click_puts_the_cursor_there(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text("one\ntwo\nthree\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        await bench.pilot.click("EditorArea", offset=(5, 1))
        await bench.step()
        assert bench.pane.area.cursor_location[0] == 1

    Bench(tmp_path).run(act)


def test_a_change_on_the_disk_shows_up_unless_there_is_unsaved_text(tmp_path: Path) -> None:
    path = tmp_path / "talker.py"
    path.write_text("a = 1\n", encoding="utf-8")

    async def act(bench: Bench) -> None:
        path.write_text("a = 23\n", encoding="utf-8")
        bench.pane._looked = 0.0
        await bench.step()
        assert bench.text == "a = 23\n"
        await bench.press("#")
        path.write_text("a = 456\n", encoding="utf-8")
        bench.pane._looked = 0.0
        await bench.step()
        assert bench.text == "#a = 23\n" and "changed elsewhere" in screen_text(bench.app)
        await bench.press("ctrl+s")
        assert bench.saved == "a = 456\n", "not overwritten without a second word"
        await bench.press("ctrl+s")

    assert Bench(tmp_path).run(act).saved == "#a = 23\n"


def test_the_text_takes_the_theme_of_the_desktop(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        before = bench.pane.area.theme
        bench.app.looks.wear("light")
        await bench.step()
        assert bench.pane.area.theme != before

    Bench(tmp_path).run(act)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_code_on_an_empty_folder_makes_a_new_file_and_types_into_it(tmp_path: Path, lang: str) -> None:
    async def play() -> None:
        desk = FakeDesk()
        folder = tmp_path / "empty"
        folder.mkdir()
        desk.display.open("editor", "code", Editor(folder, tmp_path / "state", "code"))
        async with opened(desk, 80, 24, lang=lang, scene="empty") as (app, pilot):
            await step(app, pilot)
            await step(app, pilot)
            assert "1:1" not in screen_text(app)
            await pilot.press("enter", "enter")
            await step(app, pilot)
            await pilot.press(*"no/talker.py", "enter")
            assert not (folder / "no").exists() and app.desktop.overlay is not None
            await pilot.press("ctrl+u", *"talker.py", "enter")
            await step(app, pilot)
            await step(app, pilot)
            await pilot.press(*"x=1", "ctrl+s")
            assert (folder / "talker.py").read_text(encoding="utf-8").strip() == "x=1"

    asyncio.run(play())


def test_an_editor_that_stands_still_asks_for_a_frame_only_when_something_is_due(tmp_path: Path) -> None:
    async def act(bench: Bench) -> None:
        asked: list[float] = []
        bench.pane.look.wake_after = asked.append
        now = time.monotonic()
        assert bench.pane.pull(now) is False and 0 < asked[-1] <= LOOK_SECONDS
        await bench.press("a")
        now = time.monotonic()
        assert bench.pane.pull(now) is False and 0 <= asked[-1] <= KEEP_SECONDS, "for the copy of what was typed"
        assert bench.pane.pull(now + 10.0) is False and asked[-1] > 0
        assert list(bench.state.rglob("*.json")), "the copy"

    Bench(tmp_path).run(act)
