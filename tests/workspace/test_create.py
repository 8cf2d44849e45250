"""`ros2 pkg create`: every option has its effect, and a failure leaves nothing behind."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.workspace.workshop import Workshop


def create(workshop: Workshop, words: str):
    return workshop.run(f"ros2 pkg create {words}", workshop.terminal(workshop.workspace / "src"))


def text(workshop: Workshop, name: str) -> str:
    return (workshop.workspace / "src" / name).read_text(encoding="utf-8")


def test_a_license_that_is_known_gets_its_text(workshop: Workshop) -> None:
    listed = create(workshop, "x --license '?'").out.splitlines()
    assert listed[0] == "Supported licenses:"
    for number, name in enumerate(listed[1:]):
        done = create(workshop, f"p_{number} --license {name}")
        assert done.status == 0 and "WARNING" not in done.out
        assert len(text(workshop, f"p_{number}/LICENSE")) > 500


def test_the_options_are_in_the_files(workshop: Workshop) -> None:
    done = create(
        workshop,
        "--build-type ament_python --package-format 2 --description 'a car' --maintainer-name Lei --maintainer-email l@x.cn "
        "--node-name drive --library-name wheels --destination-directory ../more robot --dependencies rclpy",
    )
    assert done.status == 0, done.err
    folder = "../more/robot"
    manifest = text(workshop, f"{folder}/package.xml")
    assert '<package format="2">' in manifest and "package_format2.xsd" in manifest
    assert '<maintainer email="l@x.cn">Lei</maintainer>' in manifest
    assert "<description>a car</description>" in manifest and "<depend>rclpy</depend>" in manifest
    assert "'drive = robot.drive:main'" in text(workshop, f"{folder}/setup.py")
    assert text(workshop, f"{folder}/robot/wheels/__init__.py") == ""
    assert "creating folder ../more/robot/robot/wheels\n" in done.out


def test_the_package_name_behind_the_dependencies_is_taken_for_one(workshop: Workshop) -> None:
    done = create(workshop, "--build-type ament_python --dependencies rclpy std_msgs day6_publisher")
    assert done.status == 2
    assert done.err.endswith("ros2 pkg create: error: the following arguments are required: package_name\n")


def test_a_node_with_the_name_of_the_library_is_renamed(workshop: Workshop) -> None:
    done = create(workshop, "both --node-name wheel --library-name wheel")
    assert done.err == (
        "[WARNING] node name can not be equal to the library name\n[WARNING] renaming node to wheel_node\n"
    )
    assert (workshop.workspace / "src/both/src/wheel_node.cpp").is_file()
    assert "add_library(wheel src/wheel.cpp)" in text(workshop, "both/CMakeLists.txt")
    assert "class Wheel\n" in text(workshop, "both/include/both/wheel.hpp")


@pytest.mark.parametrize("kind", ["cmake", "ament_cmake", "ament_python"])
def test_what_is_made_can_be_read_by_the_tools_it_is_for(workshop: Workshop, kind: str) -> None:
    done = create(workshop, f"p --build-type {kind} --node-name n --library-name l --dependencies std_msgs")
    assert done.status == 0, done.err
    listed = workshop.run("colcon list")
    assert (listed.out, listed.err) == (f"p\tsrc/p\t(ros.{kind})\n", "")
    for path in (workshop.workspace / "src/p").rglob("*.py"):
        ast.parse(path.read_text(encoding="utf-8"))


@pytest.mark.usefixtures("plain_user")
def test_a_folder_that_cannot_be_written_is_told(workshop: Workshop) -> None:
    (workshop.workspace / "src").chmod(0o500)
    try:
        done = create(workshop, "--build-type ament_python hello")
    finally:
        (workshop.workspace / "src").chmod(0o700)
    assert done.status == 1
    assert done.err == "PermissionError: [Errno 13] Permission denied: './hello'\n"


def test_a_full_disk_leaves_no_half_package(workshop: Workshop, monkeypatch: pytest.MonkeyPatch) -> None:
    real = Path.write_text

    def full(path: Path, *arguments: object, **options: object) -> int:
        if path.name == "setup.cfg":
            raise OSError(28, "No space left on device")
        return real(path, *arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(Path, "write_text", full)
    done = create(workshop, "--build-type ament_python hello")
    assert (done.status, done.err) == (1, "OSError: [Errno 28] No space left on device: './hello'\n")
    assert list((workshop.workspace / "src").iterdir()) == []
