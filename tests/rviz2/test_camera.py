"""Camera: where its calibration is looked for, what it says without one, and the scene drawn into its picture."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from sensor_msgs.msg import CameraInfo, Image
from visualization_msgs.msg import Marker

from day6_core.ros.programs.rviz2.model.views import Camera
from day6_tui.render.painter import QUALITIES, paint
from tests.rviz2.rviz_machine import RVizMachine, lines

WIDTH, HEIGHT, FOCAL = 64, 48, 40.0


def photo(frame: str = "optical") -> Image:
    """All blue."""
    message = Image(width=WIDTH, height=HEIGHT, encoding="rgb8", step=WIDTH * 3)
    message.header.frame_id = frame
    message.data = bytes((0, 0, 255)) * (WIDTH * HEIGHT)
    return message


def calibration(**fields: Any) -> CameraInfo:
    info = CameraInfo(width=WIDTH, height=HEIGHT, **fields)
    info.p = [FOCAL, 0.0, WIDTH / 2, 0.0, 0.0, FOCAL, HEIGHT / 2, 0.0, 0.0, 0.0, 1.0, 0.0]
    return info


def cube(x: float, y: float, z: float) -> Marker:
    marker = Marker(type=Marker.CUBE)
    marker.header.frame_id = "optical"
    marker.pose.position.x, marker.pose.position.y, marker.pose.position.z = x, y, z
    marker.pose.orientation.w = 1.0
    marker.scale.x = marker.scale.y = marker.scale.z = 0.2
    marker.color.r = marker.color.a = 1.0
    return marker


@pytest.fixture
def camera(machine: RVizMachine) -> Any:
    machine.open()
    machine.fix("map")
    machine.transform("map", "optical", (5.0, 0.0, 0.0))
    machine.add("Marker", "/cube")
    return machine.add("Camera", "/eye/image_raw")


def shown(machine: RVizMachine) -> Any:
    """The camera's picture in the lower right corner of the view, which looks elsewhere: rows x columns x 3."""
    away = Camera((0.0, 0.0, 100.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    picture = paint(machine.rviz.scene, away, 200, 150, 1.0, QUALITIES["High"])
    down, across = int(150 * 0.45), int(200 * 0.45)
    return picture.colour[-down:, -across:]


def test_without_calibration_nothing_is_shown_and_the_status_says_where_it_is_expected(
    machine: RVizMachine, camera: Any
) -> None:
    text = "No CameraInfo received on [/eye/camera_info]. Topic may not exist."
    assert lines(camera)["Camera Info"] == ("Warn", text)
    machine.publish("/eye/image_raw", photo())
    text = "Expecting Camera Info on topic [/eye/camera_info]. No CameraInfo received. Topic may not exist."
    assert lines(camera)["Camera Info"] == ("Warn", text)
    assert not machine.rviz.scene.overlays


def test_the_scene_is_drawn_where_the_camera_sees_it(machine: RVizMachine, camera: Any) -> None:
    machine.publish("/cube", cube(0.5, 0.0, 2.0))
    machine.publish("/eye/camera_info", calibration())
    machine.publish("/eye/image_raw", photo())
    assert {name: line for name, line in lines(camera).items() if name != "Topic"} == {
        "Camera Info": ("Ok", "ok"),
        "Time": ("Ok", "ok"),
        "Transform": ("Ok", "Ok"),
    }
    machine.rviz.edit(camera.alpha, 0.0)
    machine.settle()
    picture = shown(machine)
    assert np.allclose(picture[2, 2], (0.0, 0.0, 1.0))
    y, x = np.nonzero(picture[..., 0] > 0.2)
    # 0.5 m to the right at 2 m: 10 of 64 pixels right of the middle.
    assert x.mean() / picture.shape[1] == pytest.approx(0.5 + FOCAL * 0.5 / 2 / WIDTH, abs=0.03)
    assert y.mean() / picture.shape[0] == pytest.approx(0.5, abs=0.03)
    machine.rviz.edit(camera.far, 1.0)
    machine.settle()
    assert not (shown(machine)[..., 0] > 0.2).any()


def test_a_display_that_is_not_visible_to_the_camera_is_not_drawn_and_saved_so(
    machine: RVizMachine, camera: Any
) -> None:
    machine.publish("/cube", cube(0.0, 0.0, 2.0))
    machine.publish("/eye/camera_info", calibration())
    machine.publish("/eye/image_raw", photo())
    machine.rviz.edit(camera.alpha, 0.0)
    machine.settle()
    assert (shown(machine)[..., 0] > 0.2).any()
    machine.rviz.edit(camera.child("Visibility", "Marker"), False)
    machine.settle()
    assert not (shown(machine)[..., 0] > 0.2).any()
    saved = camera.save()
    assert saved["Visibility"]["Marker"] is False and saved["Visibility"]["Value"] is True
    copy = machine.do(lambda: machine.rviz.duplicate_display(camera))
    assert copy.child("Visibility", "Marker").value is False


def test_a_calibration_that_is_none_is_told(machine: RVizMachine, camera: Any) -> None:
    machine.publish("/eye/image_raw", photo())
    info = calibration()
    info.d = [math.nan]
    machine.publish("/eye/camera_info", info)
    text = "Contains invalid floating point values (nans or infs)"
    assert lines(camera)["Camera Info"] == ("Error", text)
    machine.publish("/eye/camera_info", CameraInfo(width=WIDTH, height=HEIGHT))
    text = "CameraInfo/P resulted in an invalid position calculation (nans or infs)"
    assert lines(camera)["Camera Info"] == ("Error", text)
    assert not machine.rviz.scene.overlays


def test_a_calibration_is_a_pyramid_from_its_camera(machine: RVizMachine, camera: Any) -> None:
    display = machine.add("CameraInfo", "/eye/camera_info")
    info = calibration()
    info.header.frame_id = "optical"
    machine.publish("/eye/camera_info", info)
    edges = machine.rviz.scene.lines[-1]
    assert edges.pose.xyz == (5.0, 0.0, 0.0)
    assert (-WIDTH / 2 / FOCAL, -HEIGHT / 2 / FOCAL, 1.0) in edges.vertices and len(edges.vertices) == 16
    assert not machine.rviz.scene.triangles
    machine.rviz.edit(display.child("Not show side polygons"), False)
    machine.rviz.edit(display.child("Far clip"), 2.0)
    machine.settle()
    assert machine.rviz.scene.triangles[-1].vertices.max() == 2.0
    info.p = [0.0] * 12
    machine.publish("/eye/camera_info", info)
    assert lines(display)["Camera Info"] == ("Error", "Invalid intrinsic matrix")
    assert not machine.rviz.scene.triangles
