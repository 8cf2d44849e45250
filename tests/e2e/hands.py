"""Two people at the same desktop: one has no mouse, the other uses it for everything that is not typing a command."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

from day6_tui.locale import Texts
from tests.e2e.mouse import Mouse

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal

PROMPT = "student@day6:~$"


class Hands(ABC):
    """What both do alike. Panes are named by the number and the beginning of their title, as on the screen: "1 ~"."""

    def __init__(self, screen: Terminal, lang: str) -> None:
        self.screen = screen
        self.texts = Texts(lang)
        self.rviz = "2 RViz"
        """The title of RViz's pane."""

    def has(self, title: str) -> None:
        """Wait until the pane with this title has the keyboard: its frame is the bright one; and F2, F4, F8 are in the bar."""
        self.screen.wait(lambda seen: re.search(rf"┏[^╭┓\n]* {re.escape(title)}", seen))
        self.screen.wait(lambda seen: all(f"{key} " in seen.split("\n")[-1] for key in ("F2", "F4", "F8")))

    def run(self, command: str) -> None:
        """Type a command into the terminal that has the keyboard."""
        self.screen.line(command)

    # -- what the two do differently -----------------------------------------------------------------------------------

    @abstractmethod
    def welcome(self, choice: str) -> None:
        """Choose an entry of the welcome, by the key of its text."""

    @abstractmethod
    def new_terminal(self, number: int) -> None: ...

    @abstractmethod
    def go_to(self, title: str) -> None: ...

    @abstractmethod
    def enlarge(self, title: str) -> None:
        """Give the pane that has the keyboard the whole screen, or put it back."""

    @abstractmethod
    def inspect(self) -> None:
        """Open the inspector from the palette."""

    @abstractmethod
    def close_window(self, title: str) -> None: ...

    @abstractmethod
    def move_graph(self) -> None:
        """Move the picture of rqt_graph, whose pane has the keyboard, by eight columns to the right."""

    @abstractmethod
    def fixed_frame(self, old: str, new: str) -> None:
        """Choose RViz's Fixed Frame."""

    @abstractmethod
    def add_display(self, name: str) -> None:
        """Add a display to RViz."""

    @abstractmethod
    def description_topic(self, topic: str) -> None:
        """Choose the topic of the RobotModel that was added."""

    @abstractmethod
    def slide(self, joint: str) -> None:
        """Move the first slider of joint_state_publisher_gui, that of `joint`, to the right."""


class Keyboard(Hands):
    """Sends no report of a mouse."""

    def welcome(self, choice: str) -> None:
        number = ("turtle", "car", "world", "lessons", "empty").index(choice) + 1
        self.screen.wait(f" {number}  {self.texts(f'welcome.{choice}')}", PROMPT)
        self.screen.press(str(number))

    def new_terminal(self, number: int) -> None:
        self.screen.press("F2")
        self.has(f"{number} ~")

    def go_to(self, title: str) -> None:
        self.screen.press(f"\x1b{title.split()[0]}")
        self.has(title)

    def enlarge(self, title: str) -> None:
        self.screen.press("F8")

    def inspect(self) -> None:
        self.screen.press("F7")
        self.screen.wait(self.texts("menu.filter"))
        self.screen.send(self.texts("action.inspector"))
        self.screen.wait_gone(self.texts("menu.filter"))
        self.screen.press("Enter")

    def close_window(self, title: str) -> None:
        self.screen.press("F4")
        self.screen.wait(self.texts("menu.keys.close"))
        self.screen.send(title.split(" ", 1)[1])
        self.screen.wait_gone(self.texts("menu.filter"))
        self.screen.press("Delete", "Esc")

    def move_graph(self) -> None:
        self.screen.press("Left")

    def fixed_frame(self, old: str, new: str) -> None:
        self.go_to(self.rviz)
        self.screen.press("Down", "Enter")
        self.screen.wait(self.texts("rviz.type_it"))
        self.screen.send(new)
        self.screen.press("Enter")

    def add_display(self, name: str) -> None:
        self.screen.press("Ctrl-N")
        self.screen.wait(self.texts("rviz.type.TF"))
        self.screen.send(name)
        self.screen.wait_gone(self.texts("rviz.type.TF"))
        self.screen.press("Enter")

    def description_topic(self, topic: str) -> None:
        self.screen.wait(lambda seen: "RobotModel" in self._chosen_line())
        while "▸ Description Topic" not in (line := self._chosen_line()):
            self.screen.press("Down")
            self.screen.wait(lambda seen, line=line: self._chosen_line() not in ("", line))
        self.screen.press("Enter")
        self.screen.wait(self.texts("rviz.type_it"))
        self.screen.press("Enter")

    def _chosen_line(self) -> str:
        """The chosen line of RViz's panel, the only one that is not on the panel's background."""
        left, top, _, bottom = self.screen.inside(self.rviz)
        # Below the tools, above the buttons.
        rows = range(top + 1, next((row for row in range(top, bottom) if "Add" in self.screen.row(row)), top))
        grounds = [self.screen.colours(left + 1, row)[1] for row in rows]
        chosen = [row for row, ground in zip(rows, grounds, strict=True) if grounds.count(ground) == 1]
        return self.screen.row(chosen[0]) if len(chosen) == 1 else ""

    def slide(self, joint: str) -> None:
        self.screen.press(*["Right"] * 9)


class Pointer(Hands):
    """Uses keys for texts and for what programs read, and for nothing else."""

    def __init__(self, screen: Terminal, lang: str) -> None:
        super().__init__(screen, lang)
        self.mouse = Mouse(screen)

    def welcome(self, choice: str) -> None:
        self.screen.wait(PROMPT)
        self.mouse.click_on(self.texts(f"welcome.{choice}"))

    def new_terminal(self, number: int) -> None:
        self._press_in_bar("F2")
        self.has(f"{number} ~")

    def go_to(self, title: str) -> None:
        self.mouse.click_on(f" {title}")
        self.has(title)

    def enlarge(self, title: str) -> None:
        column, row = self.mouse.find(f" {title}")
        self.mouse.double_click(column + 2, row)

    def inspect(self) -> None:
        self._press_in_bar("F7")
        self.screen.wait(self.texts("menu.filter"))
        self.screen.send(self.texts("action.inspector"))
        self.screen.wait_gone(self.texts("menu.filter"))
        self.mouse.click_on(f"▸ {self.texts('action.inspector')}")

    def close_window(self, title: str) -> None:
        column, row = self.mouse.find(f" {title}")
        crosses = [x for x, text in zip(self.screen.columns_of(row), self.screen.row(row), strict=True) if text == "×"]
        self.mouse.click(min(x for x in crosses if x > column), row)

    def move_graph(self) -> None:
        column, row = self.screen.find("/teleop_turtle", "6 rqt_graph") or (0, 0)
        self.mouse.drag((column, row + 2), (column + 4, row + 2), (column + 8, row + 2))

    def fixed_frame(self, old: str, new: str) -> None:
        self.mouse.click_on(f"Fixed Frame {old}")
        self.screen.wait(self.texts("rviz.type_it"))
        self.mouse.click_on(f" {new} ")

    def add_display(self, name: str) -> None:
        self.mouse.click_on("Add")
        self.mouse.click_on(self.texts(f"rviz.type.{name}"))

    def description_topic(self, topic: str) -> None:
        column, row = self.mouse.find("RobotModel")
        self.mouse.wheel(column, row, -4)
        column, row = self.mouse.find("▸ Description Topic")
        self.mouse.double_click(column + 4, row)
        self.screen.wait(self.texts("rviz.type_it"))
        self.mouse.click_on(f" {topic} ")

    def slide(self, joint: str) -> None:
        self.screen.wait(lambda seen: self.screen.find("●", "5 Joint"))
        column, row = self.screen.find("●", "5 Joint") or (0, 0)
        self.mouse.drag((column, row), (column + 2, row), (column + 3, row))

    def _press_in_bar(self, key: str) -> None:
        row = self.screen.rows - 1
        self.mouse.click(self.screen.columns_of(row)[self.screen.row(row).index(key)], row)
