"""What packages of courses do and `ros2 pkg create` does not: setup.cfg of Foxy, Python programs in a CMake package."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.workspace.test_build import site_packages
from tests.workspace.workshop import Workshop, edit

PROGRAM = "#!/usr/bin/env python3\nfrom words import WORD\n\nprint(WORD)\n"


def cmake_package(workshop: Workshop, lists: str, files: dict[str, str] | None = None) -> Path:
    """Make a package `day6_mixed` as `ros2 pkg create --dependencies rclcpp` does, with other commands before the last."""
    folder = workshop.workspace / "src"
    done = workshop.run("ros2 pkg create day6_mixed --dependencies rclcpp urdf", workshop.terminal(folder))
    assert done.status == 0
    package = folder / "day6_mixed"
    edit(package / "CMakeLists.txt", "ament_package()", f"{lists}\nament_package()")
    for name, text in (files or {}).items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return package


@pytest.mark.process
def test_the_setup_cfg_of_foxy_with_dashes_puts_programs_where_ros2_run_finds_them(workshop: Workshop) -> None:
    package = workshop.create("hello", "--node-name hi")
    (package / "setup.cfg").write_text(
        "[develop]\nscript-dir=$base/lib/hello\n[install]\ninstall-scripts=$base/lib/hello\n", encoding="utf-8"
    )
    for option in ("", " --symlink-install"):
        done = workshop.run(f"colcon build{option} && source install/setup.bash && ros2 run hello hi")
        assert done.out.endswith("Hi from hello.\n"), done
        assert not (workshop.workspace / "install/hello/bin").exists()


@pytest.mark.process
def test_a_license_classifier_is_no_reason_for_a_warning(workshop: Workshop) -> None:
    package = workshop.create("hello", "--node-name hi")
    edit(
        package / "setup.py",
        "    zip_safe",
        "    classifiers=['License :: OSI Approved :: MIT License'],\n    zip_safe",
    )
    assert workshop.run("colcon build").err == ""


@pytest.mark.process
def test_a_package_that_fails_still_has_the_hook_of_ros(workshop: Workshop) -> None:
    package = workshop.create("hello", "--node-name hi")
    edit(package / "setup.py", "packages=", "packages==")
    assert workshop.run("colcon build").status == 1
    assert [path.name for path in sorted((workshop.workspace / "install/hello").rglob("*.*"))] == [
        "ament_prefix_path.dsv",
        "ament_prefix_path.ps1",
        "ament_prefix_path.sh",
    ]


@pytest.mark.process
def test_python_programs_of_a_cmake_package_run_though_it_names_rclcpp(workshop: Workshop) -> None:
    cmake_package(
        workshop,
        "ament_python_install_package(words PACKAGE_DIR src/words)\n"
        "install(PROGRAMS scripts/say.py DESTINATION lib/${PROJECT_NAME})",
        {"scripts/say.py": PROGRAM, "src/words/__init__.py": "WORD = 'said'\n"},
    )
    done = workshop.run("colcon build > /dev/null && source install/setup.bash && ros2 run day6_mixed say.py")
    assert done == (0, "said\n", "")
    assert (site_packages(workshop, "day6_mixed") / "words/__init__.py").is_file()


def test_messages_may_be_listed_by_a_pattern(workshop: Workshop) -> None:
    package = cmake_package(
        workshop,
        'find_package(rosidl_default_generators REQUIRED)\nfile(GLOB found RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "msg/*.msg")\n'
        'set(all ${found})\nlist(APPEND all "srv/Ask.srv")\nrosidl_generate_interfaces(${PROJECT_NAME} ${all})',
    )
    for name, text in (("msg/One.msg", "int8 a\n"), ("msg/Two.msg", "One b\n"), ("srv/Ask.srv", "---\n")):
        (package / name).parent.mkdir(exist_ok=True)
        (package / name).write_text(text, encoding="utf-8")
    edit(
        package / "package.xml",
        "  <export>",
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n  <export>",
    )
    done = workshop.run("colcon build > /dev/null && source install/setup.bash && ros2 interface package day6_mixed")
    assert sorted(done.out.split()) == ["day6_mixed/msg/One", "day6_mixed/msg/Two", "day6_mixed/srv/Ask"], done


def test_folders_of_ament_cmake_auto_are_installed(workshop: Workshop) -> None:
    package = cmake_package(workshop, "", {"launch/up.py": ""})
    edit(package / "CMakeLists.txt", "\nament_package()", "\nament_auto_package(INSTALL_TO_SHARE launch)")
    assert workshop.run("colcon build").status == 0
    assert (workshop.workspace / "install/day6_mixed/share/day6_mixed/launch/up.py").is_file()


def test_a_package_that_nobody_knows_is_missed_in_cmake_s_words_and_lines(workshop: Workshop) -> None:
    cmake_package(workshop, "find_package(gazebo_ros2_controls REQUIRED)")
    done = workshop.run("colcon build")
    assert done.status == 1
    assert (
        '  By not providing "Findgazebo_ros2_controls.cmake" in CMAKE_MODULE_PATH this\n'
        "  project has asked CMake to find a package configuration file provided by\n"
        '  "gazebo_ros2_controls", but CMake did not find one.\n'
    ) in done.err
    assert "    gazebo_ros2_controlsConfig.cmake\n    gazebo_ros2_controls-config.cmake\n" in done.err
    assert max(map(len, done.err.splitlines())) <= 78
