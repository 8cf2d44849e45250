"""`rqt`: a menu that becomes the window that was chosen."""

from __future__ import annotations

import pytest
from stepped_machine import SteppedMachine


@pytest.fixture
def machine():
    made = SteppedMachine()
    yield made
    made.end()


def kinds(machine):
    return [window.kind for window in machine.display.windows]


def test_choosing_opens_the_window_in_place_of_the_menu(machine):
    running = machine.start("rqt_gui", "rqt_gui", screen=True)
    assert kinds(machine) == ["rqt"]
    menu = machine.display.windows[0].model
    menu.choose(next(plugin for plugin in menu.plugins if plugin.package == "rqt_console"))
    machine.advance(0.1)
    assert kinds(machine) == ["rqt_console"] and running.program.status is None
    running.program.interrupt()
    machine.advance(0.1)
    assert kinds(machine) == []


def test_standalone_opens_a_window_at_once(machine):
    machine.start("rqt_gui", "rqt_gui", "--standalone", "rqt_plot", "--args", "/pose/x", screen=True)
    machine.advance(0.2)
    (window,) = machine.display.windows
    assert window.kind == "rqt_plot" and window.model.curves[0].path == "/pose/x"
    assert "there is no plugin 'rqt_tea'" in machine.start("rqt_gui", "rqt_gui", "-s", "rqt_tea").errors


def test_without_a_screen_the_plugins_are_listed(machine):
    assert machine.start("rqt_gui", "rqt_gui").output.split() == ["rqt_graph", "rqt_console", "rqt_topic", "rqt_plot"]
