"""PointCloud2 and Image: what arrives, how it is coloured, what the status says, and that much of it stays quick."""

from __future__ import annotations

import array
from time import thread_time  # by name: what RViz asks of it is stepped
from typing import Any

import numpy as np
import pytest
from geometry_msgs.msg import Point32
from sensor_msgs.msg import ChannelFloat32, Image, PointCloud, PointCloud2, PointField

from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import MOST_DRAWN, rainbow
from tests.rviz2.rviz_machine import RVizMachine, lines

KINDS = {"<f4": 7, "<u4": 6, "<f8": 8, "<u2": 4, "<i4": 5}


def cloud(points: Any, frame: str = "map") -> PointCloud2:
    """A message of a structured array."""
    message = PointCloud2(height=1, width=len(points), point_step=points.dtype.itemsize)
    message.row_step = message.width * message.point_step
    message.header.frame_id = frame
    for name in points.dtype.names:
        kind, offset = points.dtype.fields[name][:2]
        message.fields.append(PointField(name=name, offset=offset, datatype=KINDS[kind.str], count=1))
    message.data = array.array("B", points.tobytes())
    return message


def made(*rows: tuple[float, ...], **more: Any) -> Any:
    """Points of x, y, z and more fields: `rgb=("<u4", [...])`."""
    points = np.zeros(
        len(rows), [*((name, "<f4") for name in "xyz"), *((name, kind) for name, (kind, _) in more.items())]
    )
    for index, name in enumerate("xyz"):
        points[name] = [row[index] for row in rows]
    for name, (_, values) in more.items():
        points[name] = values
    return points


@pytest.fixture
def display(machine: RVizMachine) -> Any:
    machine.open()
    machine.transform("map", "camera", (1.0, 0.0, 0.0))
    return machine.add("PointCloud2", "/points")


def colours(machine: RVizMachine) -> list[list[float]]:
    return [[round(float(part), 3) for part in colour] for colour in machine.rviz.scene.points[0].colours]


def test_a_cloud_is_shown_where_its_frame_is_without_what_is_not_finite(machine: RVizMachine, display: Any) -> None:
    machine.publish("/points", cloud(made((0, 0, 1), (float("nan"), 0, 0), (2, 0, 0)), "camera"))
    assert machine.rviz.scene.points[0].xyz.tolist() == [[1.0, 0.0, 1.0], [3.0, 0.0, 0.0]]
    assert lines(display)["Points"] == ("Ok", "Showing [2] points from [1] messages")
    assert (display.position.value, display.how.value) == ("XYZ", "Intensity")
    # Without a channel of that name nothing has a colour of its own.
    assert colours(machine) == [[1.0, 1.0, 1.0, 1.0]]


def test_packed_colours_win_and_go_with_the_next_cloud_that_has_none(machine: RVizMachine, display: Any) -> None:
    machine.publish("/points", cloud(made((0, 0, 0), (1, 0, 0), rgb=("<u4", [0xFF8000, 0x0000FF]))))
    assert display.how.value == "RGB8" and "RGB8" in display.how.options
    assert colours(machine) == [[1.0, 0.502, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]]
    as_float = np.array([0x00FF00], np.uint32).view(np.float32)
    machine.publish("/points", cloud(made((0, 0, 0), rgb=("<f4", as_float))))
    assert colours(machine) == [[0.0, 1.0, 0.0, 1.0]]
    machine.publish("/points", cloud(made((0, 0, 0), intensity=("<f4", [3.0]))))
    assert display.how.value == "Intensity" and "RGB8" not in display.how.options


def test_intensities_and_heights_run_through_the_rainbow_from_red_to_violet(machine: RVizMachine, display: Any) -> None:
    machine.publish("/points", cloud(made((0, 0, 0), (1, 0, 5), intensity=("<f4", [10.0, 30.0]))))
    red, violet = [1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 1.0, 1.0]
    assert colours(machine) == [red, violet]
    assert (display.least.value, display.most.value) == (10.0, 30.0)
    machine.rviz.edit(display.rainbow, False)
    machine.settle()
    assert colours(machine) == [[0.0, 0.0, 0.0, 1.0], [1.0, 1.0, 1.0, 1.0]]
    machine.rviz.edit(display.how, "AxisColor")
    machine.settle()
    assert colours(machine) == [red, violet]
    assert (display.axis_least.value, display.axis_most.value) == (0.0, 5.0)
    machine.rviz.edit(display.how, "FlatColor")
    machine.rviz.edit(display.colour, (0, 255, 0))
    machine.settle()
    assert colours(machine) == [[0.0, 1.0, 0.0, 1.0]]


def test_the_rainbow_is_that_of_rviz() -> None:
    found = rainbow(np.array([-1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 9.0]), 1.0)[:, :3]
    # point_cloud_helpers: magenta, blue, cyan, green, yellow, red; in 32 steps here.
    expected = [[1, 0, 1], [1, 0, 1], [0, 0, 1], [0, 1, 1], [0, 1, 0], [1, 1, 0], [1, 0, 0], [1, 0, 0]]
    assert np.abs(found - np.array(expected)).max() < 0.1


def test_a_cloud_that_is_no_cloud_is_told_or_left_alone(machine: RVizMachine, display: Any) -> None:
    short = cloud(made((0, 0, 0)))
    short.width = 2
    machine.publish("/points", short)
    text = "Data size (12 bytes) does not match width (2) times height (1) times point_step (12).  Dropping message."
    assert lines(display)["Message"] == ("Error", text)
    wide = np.zeros(1, [(name, "<f8") for name in "xyz"])
    machine.publish("/points", cloud(wide))
    assert lines(display)["Message"] == ("Error", "No position transformer available for cloud")
    beyond = cloud(made((0, 0, 0)))
    beyond.fields[2].offset = 10
    machine.publish("/points", beyond)
    assert lines(display)["Message"] == ("Error", "PointCloud contained not enough or too much data")
    machine.publish("/points", cloud(np.zeros(1, [("x", "<f4"), ("y", "<f4")])))
    machine.publish("/points", cloud(made((1, 1, 1))))
    assert "Message" not in lines(display) and len(machine.rviz.scene.points) == 1
    machine.publish("/points", cloud(made()))
    assert lines(display)["Points"] == ("Ok", "Showing [0] points from [1] messages")


def test_a_big_endian_cloud_means_the_same(machine: RVizMachine, display: Any) -> None:
    message = cloud(made((1, 2, 3)))
    message.data = array.array("B", made((1, 2, 3)).astype([(name, ">f4") for name in "xyz"]).tobytes())
    message.is_bigendian = True
    machine.publish("/points", message)
    assert machine.rviz.scene.points[0].xyz.tolist() == [[1.0, 2.0, 3.0]]


def test_an_old_cloud_is_shown_by_its_channels(machine: RVizMachine) -> None:
    machine.open()
    machine.transform("map", "camera", (1.0, 0.0, 0.0))
    display = machine.add("PointCloud", "/old")
    message = PointCloud(points=[Point32(z=1.0), Point32(x=float("nan")), Point32(x=2.0)])
    message.header.frame_id = "camera"
    short = ChannelFloat32(name="short", values=[1.0])
    message.channels = [ChannelFloat32(name="intensity", values=[10.0, 20.0, 30.0]), short]
    machine.publish("/old", message)
    assert machine.rviz.scene.points[0].xyz.tolist() == [[1.0, 0.0, 1.0], [3.0, 0.0, 0.0]]
    assert colours(machine) == [[1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 1.0, 1.0]]
    assert (display.least.value, display.most.value) == (10.0, 30.0)
    machine.rviz.edit(display.channel, "short")
    machine.settle()
    assert display.most.value == 0.0
    packed = np.array([0x00FF00] * 3, np.uint32).view(np.float32)
    message.channels = [ChannelFloat32(name="rgb", values=packed.tolist())]
    machine.publish("/old", message)
    machine.rviz.edit(display.how, "RGB8")
    machine.settle()
    assert colours(machine) == [[0.0, 1.0, 0.0, 1.0]] * 2


@pytest.mark.parametrize("count", [640 * 480, 2_000_000])
def test_a_large_cloud_is_thinned_and_the_panel_says_so(machine: RVizMachine, display: Any, count: int) -> None:
    points = np.zeros(count, [*((name, "<f4") for name in "xyz"), ("rgb", "<u4")])
    message = cloud(points)
    began = thread_time()
    display.show(message)
    machine.rviz.touch()
    machine.settle()
    assert thread_time() - began < 1.0
    drawn = len(machine.rviz.scene.points[0].xyz)
    assert lines(display)["Points"][1] == f"Showing [{drawn}] of [{count}] points from [1] messages"
    assert MOST_DRAWN / 2 < drawn <= MOST_DRAWN


def test_a_saved_cloud_has_rvizs_names(machine: RVizMachine, display: Any) -> None:
    saved = display.save()
    assert saved["Class"] == "rviz_default_plugins/PointCloud2"
    assert saved["Autocompute Value Bounds"] == {"Max Value": 10, "Min Value": -10, "Value": True}
    assert {"Color Transformer", "Position Transformer", "Use Fixed Frame", "Use rainbow", "Size (m)"} <= saved.keys()
    assert saved["Color Transformer"] == ""
    display.load({**saved, "Color Transformer": "RGB8", "Size (m)": 0.05})
    assert (display.how.value, display.size.value) == ("RGB8", 0.05)


# -- images ------------------------------------------------------------------------------------------------------------


def image(encoding: str, pixels: Any, step: int = 0) -> Image:
    rows = np.asarray(pixels)
    flat = rows.reshape(rows.shape[0], -1)
    message = Image(height=rows.shape[0], width=rows.shape[1], encoding=encoding)
    message.step = step or flat.shape[1] * rows.dtype.itemsize
    padded = [row.tobytes().ljust(message.step, b"\0") for row in flat]
    message.data = array.array("B", b"".join(padded))
    return message


@pytest.mark.parametrize(
    ("encoding", "pixels", "shown"),
    [
        ("rgb8", [[[1, 2, 3], [4, 5, 6]]], [[1, 2, 3], [4, 5, 6]]),
        ("bgr8", [[[1, 2, 3]]], [[3, 2, 1]]),
        ("rgba8", [[[1, 2, 3, 9]]], [[1, 2, 3]]),
        ("bgra8", [[[1, 2, 3, 9]]], [[3, 2, 1]]),
        ("8UC3", [[[1, 2, 3]]], [[3, 2, 1]]),
        ("mono8", [[7, 8]], [[7, 7, 7], [8, 8, 8]]),
        ("bayer_rggb8", [[7, 8]], [[7, 7, 7], [8, 8, 8]]),
        ("yuyv", [[[100, 128], [200, 128]]], [[100, 100, 100], [200, 200, 200]]),
        ("uyvy", [[[128, 100], [228, 200]]], [[240, 29, 100], [255, 129, 200]]),
    ],
)
def test_images_of_bytes(machine: RVizMachine, encoding: str, pixels: Any, shown: Any) -> None:
    machine.open()
    display = machine.add("Image", "/image")
    machine.publish("/image", image(encoding, np.array(pixels, np.uint8)))
    (overlay,) = machine.rviz.scene.overlays
    assert overlay.pixels[0].tolist() == shown
    assert display.normalize.hidden and "Image" not in lines(display)


def test_distances_are_stretched_from_black_to_white_or_as_the_user_says(machine: RVizMachine) -> None:
    machine.open()
    display = machine.add("Image", "/depth")
    machine.publish("/depth", image("32FC1", np.array([[1.0, 2.0, 3.0, np.nan]], np.float32)))
    assert machine.rviz.scene.overlays[0].pixels[0, :, 0].tolist() == [0, 127, 255, 0]
    assert not display.normalize.hidden and display.least.hidden
    machine.rviz.edit(display.normalize, False)
    machine.rviz.edit(display.most, 4.0)
    machine.settle()
    assert machine.rviz.scene.overlays[0].pixels[0, :, 0].tolist() == [63, 127, 191, 0]
    machine.publish("/depth", image("16UC1", np.array([[0, 4]], np.uint16), step=16))
    assert machine.rviz.scene.overlays[0].pixels[0, :, 0].tolist() == [0, 255]


def test_an_unknown_encoding_is_told_and_too_few_bytes_leave_the_last_image(machine: RVizMachine) -> None:
    machine.open()
    display = machine.add("Image", "/image")
    machine.publish("/image", image("rgb8", np.full((2, 2, 3), 9, np.uint8)))
    machine.publish("/image", image("jpeg2000", np.zeros((1, 1), np.uint8)))
    assert lines(display)["Image"] == ("Error", "Unsupported image encoding [jpeg2000]")
    short = image("rgb8", np.zeros((2, 2, 3), np.uint8))
    short.data = short.data[:5]
    machine.publish("/image", short)
    assert machine.rviz.scene.overlays[0].pixels.max() == 9
    machine.publish("/image", image("mono8", np.zeros((2000, 1000), np.uint8)))
    assert "Image" not in lines(display)
    assert max(machine.rviz.scene.overlays[0].pixels.shape) <= 640


def test_an_image_lies_in_the_corner_of_the_view_in_its_own_shape(machine: RVizMachine) -> None:
    from day6_tui.render.painter import QUALITIES, paint

    rviz = machine.open()
    display = machine.add("Image", "/image")
    pixels = np.zeros((10, 20, 3), np.uint8)
    pixels[:, :10] = (255, 0, 0)
    pixels[:, 10:] = (0, 0, 255)
    machine.publish("/image", image("rgb8", pixels))
    picture = paint(rviz.scene, rviz.view.camera(), 80, 60, 1.0, QUALITIES["High"])
    assert picture.colour[59, 79].tolist() == [0.0, 0.0, 1.0] and picture.colour[42, 44].tolist() == [1.0, 0.0, 0.0]
    assert picture.colour[41, 44].tolist() != [1.0, 0.0, 0.0] and picture.colour[42, 43].tolist() != [1.0, 0.0, 0.0]
    assert [label.words for label in picture.labels][-1] == "Image"
    assert display.picture_size == "20x10"
