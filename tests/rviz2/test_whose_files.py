"""Which files a robot or a marker may have read: those of packages, and others only if it is of this machine."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from visualization_msgs.msg import Marker

from day6_core.link.paths import meeting_place
from day6_core.link.remote import Origin
from day6_core.ros.programs.rviz2.model.meshes import MeshData, MeshError, MeshStore

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine

SOLID = (
    "solid\n" + "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" * 2 + "endsolid\n"
)
ROBOT = "<robot name='r'><link name='a'><visual><geometry><mesh filename='{}'/></geometry></visual></link></robot>"


@pytest.fixture
def share(tmp_path: Path) -> Path:
    """The share folder of a package `car`, with a mesh; another one lies outside."""
    folder = tmp_path / "install" / "share" / "car"
    (folder / "meshes").mkdir(parents=True)
    (folder / "package.xml").write_text("<package/>")
    (folder / "meshes" / "in.stl").write_text(SOLID)
    (tmp_path / "out.stl").write_text(SOLID)
    return folder


@pytest.mark.parametrize(
    "uri",
    [
        "package://car/../../../out.stl",
        "package://car/meshes/../../../../out.stl",
        "package://car/%2e%2e/%2e%2e/%2e%2e/out.stl",
        "package://car/..%5c..%5c..%5cout.stl",
        "package://car/meshes/link.stl",
        "package://car/away/out.stl",
    ],
)
def test_nothing_leads_out_of_a_package(share: Path, tmp_path: Path, uri: str) -> None:
    try:
        (share / "meshes" / "link.stl").symlink_to(tmp_path / "out.stl")
        (share / "away").symlink_to(tmp_path, target_is_directory=True)
    except OSError:
        pytest.skip("this system makes no links")
    if not (share / "away").is_symlink():
        pytest.skip("this system hides its links")
    store = MeshStore(lambda package: str(share))
    assert isinstance(store.read("package://car/meshes/in.stl"), MeshData)
    with pytest.raises(MeshError, match="leads out of its package"):
        store.read(uri)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_links_of_a_build_with_symlink_install_are_followed_into_the_sources(share: Path, tmp_path: Path) -> None:
    source = tmp_path / "src" / "car"
    (source / "meshes").mkdir(parents=True)
    for name in ("package.xml", "meshes/in.stl"):
        os.replace(share / name, source / name)
        try:
            (share / name).symlink_to(source / name)
        except OSError:
            pytest.skip("this system makes no links")
    assert isinstance(MeshStore(lambda package: str(share)).read("package://car/meshes/in.stl"), MeshData)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes with names are of POSIX")
def test_a_pipe_is_no_mesh_and_is_not_waited_for(share: Path) -> None:
    os.mkfifo(share / "meshes" / "pipe.stl")
    with pytest.raises(MeshError, match="not a file"):
        MeshStore(lambda package: str(share)).read("package://car/meshes/pipe.stl")


@pytest.mark.parametrize("uri", ["file://{}/out.stl", "{}/out.stl", "//server/share/out.stl", "out.stl"])
def test_what_is_not_of_this_machine_has_packages_only(share: Path, tmp_path: Path, uri: str) -> None:
    store = MeshStore(lambda package: str(share), tmp_path, anywhere=False)
    assert isinstance(store.read("package://car/meshes/in.stl"), MeshData)
    with pytest.raises(MeshError, match="another machine"):
        store.read(uri.format(tmp_path))


def send_as(machine: RVizMachine, origin: Origin | None) -> None:
    """Let what the test's node publishes from now on be of another process."""
    (node,) = [node for node in machine.graph.nodes if node.name == "watcher"]
    node.origin = origin


def test_a_description_of_another_machine_reads_no_file_and_one_of_this_machine_does(
    machine: RVizMachine, tmp_path: Path
) -> None:
    (tmp_path / "out.stl").write_text(SOLID)
    machine.open()
    text = ROBOT.format(f"file://{tmp_path}/out.stl")
    display = machine.robot(text)
    assert display.status("URDF") == ("Ok", "URDF parsed OK")
    for origin, word in ((Origin("beef"), "Error"), (None, "Ok"), (Origin("beef"), "Error")):
        send_as(machine, origin)
        machine.describe(text)
        machine.until(lambda word=word: (display.status("URDF") or ("",))[0] == word)
    assert "Could not load mesh resource" in display.status("URDF")[1]


def test_another_process_of_this_user_is_of_this_machine(machine: RVizMachine, tmp_path: Path) -> None:
    (tmp_path / "out.stl").write_text(SOLID)
    machine.open()
    sign = meeting_place(machine.graph.domain_id).folder / f"p-cafe-{os.getpid()}"
    sign.touch()
    try:
        send_as(machine, Origin("cafe"))
        display = machine.robot(ROBOT.format(f"file://{tmp_path}/out.stl"))
        assert display.status("URDF") == ("Ok", "URDF parsed OK")
    finally:
        sign.unlink()


def test_a_marker_of_another_machine_reads_no_file(machine: RVizMachine, tmp_path: Path) -> None:
    (tmp_path / "out.stl").write_text(SOLID)
    rviz = machine.open()
    machine.transform("map", "a")
    machine.fix("map")
    display = machine.add("Marker", "/shapes")
    marker = Marker(ns="m", type=Marker.MESH_RESOURCE, mesh_resource=f"file://{tmp_path}/out.stl")
    marker.header.frame_id = "map"
    marker.scale.x = marker.scale.y = marker.scale.z = marker.color.a = marker.pose.orientation.w = 1.0
    machine.publish("/shapes", marker)
    machine.until(lambda: rviz.scene.triangles)
    send_as(machine, Origin("beef"))
    machine.publish("/shapes", marker)
    machine.until(lambda: display.status("m/0") is not None)
    assert display.status("m/0")[1] == f"Mesh resource marker [m/0] could not load [{marker.mesh_resource}]"
