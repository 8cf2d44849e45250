"""Recording until nothing fits any more: it is told, and what was on the disk before can be played."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import rosbag2_py

from tests.ros2.bag_commands import counter, wait_for_end

STORAGES = {"mcap": "bag_0.mcap", "sqlite3": "bag_0.db3"}

WRITER = """
import sys
import rosbag2_py
from std_msgs.msg import String
from rclpy.serialization import serialize_message

storage = sys.argv[1]
writer = rosbag2_py.SequentialWriter()
writer.open(rosbag2_py.StorageOptions("bag", storage_id=storage))
writer.create_topic(rosbag2_py.TopicMetadata(0, "/chatter", "std_msgs/msg/String", "cdr", [rosbag2_py.QoS(10)]))
flushed = 0
for number in range(200):
    try:
        writer.write("/chatter", serialize_message(String(data=f"{number} " + "x" * 2000)), number, number)
        writer.flush()
        flushed += 1
    except OSError as error:
        print(error.strerror)
print(flushed)
writer.close()
"""


def messages(bag: Path) -> list[int]:
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(bag))
    found = []
    while reader.has_next():
        found.append(reader.read_next()[2])
    reader.close()
    return found


@pytest.mark.process
@pytest.mark.parametrize("storage", STORAGES)
def test_what_was_flushed_before_the_disk_was_full_is_all_there(tmp_path: Path, storage: str) -> None:
    resource = pytest.importorskip("resource")
    result = subprocess.run(
        [sys.executable, "-m", "day6_tui.main", "python", "-c", WRITER, storage],
        cwd=tmp_path,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "DAY6_LINK": "off"},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000)),
        capture_output=True,
        text=True,
        check=False,
    )
    told = [line for line in result.stderr.splitlines() if "Opened database" not in line]
    assert told == [] and result.returncode == 0
    *problems, flushed = result.stdout.split("\n")[:-1]
    assert 10 < int(flushed) < 60 and len(problems) == 200 - int(flushed) and all(problems)
    assert messages(tmp_path / "bag" / STORAGES[storage]) == list(range(int(flushed)))
    assert messages(tmp_path / "bag") == list(range(int(flushed)))
    assert sorted(path.name for path in (tmp_path / "bag").iterdir()) == sorted(["metadata.yaml", STORAGES[storage]])


@pytest.mark.process
@pytest.mark.parametrize("storage", STORAGES)
def test_a_bag_for_which_there_is_no_room_at_all_leaves_nothing(tmp_path: Path, storage: str) -> None:
    resource = pytest.importorskip("resource")
    result = subprocess.run(
        [sys.executable, "-m", "day6_tui.main", "ros2", "bag", "record", "-a", "-o", "bag", "-s", storage],
        cwd=tmp_path,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "DAY6_LINK": "off", "ROS_LOG_DIR": str(tmp_path / "log")},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20, 20)),
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert result.returncode == 1 and "Recording to 'bag' has ended: " in result.stderr
    assert "Traceback" not in result.stderr
    assert not (tmp_path / "bag").exists()


@pytest.mark.skipif(sys.platform == "win32", reason="nobody can remove an open file there")
def test_a_recording_whose_folder_vanishes_ends_and_says_so(machine, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.setattr("rosbag2_py._writer.FLUSH_SECONDS", 0.0)
    monkeypatch.setattr("rosbag2_py._recording.FLUSH_SECONDS", 0.0)
    machine.node("counter", counter())
    recording = machine.start("bag", "record", "--topics", "/count", "-o", "bag")
    for _ in range(20):
        recording.step(0.05)
    assert (machine.cwd / "bag" / "metadata.yaml").exists() and recording.status is None
    shutil.rmtree(machine.cwd / "bag")
    wait_for_end(recording)
    assert recording.status == 1
    assert "Recording to 'bag' has ended: No such file or directory" in recording.stderr
