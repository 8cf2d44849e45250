"""Packages that day6-tui does without: what needs them says so in one sentence, and everything else goes on."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import rosbag2_py
from rosbag2_py._compression import MissingCodec
from rosbag2_py._metadata import MetadataIo
from sensor_msgs.msg import CompressedImage
from std_msgs.msg import String

from day6_core.graph import Graph
from day6_core.parts import PROJECTS, MissingPart, has_part, part
from day6_core.ros.programs import load
from day6_core.ros.programs.rqt_graph.model.image import write_image
from day6_core.ros.programs.rqt_graph.model.shapes import LaidOutGraph
from day6_core.ros.programs.rqt_image_view.decoding import ImageRequest, Undecodable, picture_of
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured
from day6_tui.upkeep import checks, trials
from rclpy.serialization import serialize_message

WITHOUT = "needs? {0}, which isn't installed: pip install {0}$"


@pytest.fixture
def without(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Take a package away, as if it weren't installed."""

    def take(package: str) -> None:
        for name in [name for name in sys.modules if name == package or name.startswith(f"{package}.")]:
            monkeypatch.delitem(sys.modules, name)
        monkeypatch.setitem(sys.modules, package, None)

    return take


def bag(folder: Path, mode: str = "NONE", preset: str = "") -> rosbag2_py.SequentialCompressionWriter:
    """A bag that is open for writing."""
    compression = rosbag2_py.CompressionOptions("zstd", rosbag2_py.compression_mode_from_string(mode))
    writer = rosbag2_py.SequentialCompressionWriter(compression)
    writer.open(rosbag2_py.StorageOptions(str(folder), storage_id="mcap", storage_preset_profile=preset))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/chatter", "std_msgs/msg/String", "cdr"))
    return writer


def texts(folder: Path) -> int:
    """Read a bag; return how many messages it has."""
    reader = rosbag2_py.SequentialCompressionReader()
    reader.open(rosbag2_py.StorageOptions(str(folder)), rosbag2_py.ConverterOptions("", ""))
    count = 0
    while reader.has_next():
        reader.read_next()
        count += 1
    return count


WAYS = [("FILE", ""), ("MESSAGE", ""), ("NONE", "zstd_fast")]


@pytest.mark.parametrize("package", sorted(PROJECTS))
def test_a_package_is_there_or_its_project_is_named(without: Callable[[str], None], package: str) -> None:
    assert has_part(package) and part(package, "a test needs").__name__ == package
    without(package)
    assert not has_part(package)
    with pytest.raises(MissingPart, match=WITHOUT.format(PROJECTS[package])):
        part(package, "a test needs")


def test_what_is_wrong_inside_of_a_package_is_no_missing_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, without: Callable[[str], None]
) -> None:
    without("reportlab")
    monkeypatch.delitem(sys.modules, "reportlab")
    (tmp_path / "reportlab.py").write_text("import no_such_package_of_anybody", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ModuleNotFoundError, match="no_such_package_of_anybody"):
        part("reportlab", "a test needs")


def test_bags_are_recorded_and_read_without_any_compression(tmp_path: Path, without: Callable[[str], None]) -> None:
    without("zstandard")
    without("lz4")
    writer = bag(tmp_path / "bag")
    writer.write("/chatter", serialize_message(String(data="hi")), 5)
    writer.close()
    assert texts(tmp_path / "bag") == 1


@pytest.mark.parametrize(("mode", "preset"), WAYS)
def test_a_compressed_bag_is_refused_before_anything_is_recorded(
    tmp_path: Path, without: Callable[[str], None], mode: str, preset: str
) -> None:
    without("zstandard")
    with pytest.raises(MissingCodec, match="compressed bags " + WITHOUT.format("zstandard")):
        bag(tmp_path / "bag", mode, preset)
    assert not (tmp_path / "bag").exists()


@pytest.mark.parametrize(("mode", "preset"), WAYS)
def test_a_compressed_bag_tells_what_it_has_but_cannot_be_read(
    tmp_path: Path, without: Callable[[str], None], mode: str, preset: str
) -> None:
    writer = bag(tmp_path / "bag", mode, preset)
    writer.write("/chatter", serialize_message(String(data="hi")), 5)
    writer.close()
    without("zstandard")
    assert MetadataIo().read_metadata(str(tmp_path / "bag")).message_count == 1
    with pytest.raises(MissingCodec, match="compressed bags " + WITHOUT.format("zstandard")):
        texts(tmp_path / "bag")


@pytest.mark.parametrize(
    ("suffix", "package"), [(".pdf", "reportlab"), (".png", "PIL"), (".jpg", "PIL"), (".svg", ""), (".dot", "")]
)
def test_a_drawing_that_cannot_be_made_leaves_no_file(
    tmp_path: Path, without: Callable[[str], None], suffix: str, package: str
) -> None:
    for each in ("reportlab", "PIL"):
        without(each)
    target, graph = tmp_path / f"graph{suffix}", LaidOutGraph(4, 4, {}, ())
    if package:
        with pytest.raises(MissingPart, match=WITHOUT.format(PROJECTS[package])):
            write_image(graph, target)
    elif suffix == ".svg":
        write_image(graph, target)
    assert target.exists() == (suffix == ".svg")


def test_a_pdf_of_a_robot_says_what_it_needs(tmp_path: Path, without: Callable[[str], None]) -> None:
    without("reportlab")
    (tmp_path / "car.urdf").write_text('<robot name="car"><link name="base"/></robot>', encoding="utf-8")
    scheduler, stderr = Scheduler(WorldClock()), Captured()
    session = Session(
        scheduler,
        Graph(),
        ["urdf_to_graphviz", "car.urdf"],
        env={"PATH": ""},
        cwd=tmp_path,
        stdout=stderr,
        stderr=stderr,
    )
    program = Program(session, load("urdfdom", "urdf_to_graphviz"))
    assert scheduler.run(lambda: program.status is not None, timeout=10.0)
    assert program.status and stderr.text.endswith(
        "for writing : PDF files need reportlab, which isn't installed: pip install reportlab\n"
    )


def test_a_compressed_image_says_what_it_needs(without: Callable[[str], None]) -> None:
    without("PIL")
    with pytest.raises(Undecodable, match="compressed images " + WITHOUT.format("pillow")):
        picture_of(CompressedImage(format="jpeg", data=b"\xff\xd8"), ImageRequest(10, 10))


def test_the_doctor_says_what_is_left_out_and_calls_nothing_broken(
    monkeypatch: pytest.MonkeyPatch, without: Callable[[str], None]
) -> None:
    for package in PROJECTS:
        without(package)
    gone = [trials.Requirement(name, ">=1", None, False) for name in ("pillow", "eclipse-zenoh", "zstandard")]
    asked: list[str] = []
    monkeypatch.setattr(trials, "requirements", lambda: [*gone, trials.Requirement("numpy", ">=1", "2.0", True)])
    monkeypatch.setattr(trials, "failing_imports", lambda modules: asked.extend(modules) or {})
    lines = list(checks.packages())
    assert [line.key for line in lines if line.level == "note"] == [f"packages.part.{each.name}" for each in gone]
    assert not [line for line in lines if line.level == "problem"]
    assert not set(asked) & set(PROJECTS) and {"numpy", "textual"} < set(asked)
