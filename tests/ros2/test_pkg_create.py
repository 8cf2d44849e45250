"""What `ros2 pkg create` says and asks for; what it writes is tested in tests/workspace."""

from __future__ import annotations

import pytest

ANNOUNCED = """going to create a new package
package name: {name}
destination directory: {destination}
package format: 3
version: 0.0.0
description: TODO: Package description
maintainer: ['ada <ada@todo.todo>']
licenses: ['TODO: License declaration']
build type: ament_cmake
dependencies: []
"""


@pytest.fixture
def ada(machine):
    machine.env["USER"] = "ada"
    return machine


def test_the_plan_is_announced_with_the_defaults(ada):
    result = ada.ros2("pkg", "create", "mine")
    assert (result.stderr, result.status) == ("", 0)
    assert result.stdout.startswith(
        f"{ANNOUNCED.format(name='mine', destination=ada.cwd)}creating folder ./mine\ncreating ./mine/package.xml\n"
    )
    assert (ada.cwd / "mine" / "package.xml").is_file()


def test_everything_that_was_asked_for_is_announced_and_written(ada):
    result = ada.ros2(
        *("pkg", "create", "mine", "--package-format", "2", "--description", "of it", "--license", "MIT"),
        *("--build-type", "ament_python", "--dependencies", "rclpy", "std_msgs", "--maintainer-email", "e@x.org"),
        *("--maintainer-name", "eve", "--node-name", "go", "--library-name", "lib", "--destination-directory", "src"),
    )
    assert result.status == 0
    folder = ada.cwd / "src"
    assert result.stdout.startswith(
        "going to create a new package\npackage name: mine\n"
        f"destination directory: {folder}\npackage format: 2\nversion: 0.0.0\ndescription: of it\n"
        "maintainer: ['eve <e@x.org>']\nlicenses: ['MIT']\nbuild type: ament_python\n"
        "dependencies: ['rclpy', 'std_msgs']\nnode_name: go\nlibrary_name: lib\ncreating folder src/mine\n"
    )
    manifest = (folder / "mine" / "package.xml").read_text(encoding="utf-8")
    for part in (
        '<package format="2">',
        "<description>of it</description>",
        '<maintainer email="e@x.org">eve</maintainer>',
        "<license>MIT</license>",
        "<depend>std_msgs</depend>",
    ):
        assert part in manifest


def test_only_a_node_or_only_a_library_is_announced_alone(ada):
    node = ada.ros2("pkg", "create", "one", "--node-name", "go").stdout
    assert "dependencies: []\nnode_name: go\ncreating folder" in node
    library = ada.ros2("pkg", "create", "two", "--library-name", "lib").stdout
    assert "dependencies: []\nlibrary_name: lib\ncreating folder" in library


@pytest.mark.parametrize(
    ("env", "options", "maintainer"),
    [
        ({"LOGNAME": "a", "USER": "b", "LNAME": "c", "USERNAME": "d"}, [], "a <a@todo.todo>"),
        ({"LOGNAME": "", "USER": "b", "LNAME": "c", "USERNAME": "d"}, [], "b <b@todo.todo>"),
        ({"LNAME": "c", "USERNAME": "d"}, [], "c <c@todo.todo>"),
        ({"USERNAME": "d"}, [], "d <d@todo.todo>"),
        ({}, [], "root <root@todo.todo>"),
        ({"USER": "b"}, ["--maintainer-name", "m"], "m <m@todo.todo>"),
        ({"USER": "b"}, ["--maintainer-email", "m@x"], "b <m@x>"),
    ],
)
def test_the_maintainer_is_who_is_logged_in(machine, env, options, maintainer):
    machine.env.update(env)
    assert f"maintainer: ['{maintainer}']\n" in machine.ros2("pkg", "create", "mine", *options).stdout


def test_a_question_mark_lists_the_licenses_and_makes_nothing(ada):
    result = ada.ros2("pkg", "create", "mine", "--license", "?")
    assert result.status == 0
    lines = result.stdout.splitlines()
    assert lines[:2] == ["Supported licenses:", "Apache-2.0"] and "MIT" in lines
    assert not list(ada.cwd.iterdir())


def test_a_node_named_as_the_library_is_renamed(ada):
    result = ada.ros2("pkg", "create", "mine", "--node-name", "x", "--library-name", "x")
    assert result.stderr == (
        "[WARNING] node name can not be equal to the library name\n[WARNING] renaming node to x_node\n"
    )
    assert "node_name: x_node\nlibrary_name: x\n" in result.stdout


@pytest.mark.parametrize(
    ("words", "there", "answer"),
    [
        (
            ["test", "--build-type", "ament_python"],
            None,
            "Aborted since 'ament_python' packages can't be named 'test'. Please choose a different package name.\n",
        ),
        (
            ["mine"],
            "mine",
            (
                "\nAborted!\nThe directory already exists: ./mine\nEither remove the directory or choose a different "
                "destination directory or package name\n"
            ),
        ),
        (
            ["mine", "--destination-directory", "src"],
            "src/mine",
            (
                "\nAborted!\nThe directory already exists: src/mine\nEither remove the directory or choose a different "
                "destination directory or package name\n"
            ),
        ),
    ],
)
def test_what_cannot_be_made_is_refused(ada, words, there, answer):
    if there:
        (ada.cwd / there).mkdir(parents=True)
    assert ada.ros2("pkg", "create", *words) == ("", answer, 1)


def test_a_package_called_test_may_be_one_of_cmake(ada):
    assert ada.ros2("pkg", "create", "test").status == 0


def test_a_folder_that_is_gone_is_told(ada):
    ada.cwd = ada.cwd / "gone"
    result = ada.ros2("pkg", "create", "mine")
    assert result.stderr.startswith("ros2 pkg create: ") and result.status == 1
