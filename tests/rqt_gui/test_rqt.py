"""`rqt`: plugins side by side on one node, kept as perspectives."""

from __future__ import annotations

import errno
import json
import os
import sys
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.programs.rqt_gui import perspectives
from day6_core.ros.programs.rqt_gui.catalogue import plugins
from day6_core.ros.programs.rqt_gui.perspectives import Instance
from tests.support.stepped_machine import Running, SteppedMachine


class Room:
    """A machine with a home, and the `rqt` in it."""

    def __init__(self, home: Path) -> None:
        self.home = home
        self.machine = SteppedMachine()

    def rqt(self, *words: str) -> Running:
        """Start it, and wait until it has opened its perspective."""
        running = self.machine.start("rqt_gui", "rqt_gui", *words, screen=True, home=self.home)
        if running.program.status is None:
            self.machine.until(lambda: "rqt" in self.kinds and self.model.perspectives)
        return running

    def leave(self, running: Running) -> None:
        running.program.interrupt()
        self.machine.until(lambda: running.program.status is not None)

    @property
    def kinds(self) -> list[str]:
        """The kinds of the windows that are open, without the menu's."""
        return [window.kind for window in self.machine.display.windows]

    @property
    def model(self) -> Any:
        return next(window.model for window in self.machine.display.windows if window.kind == "rqt")

    def start(self, *packages: str) -> None:
        """Open plugins, one after the other."""
        for package in packages:
            self.ask(lambda package=package: self.model.start(entry(package)))

    def ask(self, deed: Any) -> None:
        """Ask for something, and wait until it is done and kept."""
        before = self.model.version
        deed()
        self.machine.until(lambda: not self.model.requests and self.model.version > before)

    @property
    def nodes(self) -> list[str]:
        return sorted(name for name in self.machine.node.get_node_names() if name != "watcher")


def entry(package: str) -> Any:
    return next(each for each in plugins() if each.package == package)


@pytest.fixture
def room(tmp_path: Path):
    made = Room(tmp_path)
    yield made
    made.machine.end()


def test_plugins_run_side_by_side_on_one_node(room: Room) -> None:
    room.rqt()
    assert room.kinds == ["rqt"] and room.nodes == []
    room.start("rqt_graph", "rqt_console", "rqt_plot")
    assert room.kinds == ["rqt", "rqt_graph", "rqt_console", "rqt_plot"]
    assert len(room.nodes) == 1 and room.nodes[0].startswith("rqt_gui_py_node_")
    assert [plugin.title for plugin in room.model.open] == ["Node Graph", "Console", "Plot"]


def test_a_plugin_that_is_closed_takes_its_subscription_along_and_the_others_stay(room: Room) -> None:
    running = room.rqt()
    room.start("rqt_console", "rqt_graph")
    room.machine.until(lambda: room.machine.node.count_subscribers("/rosout") == 1)
    room.ask(next(each for each in room.machine.display.windows if each.kind == "rqt_console").close_by_user)
    assert room.kinds == ["rqt", "rqt_graph"] and room.machine.node.count_subscribers("/rosout") == 0
    assert running.program.status is None


def test_every_plugin_opens_beside_the_others_and_leaves_nothing_behind(room: Room) -> None:
    packages = [each.package for each in plugins()]
    running = room.rqt()
    room.start(*packages)
    assert [plugin.entry.package for plugin in room.model.open] == packages
    room.leave(running)
    room.rqt()
    assert [plugin.entry.package for plugin in room.model.open] == packages
    for plugin in room.model.open:
        room.ask(lambda plugin=plugin: room.model.stop(plugin))
    assert room.kinds == ["rqt"]
    left = {name for name in room.nodes if name.startswith("rqt_gui_")}
    node = room.machine.node
    for name in left:
        assert node.get_client_names_and_types_by_node(name, "/") == []
        assert dict(node.get_subscriber_names_and_types_by_node(name, "/")).keys() <= {"/parameter_events"}


def test_a_plugin_can_be_open_twice_and_a_free_number_is_taken_again(room: Room) -> None:
    room.rqt()
    room.start("rqt_plot", "rqt_plot", "rqt_plot")
    assert [plugin.title for plugin in room.model.open] == ["Plot", "Plot (2)", "Plot (3)"]
    room.ask(lambda: room.model.stop(room.model.open[1]))
    room.start("rqt_plot")
    assert [plugin.serial for plugin in room.model.open] == [1, 3, 2]


def test_the_next_rqt_begins_with_what_was_open_and_its_settings(room: Room) -> None:
    running = room.rqt()
    room.start("rqt_console", "rqt_plot")
    plot = room.machine.display.windows[-1].model
    plot.add("/turtle1/pose/x")
    room.machine.until(lambda: plot.curves)
    room.leave(running)
    room.rqt()
    assert room.kinds == ["rqt", "rqt_console", "rqt_plot"]
    assert [curve.path for curve in room.machine.display.windows[-1].model.curves] == ["/turtle1/pose/x"]


def test_changed_settings_are_written_while_rqt_goes_on(room: Room) -> None:
    room.rqt()
    room.start("rqt_plot")
    file = room.home / ".config" / "ros.org" / "rqt_gui" / "Default.perspective"
    room.machine.display.windows[-1].model.add("/turtle1/pose/x")
    room.machine.until(lambda: "/turtle1/pose/x" in file.read_text())


def test_closing_the_menu_ends_the_program_with_all_its_plugins(room: Room) -> None:
    running = room.rqt()
    room.start("rqt_graph")
    room.machine.display.windows[0].close_by_user()
    room.machine.until(lambda: running.program.status is not None)
    assert room.kinds == [] and room.nodes == []


def test_perspectives_are_made_switched_and_removed(room: Room) -> None:
    running = room.rqt()
    room.start("rqt_graph")
    room.ask(lambda: room.model.keep_as("talk"))
    room.start("rqt_console")
    room.ask(lambda: room.model.switch("Default"))
    assert room.kinds == ["rqt", "rqt_graph"] and room.model.perspectives == ("Default", "talk")
    room.ask(lambda: room.model.switch("talk"))
    assert room.kinds == ["rqt", "rqt_graph", "rqt_console"]
    room.ask(lambda: room.model.remove("Default"))
    assert [plugin.entry.package for plugin in room.model.open] == ["rqt_graph", "rqt_console"]
    room.leave(running)
    listed = room.machine.start("rqt_gui", "rqt_gui", "--list-perspectives", home=room.home)
    room.machine.until(lambda: listed.program.status is not None)
    assert listed.output.split() == ["Default", "talk"]
    room.leave(room.rqt("-p", "Default"))
    room.rqt()
    assert room.kinds == ["rqt"]


def test_a_perspective_named_on_the_command_line_stays_in_its_folder(room: Room) -> None:
    room.rqt("-p", "../../outside")
    room.start("rqt_graph")
    assert room.model.perspective == "..__..__outside" and room.model.trouble == ""
    written = {path.parent.name for path in room.home.rglob("*outside*")}
    assert written == {"rqt_gui"}


def test_a_tilde_in_a_files_name_is_the_home_of_the_simulated_machine(room: Room) -> None:
    room.rqt()
    room.ask(lambda: room.model.export("~/mine.perspective"))
    assert room.model.trouble == "" and (room.home / "mine.perspective").is_file()
    assert not Path("~/mine.perspective").expanduser().exists()


def test_a_file_of_the_real_rqt_opens_what_there_is_and_the_rest_stays_in_it(room: Room) -> None:
    """In the shape of qt_gui's perspective_manager.py, with what Qt keeps of its windows."""
    keys = {"topics": {"type": "repr", "repr": "['/turtle1/pose/theta']"}}
    plot = {"keys": {}, "groups": {"plugin": {"keys": keys, "groups": {}}, "dock_widget__DataPlotWidget": {"keys": {
        "dockable": {"type": "repr", "repr": "True"}, "parent": {"type": "repr", "repr": "None"}}, "groups": {}}}}  # fmt: skip
    running = {"type": "repr", "repr": "{'rqt_plot/Plot': [2], 'rqt_dance/Dance': [1]}"}
    manager = {"keys": {"running-plugins": running}, "groups": {"plugin__rqt_plot__Plot__2": plot}}
    state = {"type": "repr(QByteArray.hex)", "repr(QByteArray.hex)": "QtCore.QByteArray('00')", "pretty-print": "?"}
    window = {"keys": {"geometry": state, "state": state}, "groups": {}}
    text = json.dumps({"keys": {}, "groups": {"mainwindow": window, "pluginmanager": manager}})
    (room.home / "mine.perspective").write_text(text)
    rqt = room.rqt("--perspective-file", "mine.perspective")
    assert room.kinds == ["rqt", "rqt_plot"] and room.model.open[0].title == "Plot (2)"
    assert [curve.path for curve in room.machine.display.windows[-1].model.curves] == ["/turtle1/pose/theta"]
    assert "could not load plugin 'rqt_dance/Dance': plugin not available" in rqt.errors
    room.ask(lambda: room.model.export("again.perspective"))
    again = perspectives.load_file(room.home / "again.perspective")
    assert [(each.name, each.serial) for each in again] == [("rqt_plot/Plot", 2), ("rqt_dance/Dance", 1)]
    assert again[0].settings == {"topics": ["/turtle1/pose/theta"]}


@pytest.mark.parametrize(
    "text",
    ["", "{", "[]", "null", '{"groups": 3}', '{"groups": {"pluginmanager": {"keys": {}}}}', "[" * 100_000,
     json.dumps({"groups": {"pluginmanager": {"keys": {"running-plugins": {"type": "repr", "repr": "__import__('os')"}}}}}),
     json.dumps({"groups": {"pluginmanager": {"keys": {"running-plugins": {"type": "repr", "repr": "(" * 5000}}}}}),
     json.dumps({"groups": {"pluginmanager": {"keys": {"running-plugins": {"type": "repr", "repr": "{'a/b': ['x']}"}}}}}),
     "x" * 1_100_000],
)  # fmt: skip
def test_a_damaged_perspective_is_told_and_stays_as_it_is(room: Room, text: str) -> None:
    kept = room.home / ".config" / "ros.org" / "rqt_gui" / "Default.perspective"
    kept.parent.mkdir(parents=True)
    kept.write_text(text)
    running = room.rqt()
    assert room.model.trouble and room.kinds == ["rqt"]
    room.start("rqt_graph")
    room.leave(running)
    assert kept.read_text() == text


@pytest.mark.parametrize("name", ["missing.perspective", ".", "/dev/null/x"])
def test_a_file_that_cannot_be_read_or_written_is_told_and_what_is_open_stays(room: Room, name: str) -> None:
    room.rqt()
    room.start("rqt_graph")
    room.ask(lambda: room.model.load(name))
    assert room.model.trouble and room.kinds == ["rqt", "rqt_graph"]
    (room.home / "file").touch()
    room.ask(lambda: room.model.export("~/file/x.perspective"))
    assert room.model.trouble and room.kinds == ["rqt", "rqt_graph"]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no named pipes in folders")
def test_a_pipe_is_refused_as_a_perspective_and_nothing_waits_for_its_writer(room: Room) -> None:
    os.mkfifo(room.home / "pipe.perspective")
    room.rqt()
    room.ask(lambda: room.model.load(room.home / "pipe.perspective"))
    assert room.model.trouble.endswith(os.strerror(errno.EAGAIN))


def test_settings_of_any_shape_in_a_perspective_do_no_harm(room: Room) -> None:
    for value in (3, {"a": 1}, [None, 3], "text"):
        perspectives.save_file(room.home / "odd.perspective", [Instance("rqt_plot/Plot", 1, {"topics": value})])
        running = room.rqt("--perspective-file", "odd.perspective")
        assert room.kinds == ["rqt", "rqt_plot"]
        room.leave(running)


@pytest.mark.parametrize("word", ["rqt_plot", "rqt_plot.plot.Plot", "plot"])
def test_standalone_opens_a_window_at_once(room: Room, word: str) -> None:
    room.machine.start("rqt_gui", "rqt_gui", "--standalone", word, "--args", "/pose/x", screen=True)
    room.machine.advance(0.2)
    (window,) = room.machine.display.windows
    assert window.kind == "rqt_plot" and window.model.curves[0].path == "/pose/x"


def test_what_names_no_plugin_or_several_is_told_in_rqts_words(room: Room) -> None:
    start = room.machine.start
    assert start("rqt_gui", "rqt_gui", "-s", "tea").output == 'qt_gui_main() found no plugin matching "tea"\n'
    several = start("rqt_gui", "rqt_gui", "-s", "o")
    assert (
        several.output.startswith('qt_gui_main() found multiple plugins matching "o"\n') and several.program.status == 1
    )
    assert "Option --args can only be used together with" in start("rqt_gui", "rqt_gui", "--args", "x").output


def test_without_a_screen_the_plugins_are_listed(room: Room) -> None:
    listed = room.machine.start("rqt_gui", "rqt_gui").output.split()
    assert {"rqt_graph.ros_graph.RosGraph", "rqt_topic.topic.Topic"} <= set(listed) and listed == sorted(listed)


TYPED = ("rqt_service_caller", "rqt_publisher", "rqt_action", "rqt_msg", "rqt_srv")
"""The plugins whose fields are typed into, or that browse types."""


def test_plugins_with_fields_share_the_node_and_leave_nothing_on_it(room: Room) -> None:
    room.rqt()
    room.start(*TYPED)
    assert len(room.kinds) == 6 and len(room.nodes) == 1
    models = {window.kind: window.model for window in room.machine.display.windows}
    models["publisher"].add("/greeting", "std_msgs/msg/String")
    room.machine.until(lambda: room.machine.node.count_publishers("/greeting") == 1)
    for plugin in list(room.model.open):
        room.ask(lambda plugin=plugin: room.model.stop(plugin))
    assert room.kinds == ["rqt"] and room.machine.node.count_publishers("/greeting") == 0


def test_publishers_and_the_chosen_service_come_back_with_the_perspective(room: Room) -> None:
    running = room.rqt()
    room.start("rqt_service_caller", "rqt_publisher")
    caller, publisher = (window.model for window in room.machine.display.windows[1:])
    caller.choose("/watcher/set_parameters")
    publisher.add("/greeting", "std_msgs/msg/String", 2.0)
    publisher.set_expression(0, "/data", "'Hello %d' % i")
    publisher.set_enabled(0, True)
    room.machine.advance(1.0)
    room.leave(running)
    room.rqt()
    caller, publisher = (window.model for window in room.machine.display.windows[1:])
    room.machine.until(lambda: caller.service == "/watcher/set_parameters")
    (shown,) = publisher.shown()
    assert (shown.topic, shown.rate, shown.enabled, shown.rows[0].text) == ("/greeting", 2.0, False, "'Hello %d' % i")
