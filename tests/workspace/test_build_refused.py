"""What `colcon build` refuses and how it says so, each as the real colcon did when it was tried."""

from __future__ import annotations

import re

import pytest

from tests.workspace.workshop import Workshop, edit


def timeless(text: str) -> str:
    return re.sub(r"\[\d+\.\d+s", "[<T>", text)


@pytest.mark.process
def test_a_package_whose_need_was_never_built_cannot_be_built_alone(workshop: Workshop) -> None:
    workshop.create("base")
    workshop.create("user", "--dependencies base")
    done = workshop.run("colcon build --packages-select user")
    assert done.status == 1
    assert timeless(done.out) == ("Starting >>> user\n\nSummary: 0 packages finished [<T>]\n  1 package failed: user\n")
    missing = workshop.workspace / "install" / "base" / "share" / "base" / "package.sh"
    assert timeless(done.err) == (
        "[<T>] ERROR:colcon.colcon_ros.task.ament_python.build:Failed to find the following files:\n"
        f"- {missing}\nCheck that the following packages have been built:\n- base\n"
        "Failed   <<< user [<T>, exited with code 1]\n"
    )
    assert workshop.run("colcon build --packages-select base").status == 0
    assert workshop.run("colcon build --packages-select user").status == 0


@pytest.mark.process
def test_up_to_a_package_what_others_on_the_way_need_for_their_tests_is_built_too(workshop: Workshop) -> None:
    """Without it base would be refused: colcon-core 0.21 follows every category of dependencies."""
    workshop.create("checks")
    base = workshop.create("base", "--dependencies checks")
    edit(base / "package.xml", "<depend>checks</depend>", "<test_depend>checks</test_depend>")
    workshop.create("user", "--dependencies base")
    workshop.create("nobody")
    done = workshop.run("colcon build --packages-up-to user")
    assert done.status == 0 and "Summary: 3 packages finished" in done.out, done


@pytest.mark.process
def test_what_an_underlay_has_need_not_be_built_again(workshop: Workshop) -> None:
    workshop.create("base")
    assert workshop.run("colcon build").status == 0
    made = workshop.run("mkdir -p ~/over/src && cp -r src/base ~/over/src/base")
    assert made.status == 0
    done = workshop.run(
        "source install/setup.bash\ncd ~/over/src\nros2 pkg create --build-type ament_python user --dependencies base\n"
        "cd ..\ncolcon build --packages-select user"
    )
    assert done.status == 0, done


@pytest.mark.process
def test_what_setup_py_prints_spoils_the_build(workshop: Workshop) -> None:
    package = workshop.create("hello")
    edit(package / "setup.py", "package_name =", "print('hi')\npackage_name =")
    done = workshop.run("colcon build")
    assert done.status == 1
    assert "SyntaxError: invalid syntax\n" in done.err
    assert done.err.endswith("invalid syntax (<unknown>, line 1)\n")
    edit(package / "setup.py", "print('hi')", "print('# only a comment')")
    assert workshop.run("colcon build").status == 0


def test_without_setup_py_the_build_says_what_it_could_not_open(workshop: Workshop) -> None:
    package = workshop.create("hello")
    (package / "setup.py").unlink()
    done = workshop.run("colcon build")
    assert done.status == 1
    warnings = [line for line in done.err.splitlines() if "WARNING:colcon.colcon_ros" in line]
    assert ["marker" in line for line in warnings] == [True, False]
    assert f"can't open file '{package / 'setup.py'}': [Errno 2] No such file or directory" in done.err


@pytest.mark.process
def test_what_follows_cmake_args_belongs_to_cmake(workshop: Workshop) -> None:
    workshop.create("hello")
    assert workshop.run("colcon build --cmake-args -DCMAKE_BUILD_TYPE=Release -G Ninja --symlink-install").status == 0
    assert list(workshop.workspace.glob("install/**/*.egg-link")), "an option of colcon's own ends the list"
    done = workshop.run("colcon build -DCMAKE_BUILD_TYPE=Release")
    assert done.status == 2
    assert done.err.endswith("colcon: error: unrecognized arguments: -DCMAKE_BUILD_TYPE=Release\n")
