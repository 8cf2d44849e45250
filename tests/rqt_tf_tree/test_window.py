"""The TF tree's window on a stepped desktop: the tree by keyboard and mouse, at every size."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest
from rich.cells import cell_len
from textual import events

from day6_core.ros.programs.rqt_tf_tree.model import TfTree, snapshot
from day6_core.ros.programs.tf2_tools.frame_tree import Frame
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

NOW = 1_700_000_100.0


def frame(name: str, parent: str, age: float = 0.25, rate: float = 10.0) -> Frame:
    return Frame(name, parent, "default_authority", rate, 4.7, NOW - age, NOW - age - 4.7)


def static(name: str, parent: str) -> Frame:
    return Frame(name, parent, "default_authority", 10_000.0, 0.0, 0.0, 0.0)


def tree(*frames: Frame, folder: Path = Path("/nowhere")) -> TfTree:
    model = TfTree(folder.joinpath)
    model.show(snapshot(frames, NOW))
    return model


def car() -> TfTree:
    return tree(frame("car", "world"), frame("wheel", "car", age=7.5), static("激光", "car"))


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the tree, or of its head, in which a text stands."""
        rows = screen_lines(self.app)[3 : 4 + self.pane._rows]
        return next((line for line in rows if text in line), "")

    def chosen(self) -> str:
        """The text of the marked line."""
        choice = self.app.look.colours.choice
        for y in range(self.pane.inner_height):
            segments = list(self.pane.content_line(y, self.pane.inner_width))
            if segments and all(segment.style == choice for segment in segments):
                return "".join(segment.text for segment in segments).strip()
        return ""

    async def click(self, text: str) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y > 1 and text in line)
        await self.pilot.click(offset=(cell_len(lines[y][: lines[y].index(text)]), y))
        await step(self.app, self.pilot)

    async def wheel(self, kind: type[events.MouseEvent], *, shift: bool = False) -> None:
        self.pane.post_message(kind(self.pane, 5, 5, 0, 1, 0, shift, False, False, screen_x=5, screen_y=5))
        await self.pilot.pause()
        await step(self.app, self.pilot)


def use(
    model: TfTree, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: object
) -> None:
    use_window(("rqt_tf_tree", "TF Tree", model), act, size, _Window, **options)


def test_every_frame_says_how_old_it_is_how_often_it_comes_and_who_sends_it() -> None:
    async def act(window: _Window) -> None:
        assert window.line("Frame").strip("┃ ").split() == [
            "Frame",
            "Age",
            "s",
            "Rate",
            "Hz",
            "Buffer",
            "s",
            "Broadcaster",
        ]
        assert window.line("└─ car").strip("┃ ").split() == ["└─", "car", "0.25", "10.00", "4.70", "default_authority"]
        assert window.line("激光").strip("┃ ").split() == ["└─", "激光", "static", "default_authority"]
        assert window.line("world").strip("┃ ") == "world"
        assert "Recorded at time: 1700000100.000" in window.text

    use(car(), act)


@pytest.mark.parametrize("size", [(40, 10), (60, 16), (80, 24), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("glyphs", ["half", "cell", "ascii"])
def test_age_and_name_are_seen_at_every_size(size: tuple[int, int], lang: str, glyphs: str) -> None:
    async def act(window: _Window) -> None:
        assert "7.50" in window.line("wheel") and "0.25" in window.line(" car ")
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))

    use(car(), act, size, lang=lang, glyphs=glyphs)


def test_old_frames_are_marked_and_counted() -> None:
    async def act(window: _Window) -> None:
        assert "1 old" in window.text
        await window.press("home")
        warning = window.app.look.colours.warning
        rows = {
            "".join(each.text for each in found).split()[1]: {each.style for each in found}
            for y in range(3, 6)
            if (found := list(window.pane.content_line(y, 78)))
        }
        assert warning in rows["wheel"] and warning not in rows["car"] and warning not in rows["激光"]

    use(car(), act)


def test_the_chosen_frame_is_told_below_in_the_words_of_the_original() -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "down")
        assert window.chosen().split()[1] == "car"
        assert "Average rate: 10.0" in window.text and "Oldest transform: 1700000095.05" in window.text
        await window.press("home")
        assert "world: a root." in window.text

    use(car(), act)


def test_a_click_chooses_and_the_chosen_frame_stays_chosen() -> None:
    async def act(window: _Window) -> None:
        await window.click("wheel")
        assert "wheel" in window.chosen()
        window.model.show(snapshot([frame("a", "world"), *window.model.snapshot.frames], NOW))
        await step(window.app, window.pilot)
        assert "wheel" in window.chosen()
        window.model.show(snapshot([frame("a", "world")], NOW))
        await step(window.app, window.pilot)
        assert window.chosen().split()[1] == "a"

    use(car(), act)


def test_the_buttons_of_the_original_by_key_and_mouse() -> None:
    asked: list[str] = []

    async def act(window: _Window) -> None:
        window.model.on_request = lambda: asked.append("refresh")
        await window.press("r")
        await window.click("refresh")
        assert asked == ["refresh"] * 2
        await window.press("c")
        assert window.model.clear_wanted
        window.model.clear_wanted = False
        await window.click("clear buffer")
        assert window.model.clear_wanted
        await window.press("a")
        assert not window.model.auto_refresh and "[ ] auto refresh" in window.text
        await window.click("auto refresh")
        assert window.model.auto_refresh

    use(car(), act)


def big() -> TfTree:
    return tree(*(frame(f"frame{number}.", f"frame{(number - 1) // 3}.") for number in range(1, 300)))


def test_three_hundred_frames_scroll_by_keys_and_wheel() -> None:
    async def act(window: _Window) -> None:
        await window.press("end")
        assert "300/300" in window.text and window.chosen()
        await window.press("pageup", "pageup")
        assert window.chosen()
        await window.press("home")
        assert window.chosen() == "frame0." and "1/300" in window.text
        await window.wheel(events.MouseScrollDown)
        assert not window.line("frame0.") and "1/300" in window.text
        await window.wheel(events.MouseScrollUp)
        assert window.line("frame0.")

    use(big(), act)


def deep() -> TfTree:
    return tree(*(frame(f"frame{number + 1}.", f"frame{number}.") for number in range(100)))


def test_in_a_deep_tree_no_line_is_empty_and_names_move_sideways() -> None:
    async def act(window: _Window) -> None:
        await window.press("end")
        assert all(window.line(f"frame{number}.") for number in range(96, 101))
        assert window.chosen().startswith("└─ frame100.")
        await window.press("home")
        assert window.chosen() == "frame0."
        assert "… frame14." in window.line("frame14.") and "0.25" in window.line("frame14.")
        await window.wheel(events.MouseScrollDown, shift=True)
        assert "… frame0." in window.line("frame0.")
        await window.press("left")
        assert window.line("frame0.").strip("┃ ") == "frame0."
        await window.wheel(events.MouseScrollRight)
        await window.wheel(events.MouseScrollLeft)
        assert window.line("frame0.").strip("┃ ") == "frame0."

    use(deep(), act)


@pytest.mark.parametrize("size", [(80, 24), (41, 11), (120, 40)])
def test_a_name_that_is_cut_off_says_so_and_is_told_in_full_below(size: tuple[int, int]) -> None:
    name = "the_third_camera_on_the_left_side_" * 2

    async def act(window: _Window) -> None:
        assert "… " in window.line("the_third")
        await window.press("down")
        told = screen_lines(window.app)[-2]
        assert name in told if size[0] >= 80 else "the_third_camera" in told and "…" in told

    use(tree(frame(name, "base")), act, size)


def test_keys_that_would_do_nothing_are_not_offered() -> None:
    async def act(window: _Window) -> None:
        assert all(key != "← →" for key, _ in window.pane.key_hints())
        window.model.show(deep().snapshot)
        await step(window.app, window.pilot)
        assert any(key == "← →" for key, _ in window.pane.key_hints())

    use(car(), act)


def test_a_circle_is_named() -> None:
    async def act(window: _Window) -> None:
        assert "a (again: a loop)" in window.text

    use(tree(frame("a", "b"), frame("b", "a")), act)


def test_names_that_control_terminals_are_text() -> None:
    async def act(window: _Window) -> None:
        await window.press("end")
        assert 'q"\\^[[31m^Jx' in window.text

    use(tree(frame('q"\\\x1b[31m\nx', "\x9b2J")), act)


def test_without_frames_and_with_trouble_it_says_so() -> None:
    async def act(window: _Window) -> None:
        assert "No tf data received" in window.text
        window.model.fail("Service /tf2_frames does not answer")
        await step(window.app, window.pilot)
        assert "Service /tf2_frames does not answer" in window.text
        await window.press("down", "end", "pageup", "left")

    use(tree(), act)


def test_it_is_saved_and_a_file_that_is_there_is_replaced_only_on_a_second_enter(tmp_path: Path) -> None:
    model = tree(frame("car", "world"), folder=tmp_path)
    (tmp_path / "frames.pdf").write_text("mine")

    async def act(window: _Window) -> None:
        await window.press("w", "enter")
        assert not model.save_wanted
        await window.press("enter")
        assert model.save_wanted == "frames.pdf"
        model.save(model.save_wanted)
        await step(window.app, window.pilot)
        assert "saved: frames.pdf" in window.text
        model.save("nowhere/frames.pdf")
        await step(window.app, window.pilot)
        assert "frames.pdf: No such file or directory" in window.text
        await window.press("ctrl+s", *["backspace"] * 3, "g", "i", "f", "enter")
        assert ".svg, .pdf, .png" in window.text
        await window.press("escape")

    use(model, act)
