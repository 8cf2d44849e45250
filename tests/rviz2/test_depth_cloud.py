"""DepthCloud: depths and their camera become points, a second picture colours them, and what doesn't fit is told."""

from __future__ import annotations

import array
from typing import Any

import numpy as np
import pytest
from sensor_msgs.msg import CameraInfo, Image

from tests.rviz2.rviz_machine import RVizMachine, lines


def picture(pixels: Any, encoding: str, frame: str = "camera") -> Image:
    """An image message of an array."""
    message = Image(height=pixels.shape[0], width=pixels.shape[1], encoding=encoding)
    message.step = pixels.strides[0]
    message.data = array.array("B", pixels.tobytes())
    message.header.frame_id = frame
    return message


def camera(width: int = 2, height: int = 2) -> CameraInfo:
    """A camera with its middle in pixel 0, 0, that sees one metre across in two pixels one metre ahead."""
    message = CameraInfo(width=width, height=height)
    message.k = [2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0]
    message.p = [2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]
    return message


@pytest.fixture
def display(machine: RVizMachine) -> Any:
    machine.open()
    machine.transform("map", "camera", (10.0, 0.0, 0.0))
    display = machine.add("DepthCloud", "/cam/depth")
    machine.publish("/cam/camera_info", camera())
    return display


def points(machine: RVizMachine) -> list[list[float]]:
    return [list(map(float, row)) for shown in machine.rviz.scene.points for row in shown.xyz]


@pytest.mark.parametrize("kind, encoding, unit", [(np.float32, "32FC1", 1), (np.uint16, "16UC1", 1000)])
def test_depths_are_points_before_the_camera(
    machine: RVizMachine, display: Any, kind: Any, encoding: str, unit: int
) -> None:
    nothing = np.nan if kind is np.float32 else 0
    depths = np.array([[1 * unit, 2 * unit], [nothing, 4 * unit]]).astype(kind)
    machine.publish("/cam/depth", picture(depths, encoding))
    assert points(machine) == [[10.0, 0.0, 1.0], [11.0, 0.0, 2.0], [12.0, 2.0, 4.0]]
    assert lines(display)["Depth Image Size"] == ("Ok", "2 x 2")
    assert lines(display)["Depth Map"][1].startswith("1 messages received")
    assert display.size.value == 0.5 and display.size.read_only
    assert (display.how.value, machine.rviz.scene.points[0].colours[0].tolist()) == ("RGB8", [1.0, 1.0, 1.0, 1.0])


def test_a_second_picture_gives_the_colours(machine: RVizMachine, display: Any) -> None:
    machine.rviz.edit(display.colour_topic, "/cam/rgb")
    machine.settle()
    machine.publish("/cam/camera_info", camera())
    depths = picture(np.ones((2, 2), np.float32), "32FC1")
    machine.publish("/cam/depth", depths)
    assert not points(machine)  # it waits for one
    machine.publish("/cam/rgb", picture(np.full((2, 2, 3), (255, 0, 0), np.uint8), "bgr8", "rgb_camera"))
    machine.publish("/cam/depth", depths)
    assert machine.rviz.scene.points[0].colours[0].tolist() == [0.0, 0.0, 1.0, 1.0]
    assert lines(display)["Message"] == (
        "Warn", "Depth image frame id [camera] doesn't match color image frame id [rgb_camera]",
    )  # fmt: skip


@pytest.mark.parametrize(
    "image, told",
    [
        (picture(np.ones((2, 3), np.float32), "32FC1"), "Depth image size and camera info don't match: 3 x 2 vs 2 x 2"),
        (picture(np.ones((2, 2), np.uint8), "mono8"), "Depth image has invalid format (only 16 bit and float are"),
    ],
)
def test_what_does_not_fit_is_told(machine: RVizMachine, display: Any, image: Image, told: str) -> None:
    machine.publish("/cam/depth", image)
    assert lines(display)["Message"][1].startswith(told) and not points(machine)


def test_a_camera_without_calibration_is_told(machine: RVizMachine, display: Any) -> None:
    machine.rviz.edit(display.topic, "/other/depth")
    machine.settle()
    machine.publish("/other/depth", picture(np.ones((2, 2), np.float32), "32FC1"))
    assert lines(display)["Message"] == ("Warn", "No CameraInfo received on [/other/camera_info].")


def test_what_something_nearer_hides_stays_fainter_for_a_while(machine: RVizMachine, display: Any) -> None:
    machine.rviz.edit(display.behind, True)
    machine.rviz.edit(display.timeout, 5.0)
    machine.settle()
    far, near = (picture(np.full((2, 2), depth, np.float32), "32FC1") for depth in (4.0, 1.0))
    machine.publish("/cam/depth", far)
    machine.publish("/cam/depth", near)
    assert sorted({z for _, _, z in points(machine)}) == [1.0, 4.0]
    assert machine.rviz.scene.points[0].colours[-1].tolist() == [0.5, 0.5, 0.5, 1.0]
    machine.advance(6.0)
    machine.publish("/cam/depth", near)
    assert {z for _, _, z in points(machine)} == {1.0}


def test_its_file_has_plain_topics_and_a_compressed_picture_is_told(machine: RVizMachine, display: Any) -> None:
    saved = display.save()
    assert (saved["Depth Map Topic"], saved["Color Image Topic"]) == ("/cam/depth", "")
    assert saved["Auto Size"] == {"Auto Size Factor": 1, "Value": True}
    display.load({**saved, "Depth Map Transport Hint": "compressedDepth", "Reliability Policy": "Reliable"})
    machine.settle()
    assert "image_transport/compressedDepth_sub" in lines(display)["Message"][1]
    assert display.save()["Depth Map Transport Hint"] == "compressedDepth"
