"""What a perspective keeps of rqt_bag: the bags, what is published, what is seen."""

from __future__ import annotations

import json

import pytest

from day6_core.ros.programs.rqt_bag.model.keeping import Kept, read_kept
from day6_core.ros.programs.rqt_bag.model.view import TimeSpan
from day6_core.ros.programs.rqt_gui.perspectives import Instance, save_file
from tests.rqt_bag.bag_desk import SECOND, START, write_bag


def look(desk):
    """Open a bag and look at a part of it; returns what is kept, as it comes back out of a file."""
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    desk.publish("/word", "/number")
    desk.jump(4.2)
    model.request(lambda: model.player.select((START + 2 * SECOND, START + 6 * SECOND)))
    model.view, model.thumbnails = TimeSpan(START + SECOND, START + 8 * SECOND), True
    desk.arrive()
    kept = json.loads(json.dumps(model.kept().settings()))
    desk.running.program.interrupt()
    desk.machine.until(lambda: desk.running.program.status is not None)
    return kept


def open_again(desk, kept, topics=3):
    """rqt with a perspective."""
    save_file(desk.folder / "a.perspective", [Instance("rqt_bag/Bag", 1, kept)])
    desk.running = desk.machine.start("rqt_gui", "rqt_gui", "--perspective-file", "a.perspective", screen=True)
    display = desk.machine.display
    desk.machine.until(lambda: [window.kind for window in display.windows] == ["rqt", "rqt_bag"])
    desk.model = display.windows[-1].model
    desk.machine.until(lambda: len(desk.model.topics) == topics and not desk.model.loading)
    if topics:
        desk.machine.until(lambda: not desk.model._resumed.bags)
    desk.arrive()
    return desk.model


def test_a_perspective_brings_back_the_bag_and_how_it_was_looked_at(desk):
    kept = look(desk)
    model = open_again(desk, kept)
    assert [bag.path for bag in model.bags] == [desk.folder / "bag"]
    assert model.player.publishing == {"/word", "/number"} and desk.playhead == 4.2
    assert model.player.region == (START + 2 * SECOND, START + 6 * SECOND)
    assert model.view == TimeSpan(START + SECOND, START + 8 * SECOND) and model.thumbnails
    assert model.kept().settings() == kept


def test_a_bag_that_is_gone_is_told_and_stays_in_the_perspective(desk):
    kept = look(desk)
    (desk.folder / "bag").rename(desk.folder / "elsewhere")
    model = open_again(desk, kept, topics=0)
    desk.machine.until(lambda: model.failed)
    assert "No storage could be initialized" in model.status
    assert model.kept().settings() == kept
    model.load(str(desk.folder / "elsewhere"))
    desk.machine.until(lambda: len(model.topics) == 3 and not model.loading)
    assert model.player.publishing == frozenset() and model.player.region is None


@pytest.mark.parametrize("odd", (None, 3, "text", [], [None], [3], {"a": 1}, [2**70, 5], [5, 2], [True, True]))
def test_settings_of_any_shape_do_no_harm(odd):
    names = Kept().settings()
    assert read_kept(dict.fromkeys(names, odd)) == Kept(playhead=3 if odd == 3 else None)
