"""Player and Recorder of Lyrical's rosbag2_py: controlled from the program while they play and record, in real time."""

from __future__ import annotations

from pathlib import Path

import pytest
import rosbag2_py
from rosbag2_py import _controlled, _transport
from std_msgs.msg import String

import rclpy
from rclpy.node import Node
from tests.bag.test_storage import MILLISECOND, START, read, texts, write
from tests.support.waiting import PATIENCE, until

pytestmark = pytest.mark.process


@pytest.fixture
def node(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("DAY6_LINK", "off")
    with rclpy.init():
        yield Node("ear")


def storage(path: Path) -> rosbag2_py.StorageOptions:
    return rosbag2_py.StorageOptions(uri=str(path), storage_id="mcap")


def test_a_player_is_paused_stepped_sought_and_stopped(tmp_path, node):
    write(tmp_path / "bag", "mcap", 400)
    heard: list[str] = []
    node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 1000)
    options = rosbag2_py.PlayOptions()
    options.start_paused = True
    options.topics_to_filter = ["/chatter"]
    player = _controlled.Player(storage(tmp_path / "bag"), options, "warn", "my_player")
    assert (player.get_starting_time(), player.get_playback_duration()) == (START, 399 * MILLISECOND)
    assert player.wait_for_playback_to_finish(0.0) and not player.wait_for_playback_to_start(0.0)
    player.start_spin()
    player.start_spin()
    player.play()
    assert player.wait_for_playback_to_start(PATIENCE) and player.is_paused()
    assert not player.wait_for_playback_to_finish_exclusively(0.05)
    assert player.play_next() and player.burst(2) == 2
    until(lambda: len(heard) == 3, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))
    player.seek(START + 390 * MILLISECOND)
    player.resume()
    assert player.wait_for_playback_to_finish(PATIENCE)
    until(lambda: len(heard) == 13, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))
    assert heard == ["hi 0", "hi 1", "hi 2", *(f"hi {number}" for number in range(390, 400))]
    player.play()
    player.pause()
    player.stop()
    player.stop_spin()
    assert player.wait_for_playback_to_finish(PATIENCE)


def test_a_recorder_pauses_stops_and_records_again(tmp_path, node, in_distribution):
    in_distribution("lyrical")
    publisher = node.create_publisher(String, "chatter", 10)
    options = rosbag2_py.RecordOptions()
    options.topics = ["/chatter"]
    recorder = _controlled.Recorder(storage(tmp_path / "bag"), options, "warn")
    recorder.start_spin()
    recorder.record()

    def say(*words: str) -> None:
        for word in words:
            publisher.publish(String(data=word))

    until(lambda: publisher.get_subscription_count() == 1)
    say("a", "b")
    until(lambda: recorder._recording._writer._opened().metadata().message_count == 2)
    recording, heard = recorder._recording, []
    before = recording._services.before
    recording._services.before = lambda *info: (heard.append(info), before(*info))
    recorder.pause()
    assert recorder.is_paused()
    say("c")
    until(lambda: heard)
    with recording._lock:  # held until it has decided what to do with it
        recorder.resume()
    say("d")
    until(lambda: recorder._recording._writer._opened().metadata().message_count == 3)
    recorder.stop()
    assert texts(read(tmp_path / "bag")) == ["a", "b", "d"]
    recorder.record()
    until(lambda: publisher.get_subscription_count() == 1)
    say("e")
    until(lambda: recorder._recording._writer._opened().metadata().message_count == 1)
    recorder.stop()
    recorder.stop_spin()
    assert texts(read(tmp_path / "bag(1)")) == ["e"]


def test_what_was_before_still_works_and_says_what_replaces_it(tmp_path, node):
    write(tmp_path / "bag", "mcap", 3)
    with pytest.warns(
        DeprecationWarning, match=r"Player\(\) is deprecated. Use the constructor with full configuration"
    ):
        player = _controlled.Player()
    with pytest.raises(
        RuntimeError, match=r"Player is not initialized\. Please use constructor with storage and play options"
    ):
        player.play()
    with pytest.raises(RuntimeError, match="Player is not initialized"):
        player.pause()
    options = rosbag2_py.PlayOptions()
    with pytest.warns(DeprecationWarning, match="Use the parameterless play"):
        player.play(storage(tmp_path / "bag"), options)
    with pytest.warns(DeprecationWarning, match=r"Recorder\(log_level\) is deprecated"):
        recorder = _controlled.Recorder("warn")
    with pytest.raises(
        RuntimeError, match=r"Recorder is not initialized\. Please use constructor with storage and record options"
    ):
        recorder.record()
    with pytest.warns(DeprecationWarning, match=r"Please use Recorder.stop\(\) instead"):
        recorder.cancel()
    with pytest.raises(RuntimeError):
        _controlled.Player(storage(tmp_path / "nothing"), options)


@pytest.mark.parametrize(("name", "module"), [("kilted", "_transport"), ("lyrical", "_controlled")])
def test_which_classes_a_distribution_has(in_distribution, name, module):
    in_distribution(name)
    assert {_transport.Player.__module__, _transport.Recorder.__module__} == {f"rosbag2_py.{module}"}
