"""The program: what it publishes where the playhead is moved to, and while it plays."""

from __future__ import annotations

import pytest
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Float64, String

from day6_core.ros.programs.rqt_bag.model.bags import Note
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from tests.rqt_bag.bag_desk import SECOND, START, write_bag

LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
EAR = QoSProfile(depth=1000, reliability=ReliabilityPolicy.BEST_EFFORT)


def values(seen):
    return [message.data for message in seen]


# -- scrubbing ---------------------------------------------------------------------------------------------------------


def test_a_jump_publishes_the_newest_message_at_the_playhead(desk, storage):
    write_bag(desk.folder / "bag", storage)
    desk.open("bag")
    numbers, words = desk.watch(Float64, "/number"), desk.watch(String, "/word")
    desk.publish("/number")
    assert values(numbers) == [0.0], "what is at the playhead comes at once"
    desk.jump(5.04)
    desk.jump(2.0)
    assert values(numbers) == [0.0, 50.0, 20.0]
    desk.jump(2.05)
    assert values(numbers) == [0.0, 50.0, 20.0], "it is still the same message"
    assert words == [], "only chosen topics are published"
    desk.publish("/word")
    assert values(words) == ["at 15"]
    desk.jump(0.1)
    assert values(words) == ["at 15"], "there is none before it"
    assert values(numbers)[-1] == 1.0


def test_a_topic_is_published_with_the_recorded_quality_of_service_from_the_shared_node(desk):
    write_bag(desk.folder / "bag")
    desk.open("bag")
    desk.publish("/number", "/static")
    (number,) = desk.machine.node.get_publishers_info_by_topic("/number")
    (static,) = desk.machine.node.get_publishers_info_by_topic("/static")
    assert number.node_name.startswith("rqt_gui_py_node_")
    assert number.qos_profile.durability == DurabilityPolicy.VOLATILE
    assert static.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL


def test_all_that_was_latched_is_there_after_a_jump_even_for_those_who_come_late(desk):
    write_bag(desk.folder / "bag")
    desk.open("bag")
    desk.jump(7.0)
    desk.publish("/static")
    late = desk.watch(String, "/static", LATCHED)
    desk.machine.advance(0.1)
    assert values(late) == ["first", "second"]


def test_publish_all_and_none(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    model.publish_all(True)
    desk.machine.until(lambda: model.player.publishing == {"/number", "/word", "/static"})
    model.publish_all(False)
    desk.machine.until(lambda: not model.player.publishing)
    assert desk.machine.node.get_publishers_info_by_topic("/number") == []


def test_steps_go_to_the_next_and_the_last_message_of_any_topic_and_around_the_ends(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")

    def step(count):
        model.request(lambda: model.player.step(count))
        desk.arrive()
        return desk.playhead

    assert step(1) == pytest.approx(0.1)
    assert step(1) == pytest.approx(0.2)
    assert step(-1) == pytest.approx(0.1)
    assert step(-1) == 0.0
    assert step(-1) == pytest.approx(9.9)
    assert step(1) == 0.0


def test_rviz_follows_backwards_too_when_both_go_by_the_clock_of_the_bag(desk):
    import rosbag2_py
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage

    from rclpy.serialization import serialize_message

    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(desk.folder / "bag")))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/tf", "tf2_msgs/msg/TFMessage", "cdr", [rosbag2_py.QoS(100)]))
    for number in range(600):
        at = START + number * SECOND // 10
        pose = TransformStamped(child_frame_id="arm")
        pose.header.frame_id, pose.header.stamp.sec = "world", at // SECOND
        pose.header.stamp.nanosec, pose.transform.translation.x = at % SECOND, float(number)
        writer.write("/tf", serialize_message(TFMessage(transforms=[pose])), at)
    writer.close()
    desk.open("--clock", "bag", topics=1)
    desk.machine.start("rviz2", "rviz2", "--ros-args", "-p", "use_sim_time:=true", screen=True)
    desk.machine.until(lambda: len(desk.machine.display.windows) == 2)
    rviz = desk.machine.display.windows[-1].model
    desk.publish("/tf")
    for second in (50, 3, 30, 2.5):
        desk.jump(second)
        desk.machine.advance(0.2)
        found = rviz.frames.buffer.lookup_transform("world", "arm", Time())
        assert found.transform.translation.x == second * 10, second


# -- playing -----------------------------------------------------------------------------------------------------------


def play(desk, speed=1.0):
    desk.model.request(lambda: desk.model.player.set_speed(speed))
    desk.machine.advance()


def play_until(desk, condition):
    desk.machine.until(condition)


def test_playing_publishes_every_message_in_world_time(desk, storage):
    write_bag(desk.folder / "bag", storage)
    desk.open("bag")
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    play(desk)
    play_until(desk, lambda: desk.playhead >= 3.0)
    assert values(numbers)[:30] == [float(number) for number in range(30)]
    held = desk.playhead
    play(desk, 0.0)
    desk.machine.advance(1.0)
    assert desk.playhead == pytest.approx(held, abs=0.1)


def test_playing_goes_around_at_the_end_of_the_region(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    model.request(lambda: model.player.select((START + SECOND, START + 2 * SECOND)))
    desk.jump(1.0)
    numbers.clear()
    play(desk, 4.0)
    play_until(desk, lambda: len(numbers) > 25)
    assert set(values(numbers)) == {float(number) for number in range(10, 21)}
    assert values(numbers)[:12] == [*map(float, range(11, 21)), 10.0, 11.0]


def test_playing_begins_with_the_region_even_if_the_playhead_is_elsewhere(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    model.request(lambda: model.player.select((START + 5 * SECOND, START + 8 * SECOND)))
    for beside in (1.0, 9.0):
        desk.jump(beside)
        play(desk)
        play_until(desk, lambda: 5.0 <= desk.playhead < 6.0)
        play(desk, 0.0)


def test_a_region_that_is_chosen_while_it_plays_counts_at_once(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    play(desk)
    play_until(desk, lambda: desk.playhead > 2.0)
    end = model.player.now() + 1
    model.request(lambda: model.player.select((START, end)))
    desk.arrive()
    seen = max(values(numbers))
    numbers.clear()
    play_until(desk, lambda: len(numbers) > 5)
    assert max(values(numbers)) <= seen + 1


def test_backwards_nothing_is_published(desk):
    write_bag(desk.folder / "bag")
    desk.open("bag")
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    desk.jump(5.0)
    numbers.clear()
    play(desk, -2.0)
    desk.machine.advance(1.0)
    assert desk.playhead == pytest.approx(3.0, abs=0.05) and numbers == []
    desk.machine.advance(2.0)
    play_until(desk, lambda: desk.playhead > 8.0)  # around the beginning


@pytest.mark.parametrize("speed", [1.0, -1.0, 1024.0])
def test_a_region_without_extent_is_not_played_for_ever(desk, speed):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    desk.publish("/number")
    model.request(lambda: model.player.select((START + SECOND, START + SECOND)))
    desk.jump(1.0)
    play(desk, speed)
    desk.machine.until(lambda: model.player.playhead.speed == 0.0)


@pytest.mark.parametrize("exponent", [-10, -3, 1, 5, 10])
def test_at_every_speed_the_world_goes_on(desk, exponent):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    for direction in (1.0, -1.0):
        play(desk, 0.0)
        desk.jump(5.125)
        play(desk, direction * 2.0**exponent)
        for step in (0.000_000_001, 0.000_1, 0.033_333_333, 0.123_456_789):
            desk.machine.advance(step)
            desk.machine.until(lambda: not model.player.arriving)
    assert numbers


def test_with_clock_the_time_of_the_messages_is_published(desk):
    write_bag(desk.folder / "bag")
    desk.open("--clock", "bag")
    clocks = desk.watch(Clock, "/clock", EAR)
    desk.publish("/number")
    desk.jump(3.0)
    assert clocks[-1].clock.sec == START // SECOND + 3
    play(desk)
    play_until(desk, lambda: desk.playhead >= 3.5)
    seconds = [each.clock.sec + each.clock.nanosec / SECOND - START // SECOND for each in clocks]
    assert seconds == sorted(seconds) and pytest.approx(3.4) in seconds


def test_a_pause_of_the_world_holds_the_playhead(desk):
    write_bag(desk.folder / "bag")
    desk.open("bag")
    desk.publish("/number")
    play(desk)
    play_until(desk, lambda: desk.playhead > 1.0)
    held = desk.playhead
    for _ in range(20):
        desk.machine.advance()
    assert desk.playhead == held


@pytest.mark.parametrize("packed", (False, True))
def test_loading_can_be_cancelled_and_shows_what_was_read(desk, monkeypatch, packed):
    from day6_core.ros.programs.rqt_bag.model import bags

    preset = "" if packed else "zstd_fast"
    write_bag(desk.folder / "bag", preset=preset, seconds=2000.0, packed=packed)
    model = desk.open(topics=0)
    seen = []
    loading = bags.index_bag

    def watched(bag, timeline, cancelled):
        def asked():
            seen.append(model.indexed)
            if len(seen) == 2:
                model.cancel()
            return cancelled()

        loading(bag, timeline, asked)

    monkeypatch.setattr(bags, "index_bag", watched)
    model.load("bag")
    desk.machine.until(lambda: model.bags and not model.loading)
    assert model.status == Note("cancelled", "bag")
    assert seen[0] == 0 and seen == sorted(seen) and model.timeline.count("/number") < 20000
    desk.jump(1.0)
    assert desk.playhead == 1.0


# -- what can go wrong -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("word", ["nothing", "empty", "text.txt"])
def test_what_is_no_bag_is_refused_as_rqt_bag_does(desk, word):
    (desk.folder / "empty").mkdir()
    (desk.folder / "text.txt").write_text("hello")
    running = desk.machine.start("rqt_bag", "rqt_bag", word, screen=True)
    assert running.program.status == 2
    assert f"rqt_bag: error: '{word}' is not a valid rosbag" in running.errors


def test_an_empty_bag_says_so(desk):
    write_bag(desk.folder / "bag", seconds=0.0, static=False)
    model = desk.open("bag", topics=0)
    desk.machine.until(lambda: model.bags and not model.loading)
    assert model.status == Note("empty", "bag") and not model.failed


@pytest.mark.parametrize(
    ("damage", "reason"),
    (
        ("metadata", "failed due to: Exception on parsing info file"),
        ("empty", "failed due to: file too small"),
        ("gone", "failed due to: .*No (such file|storage)"),
        ("cut", r"Note\(kind='cut', name='bag'\)"),
    ),
)
def test_a_damaged_bag_is_told_and_the_window_goes_on(desk, damage, reason):
    import re

    bag = write_bag(desk.folder / "bag")
    write_bag(desk.folder / "other")
    file = bag / "bag_0.mcap"
    if damage == "metadata":
        (bag / "metadata.yaml").write_text("rosbag2_bagfile_information: [")
    elif damage == "empty":
        file.write_bytes(b"")
    elif damage == "cut":
        file.write_bytes(file.read_bytes()[:-500])
    else:
        file.unlink()
    model = desk.open("bag", topics=0)
    desk.machine.until(lambda: not model.loading and model.status and model.status != "Loading 'bag' ...")
    assert re.search(reason, str(model.status)) and model.failed == (damage != "cut")
    assert bool(model.topics) == (damage == "cut")
    model.load("other")
    desk.machine.until(lambda: not model.status and not model.loading)
    assert model.timeline.count("/number") >= 100 and len(model.topics) == 3


def test_one_file_of_a_bag_is_opened_without_its_metadata(desk, storage):
    bag = write_bag(desk.folder / "bag", storage)
    (bag / "metadata.yaml").unlink()
    (file,) = bag.iterdir()
    model = desk.open(f"bag/{file.name}")
    assert model.timeline.count("/number") == 100 and not model.failed
    numbers = desk.watch(Float64, "/number")
    desk.publish("/number")
    assert values(numbers) == [0.0]


def test_a_file_that_may_not_be_read_is_told(desk, plain_user):
    bag = write_bag(desk.folder / "bag")
    (bag / "bag_0.mcap").chmod(0)
    model = desk.open("bag", topics=0)
    desk.machine.until(lambda: model.failed)
    assert model.status.startswith("Loading 'bag' failed due to: Permission denied")


def test_a_topic_of_an_unknown_type_is_told_and_the_others_are_published(desk):
    import rosbag2_py

    from rclpy.serialization import serialize_message

    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(desk.folder / "bag")))
    for id_, (name, kind) in enumerate((("/number", "std_msgs/msg/Float64"), ("/odd", "nobody_msgs/msg/Odd"))):
        writer.create_topic(rosbag2_py.TopicMetadata(id_, name, kind, "cdr"))
        writer.write(name, serialize_message(Float64(data=4.0)), START)
    writer.close()
    model = desk.open("bag", topics=2)
    model.publish_all(True)
    desk.machine.until(lambda: model.player.publishing)
    assert model.player.publishing == {"/number"}
    assert "Error creating publisher on topic /odd for type nobody_msgs/msg/Odd." in desk.running.errors
    model.watch("/odd")
    desk.arrive()
    assert "nobody_msgs" in model.shown("/odd").problem


def test_bags_that_disagree_about_a_topic_are_not_shown_together(desk):
    import rosbag2_py

    from rclpy.serialization import serialize_message

    write_bag(desk.folder / "bag")
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(desk.folder / "other")))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/number", "std_msgs/msg/String", "cdr"))
    writer.write("/number", serialize_message(String(data="4")), START)
    writer.close()
    model = desk.open("bag")
    model.load("other")
    desk.machine.until(lambda: model.failed)
    assert "topic /number has multiple datatypes: std_msgs/msg/Float64 and std_msgs/msg/String" in model.status
    assert len(model.bags) == 1


def test_it_is_a_plugin_of_rqt(desk):
    write_bag(desk.folder / "bag")
    desk.machine.start("rqt_gui", "rqt_gui", "--standalone", "rqt_bag", "--args", "bag", screen=True)
    (window,) = desk.machine.display.windows
    assert window.kind == "rqt_bag"
    desk.machine.until(lambda: len(window.model.topics) == 3)
    assert "rqt_bag.bag.Bag" in desk.machine.start("rqt_gui", "rqt_gui").output


def test_closed_within_rqt_it_gives_back_what_it_has_on_the_shared_node(desk):
    from day6_core.ros.programs.rqt_gui.catalogue import plugins

    write_bag(desk.folder / "bag")
    running = desk.machine.start("rqt_gui", "rqt_gui", screen=True)
    (menu,) = desk.machine.display.windows
    menu.model.start(next(each for each in plugins() if each.package == "rqt_bag"))
    desk.machine.until(lambda: len(desk.machine.display.windows) == 2)
    window = desk.machine.display.windows[-1]
    desk.model = window.model
    desk.model.load("bag")
    desk.machine.until(lambda: len(desk.model.topics) == 3)
    desk.publish("/number")
    assert len(desk.machine.node.get_publishers_info_by_topic("/number")) == 1
    window.close_by_user()
    desk.machine.until(lambda: not desk.machine.node.get_publishers_info_by_topic("/number"))
    assert running.program.status is None


def test_without_a_screen_it_prints_what_is_in_the_bag(desk):
    write_bag(desk.folder / "bag")
    running = desk.machine.start("rqt_bag", "rqt_bag", "bag")
    desk.machine.until(lambda: running.program.status is not None)
    assert "Topic: /number | Type: std_msgs/msg/Float64 | Count: 100" in running.output


def test_closing_gives_back_what_it_has_on_the_graph(desk):
    write_bag(desk.folder / "bag")
    desk.open("--clock", "bag")
    desk.publish("/number")
    desk.running.program.session.interrupt()
    desk.machine.advance(0.1)
    assert desk.machine.node.get_publishers_info_by_topic("/number") == []
    assert desk.machine.node.get_publishers_info_by_topic("/clock") == []
