"""Recording from the window, and copying a part of a bag to a new one."""

from __future__ import annotations

import rosbag2_py
from rosbag2_py._info import Info
from std_msgs.msg import Float64

from tests.rqt_bag.bag_desk import SECOND, START, write_bag


def messages(path):
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(path))
    found = []
    while reader.has_next():
        topic, _, time_ns = reader.read_next()
        found.append((topic, time_ns - START))
    reader.close()
    return found


# -- recording ---------------------------------------------------------------------------------------------------------


def recording(desk, name="new", topics=None):
    model = desk.open(topics=0)
    model.record(name, topics)
    desk.machine.until(lambda: model.recorder is not None)
    return model


def test_a_recording_grows_on_the_timeline_and_is_open_when_it_ends(desk):
    publisher = desk.machine.node.create_publisher(Float64, "/number", 10)
    desk.machine.node.create_publisher(Float64, "/other", 10)
    model = recording(desk, topics=["/number"])
    for number in range(30):
        publisher.publish(Float64(data=float(number)))
        desk.machine.advance(0.1)
    assert model.topics == {"/number": "std_msgs/msg/Float64"}
    assert model.recorder.messages == 30 and model.timeline.count("/number") >= 29
    assert "Recording to new." in desk.running.errors
    model.stop_recording()
    desk.machine.until(lambda: model.bags and not model.loading)
    assert model.recorder is None and model.timeline.count("/number") == 30
    assert len(messages(desk.folder / "new")) == 30
    assert desk.machine.node.get_subscriptions_info_by_topic("/number") == []
    assert [name for name, _ in desk.machine.node.get_service_names_and_types() if "pause" in name] == []


def test_all_topics_also_such_that_come_later(desk):
    model = recording(desk)
    publisher = desk.machine.node.create_publisher(Float64, "/late", 10)
    desk.machine.advance(0.3)
    publisher.publish(Float64(data=1.0))
    desk.machine.advance(0.3)
    assert "/late" in model.topics and model.timeline.count("/late") == 1


def test_a_paused_recording_takes_nothing(desk):
    publisher = desk.machine.node.create_publisher(Float64, "/number", 10)
    model = recording(desk, topics=["/number"])
    model.request(model.recorder.toggle_paused)
    desk.machine.advance(0.1)
    publisher.publish(Float64(data=1.0))
    desk.machine.advance(0.1)
    assert model.recorder.paused and model.recorder.messages == 0


def test_an_existing_folder_is_not_overwritten(desk):
    (desk.folder / "there").mkdir()
    (desk.folder / "there" / "precious").write_text("mine")
    model = desk.open(topics=0)
    model.record("there", None)
    desk.machine.until(lambda: model.failed)
    assert model.status.startswith("Error opening bag for recording [there]: Bag directory already exists")
    assert model.recorder is None and [each.name for each in (desk.folder / "there").iterdir()] == ["precious"]


def test_a_full_disk_ends_the_recording_and_is_told(desk, monkeypatch):
    import errno

    from rosbag2_py._mcap_write import McapWriter

    publisher = desk.machine.node.create_publisher(Float64, "/number", 10)
    model = recording(desk, topics=["/number"])
    publisher.publish(Float64(data=1.0))
    desk.machine.advance(0.2)

    def full(self, *words):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(McapWriter, "write", full)
    publisher.publish(Float64(data=2.0))
    desk.machine.until(lambda: model.recorder is None and not model.loading and model.bags)
    assert model.status == "Error writing to bag: No space left on device" and model.failed
    assert model.timeline.count("/number") == 1
    assert desk.running.program.status is None


# -- export ------------------------------------------------------------------------------------------------------------


def test_the_selected_region_of_the_chosen_topics_is_copied(desk, storage):
    write_bag(desk.folder / "bag", storage)
    model = desk.open("bag")
    model.request(lambda: model.player.select((START + SECOND, START + 2 * SECOND)))
    model.export("part", ["/number", "/static"])
    desk.machine.until(lambda: "messages in" in model.status)
    assert model.status == '11 messages in "part"' and not model.failed
    assert messages(desk.folder / "part") == [("/number", tenth * SECOND // 10) for tenth in range(10, 21)]
    text = Info().text(Info().read_metadata(str(desk.folder / "part")))
    assert "Topic: /number | Type: std_msgs/msg/Float64 | Count: 11" in text and "Storage id:        mcap" in text
    model.load("part")
    desk.machine.until(lambda: len(model.bags) == 2 and not model.loading)
    assert model.timeline.count("/number") == 111


def test_everything_is_copied_without_a_region_with_quality_of_service_and_definitions(desk, storage):
    bag = write_bag(desk.folder / "bag", storage)
    model = desk.open("bag")
    model.export("all", list(model.topics))
    desk.machine.until(lambda: "messages in" in model.status)
    assert messages(desk.folder / "all") == messages(bag)
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(desk.folder / "all"))
    qos = {each.name: each.offered_qos_profiles for each in reader.get_all_topics_and_types()}
    assert (
        len(qos["/static"]) == 2 and "string data" in reader.get_all_message_definitions()[1].encoded_message_definition
    )
    reader.close()


def test_nothing_is_overwritten_and_nothing_found_is_told(desk):
    write_bag(desk.folder / "bag")
    model = desk.open("bag")
    before = (desk.folder / "bag" / "metadata.yaml").read_bytes()
    model.export("bag", ["/number"])
    desk.machine.until(lambda: model.failed)
    assert "for writing: Bag directory already exists" in model.status
    assert (desk.folder / "bag" / "metadata.yaml").read_bytes() == before
    model.request(lambda: model.player.select((START + 1, START + 2)))
    model.export("none", ["/number"])
    desk.machine.until(lambda: model.status == "No messages found")
    assert not (desk.folder / "none").exists()


def test_a_full_disk_ends_the_export_and_is_told(desk, monkeypatch):
    import errno

    from rosbag2_py._mcap_write import McapWriter

    write_bag(desk.folder / "bag")
    model = desk.open("bag")

    def full(self, *words):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(McapWriter, "write", full)
    model.export("part", ["/number"])
    desk.machine.until(lambda: model.failed)
    assert model.status.startswith("Error exporting message at position")
    assert model.status.endswith("No space left on device")


def test_a_cancelled_export_leaves_a_whole_bag_with_what_was_copied(desk, monkeypatch):
    write_bag(desk.folder / "bag", seconds=200)
    model = desk.open("bag")
    monkeypatch.setattr(type(model), "_progress", lambda self, percent: self.cancel())
    model.export("part", ["/number"])
    desk.machine.until(lambda: model.status.startswith("Cancelled"))
    count = int(model.status.split()[1])
    assert 0 < count < 2000 and len(messages(desk.folder / "part")) == count
