"""What the programs of rqt say on their command lines: options, help and errors (qt_gui's main.py)."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.ros.programs.rqt_gui import perspectives
from day6_core.ros.programs.rqt_gui.catalogue import KNOWN
from tests.support.stepped_machine import Running, SteppedMachine


@pytest.fixture
def machine():
    made = SteppedMachine()
    yield made
    made.end()


def status(machine: SteppedMachine, package: str, *words: str, home: Path) -> tuple[int | None, Running]:
    running = machine.start(package, package, *words, screen=True, home=home)
    machine.until(lambda: running.program.status is not None)
    return running.program.status, running


@pytest.mark.parametrize("package", ["rqt_gui", *sorted(entry.package for entry in KNOWN)])
def test_every_program_tells_its_options_and_refuses_others(
    machine: SteppedMachine, package: str, tmp_path: Path
) -> None:
    ended, running = status(machine, package, "--help", home=tmp_path)
    assert ended == 0 and running.output.startswith(f"usage: {'rqt' if package == 'rqt_gui' else package} [")
    ended, running = status(machine, package, "--speed", home=tmp_path)
    assert ended == 2 and "error: unrecognized arguments: --speed\n" in running.errors
    assert machine.display.windows == []


def test_options_about_the_window_of_qt_are_taken(machine: SteppedMachine, tmp_path: Path) -> None:
    machine.start("rqt_graph", "rqt_graph", "--force-discover", "-t", "-ht", screen=True, home=tmp_path)
    machine.advance(0.2)
    assert [window.kind for window in machine.display.windows] == ["rqt_graph"]


def test_clear_config_forgets_the_perspectives(machine: SteppedMachine, tmp_path: Path) -> None:
    store = perspectives.Perspectives(tmp_path / ".config" / "ros.org" / "rqt_gui")
    store.save("mine", [])
    machine.start("rqt_topic", "rqt_topic", "--clear-config", screen=True, home=tmp_path)
    machine.until(lambda: machine.display.windows)
    assert "mine" not in store.names()


def test_a_plot_can_begin_paused(machine: SteppedMachine, tmp_path: Path) -> None:
    machine.start("rqt_plot", "rqt_plot", "-P", "-e", "/pose/x", screen=True, home=tmp_path)
    machine.until(lambda: machine.display.windows)
    (window,) = machine.display.windows
    assert window.model.paused_at is not None and [curve.path for curve in window.model.curves] == ["/pose/x"]


def test_a_perspective_file_must_be_there(machine: SteppedMachine, tmp_path: Path) -> None:
    ended, running = status(machine, "rqt_gui", "--perspective-file", "none.perspective", home=tmp_path)
    assert ended == 1 and running.output == "Option --perspective-file must reference existing file\n"
