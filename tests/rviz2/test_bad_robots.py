"""Robots and meshes that would stop a careless program: a word about each, no hang, bounded memory."""

from __future__ import annotations

import sys
from pathlib import Path
from time import thread_time  # by name: what RViz asks of it is stepped
from typing import TYPE_CHECKING

import numpy as np
import pytest

from day6_core.ros.programs.rviz2.model.meshes import (
    MOST_TRIANGLES,
    Cancelled,
    MeshData,
    MeshStore,
    read_dae,
    read_obj,
    read_stl,
)
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine


def quiet(part: float) -> None:
    """Progress nobody looks at."""


def peak_kilobytes() -> int:
    """The most memory this process ever had, 0 where that is not told."""
    if sys.platform != "linux":
        return 0
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def write_stl(path: Path, count: int) -> None:
    """A binary STL of a wavy sheet of `count` triangles."""
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    side = int((count / 2) ** 0.5) + 1
    with path.open("wb") as file:
        file.write(b"\0" * 80 + count.to_bytes(4, "little"))
        for start in range(0, count, 100_000):
            number = np.arange(start, min(count, start + 100_000))
            x, y, odd = number // 2 % side, number // 2 // side, number % 2
            part = np.zeros(len(number), record)
            for corner, (dx, dy) in enumerate(((0, 0), (1, 0), (1, 1))):
                px, py = x + np.where(odd == 1, dy, dx), y + np.where(odd == 1, dx, dy)
                part["corners"][:, corner] = np.stack([px / side, py / side, np.sin(px / side * 9) / 10], axis=1)
            file.write(part.tobytes())


@pytest.mark.long
def test_a_mesh_of_two_million_triangles_is_made_coarser(tmp_path: Path) -> None:
    file = tmp_path / "huge.stl"
    write_stl(file, 2_000_000)
    seen: list[float] = []
    before = peak_kilobytes()
    mesh = read_stl(file, seen.append)
    assert 1000 < len(mesh.faces) <= 2 * MOST_TRIANGLES
    assert mesh.vertices.min(axis=0)[:2] == pytest.approx([0, 0], abs=0.02)
    assert mesh.vertices.max(axis=0)[:2] == pytest.approx([1, 1], abs=0.02)
    assert len(seen) > 10 and max(seen) == 1.0
    if before:
        assert peak_kilobytes() - before < 150_000  # the file itself has 100 MB


def test_reading_stops_when_nobody_wants_the_mesh_any_more(tmp_path: Path) -> None:
    file = tmp_path / "huge.stl"
    write_stl(file, 1_000_000)
    looks: list[int] = []

    def cancelled() -> bool:
        looks.append(1)
        return len(looks) > 3

    with pytest.raises(Cancelled):
        MeshStore(str, cancelled=cancelled).read(f"file://{file}")
    assert len(looks) == 4


@pytest.mark.long
def test_the_window_goes_on_while_a_large_mesh_is_read(machine: RVizMachine, tmp_path: Path) -> None:
    file = tmp_path / "huge.stl"
    write_stl(file, 1_000_000)
    rviz = machine.open()
    display = machine.add("RobotModel", "/robot_description")
    machine.describe(
        f"<robot name='r'><link name='a'><visual><geometry><mesh filename='file://{file}'/></geometry></visual></link></robot>"
    )
    steps, told = [], set()

    def step() -> None:
        began = thread_time()
        machine.advance(0.01)
        steps.append(thread_time() - began)
        told.add(rviz.progress)

    until(lambda: display.status("URDF"), 60, meanwhile=step)
    assert max(steps) < 0.5
    assert any("huge.stl" in text for text in told)
    machine.settle()
    assert display.status("URDF") == ("Ok", "URDF parsed OK")
    assert rviz.scene.triangles and rviz.progress == ""


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"solid x\nendsolid x\n",
        b"\0" * 80 + (10**9).to_bytes(4, "little") + b"\0" * 50,
        b"\0" * 80 + (1).to_bytes(4, "little") + np.full(12, np.nan, "<f4").tobytes() + b"\0\0",
        b"not a mesh at all",
    ],
)
def test_broken_stl_files(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "broken.stl"
    file.write_bytes(content)
    with pytest.raises(ValueError):
        read_stl(file, quiet)


@pytest.mark.parametrize("content", ["", "v 0 0 0\nf 1 2 3\n", "v a b c\n", "v 0 0 0\nf 1/1/1 x 3", "f 1 1 1"])
def test_broken_obj_files(tmp_path: Path, content: str) -> None:
    file = tmp_path / "broken.obj"
    file.write_text(content)
    with pytest.raises(ValueError):
        read_obj(file, quiet)


BOMB = "<!DOCTYPE x [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;'>]><COLLADA>&b;</COLLADA>"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_a_collada_file_defines_no_entities(tmp_path: Path, encoding: str) -> None:
    file = tmp_path / "bomb.dae"
    file.write_text(BOMB, encoding=encoding)
    with pytest.raises(ValueError, match=r"^bomb\.dae: a document type is not allowed$"):
        read_dae(file, quiet)


@pytest.mark.parametrize("content", ["", "<COLLADA/>", "<COLLADA><library_geometries/></COLLADA>", "<a><b></a>"])
def test_broken_collada_files(tmp_path: Path, content: str) -> None:
    file = tmp_path / "broken.dae"
    file.write_text(content)
    with pytest.raises(ValueError):
        read_dae(file, quiet)


SQUARE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.01"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>1 0.5 0 1</color></diffuse>
</lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="12">0 0 0 100 0 0 100 100 0 0 100 0
</float_array><technique_common><accessor source="#pa" count="4" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1" material="s"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><translate>0 0 50</translate><instance_geometry url="#g"><bind_material>
<technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


def test_collada_with_units_nodes_and_colours(tmp_path: Path) -> None:
    file = tmp_path / "square.dae"
    file.write_text(SQUARE)
    mesh = read_dae(file, quiet)
    assert len(mesh.faces) == 2
    corners = {tuple(np.round(vertex, 6).tolist()) for vertex in mesh.vertices}
    assert corners == {
        (0.0, 0.0, 0.5),
        (1.0, 0.0, 0.5),
        (1.0, 1.0, 0.5),
        (0.0, 1.0, 0.5),
    }  # the up axis is ignored, as in RViz
    assert mesh.colours.tolist() == [[1.0, 0.5, 0.0]] * 2


def test_a_wavefront_file_with_polygons_and_counting_backwards(tmp_path: Path) -> None:
    file = tmp_path / "square.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2/2/2 3/3/3 4/4/4\nf -4 -3 -2\n")
    mesh = read_obj(file, quiet)
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3], [0, 1, 2]]


def test_where_meshes_are_looked_for(tmp_path: Path) -> None:
    (tmp_path / "share").mkdir()
    file = tmp_path / "share" / "a b.stl"
    write_stl(file, 2)

    def share_of(package: str) -> str:
        if package != "car":
            raise LookupError(package)
        return str(tmp_path / "share")

    store = MeshStore(share_of, tmp_path / "share")
    for uri in ("package://car/a%20b.stl", f"file://{tmp_path}/share/a%20b.stl", str(file), "a b.stl"):
        assert isinstance(store.read(uri), MeshData)
    for uri in ("package://other/x.stl", "package://car/no.stl", "http://example.org/x.stl", "a.blend"):
        with pytest.raises((OSError, ValueError)):
            store.read(uri)
    with pytest.raises(OSError):
        MeshStore(share_of).read("a b.stl")


def test_sizes_that_are_no_numbers_are_not_drawn(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("map", "a")
    shapes = "".join(
        f"<visual><geometry>{geometry}</geometry></visual>"
        for geometry in (
            "<box size='nan 1 1'/>",
            "<sphere radius='inf'/>",
            "<cylinder radius='1e300' length='1e300'/>",
            "<box size='1 1 1'/>",
        )
    )
    display = machine.robot(f"<robot name='r'><link name='a'>{shapes}</link></robot>")
    assert display.status("URDF") is not None
    from day6_tui.render.painter import QUALITIES, paint

    picture = paint(rviz.scene, rviz.view.camera(), 40, 40, 1.0, QUALITIES["High"])
    assert np.isfinite(picture.colour).all()


@pytest.mark.long
def test_a_robot_of_three_thousand_links_does_not_stop_the_others(machine: RVizMachine) -> None:
    count = 3000
    links = "".join(
        f"<link name='l{i}'><visual><geometry><box size='1 1 1'/></geometry></visual></link>" for i in range(count)
    )
    joints = "".join(
        f"<joint name='j{i}' type='fixed'><parent link='l0'/><child link='l{i}'/></joint>" for i in range(1, count)
    )
    rviz = machine.open()
    display = machine.add("RobotModel", "/robot_description")
    machine.describe(f"<robot name='r'>{links}{joints}</robot>")
    machine.until(lambda: display.status("URDF") is not None, 60)
    slowest = 0.0
    for _ in range(5):
        rviz.touch()
        began = thread_time()  # not what other programs of the machine take
        machine.advance(0.2)
        slowest = max(slowest, thread_time() - began)
    assert slowest < 1.0
    assert display.status("l2999") == ("Error", "No transform from [l2999] to [map]")


def test_a_new_description_takes_the_place_of_one_that_is_still_being_read(
    machine: RVizMachine, tmp_path: Path
) -> None:
    file = tmp_path / "big.stl"
    write_stl(file, 400_000)
    machine.open()
    display = machine.add("RobotModel", "/robot_description")
    mesh = f"<visual><geometry><mesh filename='file://{file}'/></geometry></visual>"
    machine.describe(f"<robot name='first'><link name='a'>{mesh}</link></robot>")
    machine.describe("<robot name='second'><link name='b'/></robot>")
    machine.until(lambda: display.status("URDF") is not None)
    machine.settle(1.0)
    assert display.parts.robot.name == "second"
