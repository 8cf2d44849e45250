"""The driver tells the line what is written, and what the terminal answers."""

from __future__ import annotations

from typing import Any

import pytest

driver_module = pytest.importorskip("day6_tui.textual_private.driver", reason="Windows has another driver")

from day6_tui.pixels.ask import IS_READY, READY  # noqa: E402
from day6_tui.screen.line import Line  # noqa: E402
from day6_tui.textual_private.hooks import HookedApp  # noqa: E402


class QuickTerminal:
    """Takes the place of the thread that writes; it answers before whoever wrote the question can do anything else."""

    def __init__(self, driver: Any) -> None:
        self._driver = driver
        self.written: list[str] = []

    def write(self, data: str) -> None:
        self.written.append(data)
        if data.endswith(READY):
            assert self._driver._is_for_line(IS_READY) == (data == READY)


@pytest.fixture
def driver() -> Any:
    made = driver_module.TerminalDriver.__new__(driver_module.TerminalDriver)
    made._app = app = HookedApp.__new__(HookedApp)
    app.line = Line()
    app.line.begin(may_ask=True)
    made._writer_thread = QuickTerminal(made)
    return made


def test_an_answer_that_comes_at_once_is_that_of_its_question(driver: Any) -> None:
    driver.ask()
    assert not driver._app.line.waits
    driver.write(f"a picture{READY}")
    assert not driver._app.line.waits


def test_what_is_written_comes_before_the_question_about_it(driver: Any) -> None:
    driver.write("x" * 10_000)
    assert driver._writer_thread.written == ["x" * 10_000, READY] and not driver._app.line.waits
