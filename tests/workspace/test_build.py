"""Builds by `colcon build`, real ones: what they leave, what they say, and how they end."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.workspace.workshop import Workshop, edit

posix_only = pytest.mark.skipif(sys.platform == "win32", reason="needs a POSIX system")
BASH = shutil.which("bash")


def timeless(text: str) -> str:
    return re.sub(r"\[\d+\.\d+s", "[<T>", text)


def site_packages(workshop: Workshop, package: str) -> Path:
    return workshop.workspace / "install" / package / f"lib/python3.{sys.version_info.minor}/site-packages"


@pytest.mark.process
def test_the_script_that_is_installed_runs_the_student_s_code(workshop: Workshop) -> None:
    package = workshop.create("hello", "--node-name hi")
    assert workshop.run("colcon build").status == 0
    done = workshop.run("source install/setup.bash\nros2 run hello hi\nros2 pkg executables hello")
    assert done == (0, "Hi from hello.\nhello hi\n", "")
    edit(package / "hello" / "hi.py", "Hi from", "Bye from")
    again = "source install/setup.bash\nros2 run hello hi"
    assert workshop.run(again).out == "Hi from hello.\n", "a change counts only after the next build"
    assert workshop.run("colcon build").status == 0
    assert workshop.run(again).out == "Bye from hello.\n"


@pytest.mark.process
@posix_only
def test_with_symlink_install_a_change_counts_at_once_and_back_again(workshop: Workshop) -> None:
    package = workshop.create("hello", "--node-name hi")
    run = "source install/setup.bash\nros2 run hello hi"
    assert workshop.run("colcon build --symlink-install").status == 0
    edit(package / "hello" / "hi.py", "Hi from", "Bye from")
    assert workshop.run(run).out == "Bye from hello.\n"
    assert (site_packages(workshop, "hello") / "hello.egg-link").is_file()
    assert workshop.run("colcon build").status == 0
    assert not list(workshop.workspace.glob("install/**/*.egg-link"))
    edit(package / "hello" / "hi.py", "Bye from", "Later from")
    assert workshop.run(run).out == "Bye from hello.\n", "the copy stays"
    assert workshop.run("colcon build --symlink-install").status == 0
    assert workshop.run(run).out == "Later from hello.\n"


@pytest.mark.process
def test_a_package_is_built_after_those_it_needs(workshop: Workshop) -> None:
    workshop.create("z_base")
    workshop.create("a_user", "--dependencies z_base")
    done = workshop.run("colcon build")
    assert timeless(done.out) == (
        "Starting >>> z_base\nFinished <<< z_base [<T>]\nStarting >>> a_user\nFinished <<< a_user [<T>]\n\n"
        "Summary: 2 packages finished [<T>]\n"
    )


@pytest.mark.process
def test_when_one_fails_those_that_need_it_are_not_started(workshop: Workshop) -> None:
    base = workshop.create("z_base")
    workshop.create("a_user", "--dependencies z_base")
    (base / "setup.py").write_text("import nothing_of_that_name\n", encoding="utf-8")
    done = workshop.run("colcon build")
    assert done.status == 1
    assert timeless(done.out) == (
        "Starting >>> z_base\n\nSummary: 0 packages finished [<T>]\n  1 package failed: z_base\n"
        "  1 package had stderr output: z_base\n  1 package not processed\n"
    )
    assert "ModuleNotFoundError: No module named 'nothing_of_that_name'\n" in done.err


@pytest.mark.process
def test_ctrl_c_aborts_the_build_and_leaves_no_process(workshop: Workshop) -> None:
    package = workshop.create("slow")
    text = (package / "setup.py").read_text(encoding="utf-8")
    (package / "setup.py").write_text(
        "import time\nprint('waiting', flush=True)\ntime.sleep(60)\n" + text, encoding="utf-8"
    )
    running = workshop.start("colcon build; echo status $?")
    workshop.wait(lambda: "Starting >>> slow" in running.out.text)
    shell_program = next(program for program in workshop.desk.programs.values() if program.session.argv[0] == "colcon")
    shell_program.interrupt()
    workshop.wait(lambda: running.program.status is not None, 10.0)
    assert "Aborted  <<< slow [" in running.out.text
    assert "  1 package aborted: slow\n" in running.out.text
    assert running.err.text == ""


@pytest.mark.process
def test_a_file_that_setup_py_cannot_be_read_in_is_told(workshop: Workshop) -> None:
    package = workshop.create("hello")
    (package / "setup.py").write_bytes("# 中文\nfrom setuptools import setup\nsetup(name='hello')\n".encode("gbk"))
    done = workshop.run("colcon build")
    assert done.status == 1
    assert "SyntaxError: " in done.err and "Failed   <<< hello" in done.err


@pytest.mark.process
def test_names_with_spaces_and_chinese_build(workshop: Workshop) -> None:
    folder = workshop.home / "我的 工作区"
    (folder / "src").mkdir(parents=True)
    done = workshop.run(
        f"cd '{folder}/src'\nros2 pkg create --build-type ament_python hello --node-name hi > /dev/null\ncd ..\n"
        "colcon build\nsource install/setup.bash\nros2 run hello hi\n"
    )
    assert done.out.endswith("Hi from hello.\n"), done


@pytest.mark.usefixtures("plain_user")
def test_a_folder_that_cannot_be_written_is_named(workshop: Workshop) -> None:
    workshop.create("hello")
    workshop.workspace.chmod(0o500)
    try:
        done = workshop.run("colcon build")
    finally:
        workshop.workspace.chmod(0o700)
    assert done.status == 1
    assert "Permission denied" in done.err and "Traceback" not in done.err


@pytest.mark.process
def test_a_full_disk_is_told_and_leaves_no_half_file(workshop: Workshop, monkeypatch: pytest.MonkeyPatch) -> None:
    workshop.create("hello")
    assert workshop.run("colcon build").status == 0
    before = (workshop.workspace / "install/setup.bash").read_text(encoding="utf-8")

    def full(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    done = workshop.run("colcon build")
    assert done.status == 1
    assert "No space left on device" in done.err
    assert (workshop.workspace / "install/setup.bash").read_text(encoding="utf-8") == before
    assert not list(workshop.workspace.rglob(".day6-*"))


# -- sourcing ----------------------------------------------------------------------------------------------------------


@pytest.mark.process
@pytest.mark.skipif(BASH is None, reason="no bash")
@pytest.mark.parametrize("option", ["", "--symlink-install", "--merge-install"])
def test_a_real_bash_sources_the_workspace_to_the_same_environment(workshop: Workshop, option: str) -> None:
    workshop.create("one", "--node-name hi")
    workshop.create("two", "--dependencies one")
    assert workshop.run(f"colcon build {option}").status == 0
    ours = workshop.run(
        "unset PYTHONPATH\nsource install/setup.bash\nprintenv AMENT_PREFIX_PATH COLCON_PREFIX_PATH PYTHONPATH"
    )
    assert BASH is not None
    names = ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "PYTHONPATH")
    env = {name: value for name, value in os.environ.items() if name not in names}
    for shell, script in ((BASH, "source install/setup.bash"), ("/bin/sh", ". install/setup.sh")):
        theirs = subprocess.run(
            [shell, "-c", f"set -e; {script}; printenv AMENT_PREFIX_PATH COLCON_PREFIX_PATH PYTHONPATH"],
            cwd=workshop.workspace,
            env=env,
            capture_output=True,
            text=True,
            check=True,
        )
        assert (theirs.stdout, theirs.stderr) == (ours.out, "")
        assert len(ours.out.splitlines()) == 3


@pytest.mark.process
@pytest.mark.skipif(BASH is None, reason="no bash")
def test_an_overlay_brings_its_underlay_along(workshop: Workshop) -> None:
    workshop.create("one")
    assert workshop.run("colcon build").status == 0
    over = workshop.home / "over_ws"
    made = workshop.run(
        f"source install/setup.bash\nmkdir -p '{over}/src'\ncd '{over}/src'\nros2 pkg create --build-type ament_python two\n"
        f"cd '{over}'\ncolcon build"
    )
    assert made.status == 0
    ours = workshop.run(f"source '{over}/install/setup.bash'\nprintenv AMENT_PREFIX_PATH")
    assert ours.out == f"{over}/install/two:{workshop.workspace}/install/one\n"
    assert BASH is not None
    env = {name: value for name, value in os.environ.items() if "PREFIX_PATH" not in name}
    theirs = subprocess.run(
        [BASH, "-c", f"source '{over}/install/setup.bash'; printenv AMENT_PREFIX_PATH"],
        env=env,
        capture_output=True,
        text=True,
        check=True,
    )
    assert theirs.stdout == ours.out
    local = workshop.run(f"source '{over}/install/local_setup.bash'\nprintenv AMENT_PREFIX_PATH")
    assert local.out == f"{over}/install/two\n"


@pytest.mark.process
def test_a_terminal_that_was_open_before_the_build_learns_nothing_by_itself(workshop: Workshop) -> None:
    terminal = workshop.terminal()
    workshop.create("hello", "--node-name hi")
    workshop.run("colcon build")
    assert workshop.run("ros2 run hello hi", terminal).err == "Package 'hello' not found\n"
    assert workshop.run("source install/setup.bash; ros2 run hello hi", terminal).out == "Hi from hello.\n"
    assert workshop.run("unset AMENT_PREFIX_PATH; ros2 run hello hi", terminal).err == "Package 'hello' not found\n"


@pytest.mark.parametrize(
    ("line", "out", "err"),
    [
        ("source /opt/ros/jazzy/setup.bash; echo $ROS_DISTRO", "jazzy\n", ""),
        (". /opt/ros/humble/setup.bash", "", "bash: /opt/ros/humble/setup.bash: No such file or directory\n"),
        ("source install/setup.bash", "", "bash: install/setup.bash: No such file or directory\n"),
        (
            "unset ROS_DISTRO; source /opt/ros/jazzy/setup.bash; printenv | grep -i ROS_D",
            "ROS_DOMAIN_ID=0\nROS_DISTRO=jazzy\n",
            "",
        ),
    ],
)
def test_ros_itself_is_sourced_as_if_it_were_installed(workshop: Workshop, line: str, out: str, err: str) -> None:
    done = workshop.run(line)
    assert (done.out, done.err) == (out, err)


def test_a_terminal_whose_path_has_lost_ros_finds_no_command_of_it_until_it_is_sourced(workshop: Workshop) -> None:
    terminal = workshop.terminal()
    workshop.run("export PATH=/usr/bin:/bin", terminal)
    done = workshop.run("ros2 topic list", terminal)
    assert (done.status, done.err) == (127, "bash: ros2: command not found\n")
    assert workshop.run("rviz2; which ros2; command -v rviz2", terminal).err == "bash: rviz2: command not found\n"
    assert workshop.run("colcon --help | head -n 1; ls", terminal).err == ""
    done = workshop.run("source /opt/ros/jazzy/setup.bash; which ros2; ros2 topic list", terminal)
    assert (done.out.splitlines()[0], done.err) == ("/opt/ros/jazzy/bin/ros2", "")


def test_sourcing_ros_again_leaves_a_path_as_it_is(workshop: Workshop) -> None:
    done = workshop.run('before=$PATH; source /opt/ros/jazzy/setup.bash; [ "$PATH" = "$before" ] && echo same')
    assert done.out == "same\n"


# -- messages of one's own ---------------------------------------------------------------------------------------------

LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(day6_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(geometry_msgs REQUIRED)

rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Num.msg"   # a comment
  "srv/Add.srv"
  DEPENDENCIES geometry_msgs
)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
"""


def messages(workshop: Workshop) -> Path:
    folder = workshop.workspace / "src"
    done = workshop.run("ros2 pkg create day6_msgs --dependencies geometry_msgs", workshop.terminal(folder))
    assert done.status == 0
    package = folder / "day6_msgs"
    for name in ("msg", "srv", "launch"):
        (package / name).mkdir()
    (package / "msg" / "Num.msg").write_text("int64 num\ngeometry_msgs/Point where\n", encoding="utf-8")
    (package / "srv" / "Add.srv").write_text("int64 a\nint64 b\n---\nint64 sum\n", encoding="utf-8")
    (package / "launch" / "x.launch.py").write_text("", encoding="utf-8")
    (package / "CMakeLists.txt").write_text(LISTS, encoding="utf-8")
    edit(
        package / "package.xml",
        "  <export>",
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n\n  <export>",
    )
    return package


@pytest.mark.process
def test_messages_of_one_s_own_can_be_imported_shown_and_published(workshop: Workshop) -> None:
    messages(workshop)
    done = workshop.run(
        "colcon build > /dev/null\nsource install/setup.bash\nros2 interface show day6_msgs/srv/Add\n"
        "python3 -c 'from day6_msgs.msg import Num; print(Num(num=3).where.x)'\n"
        "ros2 topic pub --once -w 0 /n day6_msgs/msg/Num '{num: 4, where: {x: 1}}' | tail -2\n"
        "ls install/day6_msgs/share/day6_msgs/launch\n"
    )
    assert done.out == (
        "int64 a\nint64 b\n---\nint64 sum\n0.0\n"
        "publishing #1: day6_msgs.msg.Num(num=4, where=geometry_msgs.msg.Point(x=1.0, y=0.0, z=0.0))\n\nx.launch.py\n"
    ), done


def test_a_terminal_that_has_not_sourced_a_message_does_not_know_it_though_another_has(workshop: Workshop) -> None:
    messages(workshop)
    pub = "ros2 topic pub --once -w 0 /n day6_msgs/msg/Num '{num: 4}'"
    assert workshop.run(f"colcon build > /dev/null; source install/setup.bash; {pub}").err == ""
    fresh = workshop.terminal()
    assert workshop.run(pub, fresh).err == "The passed message type is invalid\n"
    workshop.run("source install/setup.bash", fresh)
    assert workshop.run(pub, fresh).err == ""


def test_a_message_that_was_changed_is_another_after_the_next_build(workshop: Workshop) -> None:
    package = messages(workshop)
    show = "source install/setup.bash\nros2 interface proto day6_msgs/msg/Num | head -2\n"
    workshop.run("colcon build")
    assert "num: 0\n" in workshop.run(show).out
    edit(package / "msg" / "Num.msg", "int64 num", "string word")
    workshop.run("colcon build")
    assert "word: ''\n" in workshop.run(show).out


@pytest.mark.parametrize(
    ("file", "before", "after", "text"),
    [
        ("CMakeLists.txt", '"msg/Num.msg"', '"msg/Nun.msg"', "the passed file 'msg/Nun.msg' doesn't exist"),
        (
            "CMakeLists.txt",
            "find_package(geometry_msgs REQUIRED)",
            "find_package(geometri_msgs REQUIRED)",
            'provided by "geometri_msgs"',
        ),
        (
            "CMakeLists.txt",
            "find_package(rosidl_default_generators REQUIRED)\n",
            "",
            'Unknown CMake command "rosidl_generate_interfaces".',
        ),
        ("CMakeLists.txt", "ament_package()", "ament_package(", "Parse error."),
        (
            "package.xml",
            "rosidl_interface_packages",
            "other",
            "'<member_of_group>rosidl_interface_packages</member_of_group>'",
        ),
        ("msg/Num.msg", "int64 num", "int64 Num", "'Num' is an invalid field name"),
        ("srv/Add.srv", "---\n", "", "separator '---'"),
    ],
)
def test_a_fault_in_a_message_package_is_told(
    workshop: Workshop, file: str, before: str, after: str, text: str
) -> None:
    package = messages(workshop)
    edit(package / file, before, after)
    done = workshop.run("colcon build")
    assert done.status == 1
    assert text in done.err and "--- stderr: day6_msgs\n" in done.err
    assert "Traceback" not in done.err


@pytest.mark.process
def test_a_c_plus_plus_package_is_left_out_and_stops_no_other(workshop: Workshop) -> None:
    """A Python course with one C++ package: what depends on it is built, and a launch runs its Python nodes."""
    source = workshop.workspace / "src"
    for words in (
        "day6_py --build-type ament_python --node-name hello",
        "day6_cpp --node-name counter",
        "day6_bringup",
    ):
        workshop.run(f"ros2 pkg create {words}", workshop.terminal(source))
    both = "<exec_depend>day6_py</exec_depend><exec_depend>day6_cpp</exec_depend>"
    edit(source / "day6_bringup/package.xml", "</buildtool_depend>", f"</buildtool_depend>{both}")
    edit(
        source / "day6_bringup/CMakeLists.txt",
        "ament_package()",
        "install(DIRECTORY launch DESTINATION share/day6_bringup)",
    )
    (source / "day6_bringup/launch").mkdir()
    launch = '<launch><node pkg="day6_cpp" exec="counter"/><node pkg="day6_py" exec="hello" output="screen"/></launch>'
    (source / "day6_bringup/launch/up.launch.xml").write_text(launch, encoding="utf-8")
    done = workshop.run("colcon build")
    assert done.status == 0 and "left out of 'day6_cpp': executable counter.\n" in done.err
    assert timeless(done.out).endswith("Summary: 3 packages finished [<T>]\n  1 package had stderr output: day6_cpp\n")
    said = workshop.run("source install/setup.bash; ros2 run day6_cpp counter").err
    assert (
        said.startswith("No executable found\n('counter' is a C++ program")
        and "a real ROS 2 builds and runs it" in said
    )
    done = workshop.run("source install/setup.bash; ros2 launch day6_bringup up.launch.xml")
    assert "executable 'counter' of package 'day6_cpp' isn't there ('counter' is a C++ program" in done.out
    assert "[hello-1] Hi from day6_py." in done.out and done.status == 0


def test_a_package_that_an_underlay_has_and_needs_is_warned_of(workshop: Workshop) -> None:
    """colcon-override-check: a leaf of the underlay may be overridden without a word."""
    source = workshop.workspace / "src"
    for name in ("demo_nodes_cpp", "std_msgs", "rqt_tf_tree"):
        workshop.run(f"ros2 pkg create {name}", workshop.terminal(source))
    done = workshop.run("colcon build")
    assert done.status == 0 and "rqt_tf_tree' is in" not in done.err
    assert (
        "WARNING:colcon.colcon_core.package_selection:Some selected packages are already built in one or more underlay "
        "workspaces:\n\t'demo_nodes_cpp' is in: /opt/ros/jazzy\n\t'std_msgs' is in: /opt/ros/jazzy\n"
    ) in done.err
    assert "\n\t--allow-overriding demo_nodes_cpp std_msgs\n" in done.err
    done = workshop.run("source install/setup.bash; colcon build --allow-overriding demo_nodes_cpp std_msgs other")
    assert (
        "WARNING:colcon.colcon_core.package_selection:ignoring unknown package 'other' in --allow-overriding"
        in done.err
    )
    assert done.err.count("WARNING") == 1


def test_a_package_of_ros_that_nobody_has_here_stops_no_build_and_a_misspelt_one_does(workshop: Workshop) -> None:
    source = workshop.workspace / "src"
    workshop.run("ros2 pkg create day6_sim --dependencies ros_gz_sim", workshop.terminal(source))
    done = workshop.run("colcon build")
    assert done.status == 0 and "which 'day6_sim' looks for: ros_gz_sim.\nIt was built without them.\n" in done.err
    edit(source / "day6_sim/CMakeLists.txt", "find_package(ros_gz_sim", "find_package(std_mgs")
    done = workshop.run("colcon build")
    assert done.status == 1 and 'By not providing "Findstd_mgs.cmake" in CMAKE_MODULE_PATH' in done.err


# -- terminals ---------------------------------------------------------------------------------------------------------


@pytest.mark.process
def test_a_new_terminal_reads_bashrc_and_an_old_one_does_not(workshop: Workshop) -> None:
    workshop.create("hello", "--node-name hi")
    workshop.run("colcon build")
    before = workshop.desk.open_terminal(80, 24)
    workshop.wait(lambda: before.waiting_at_prompt)
    (workshop.home / ".bashrc").write_text("source ~/ros2_ws/install/setup.bash\n", encoding="utf-8")
    after = workshop.desk.open_terminal(80, 24)
    workshop.wait(lambda: after.waiting_at_prompt)
    assert "AMENT_PREFIX_PATH" not in before.shell.environment
    assert after.shell.environment["AMENT_PREFIX_PATH"] == str(workshop.workspace / "install/hello")


def test_tab_knows_verbs_options_and_packages(workshop: Workshop) -> None:
    from day6_core.session.session import Session
    from day6_core.shell.line.completion import Completer

    workshop.create("day6_one")
    workshop.create("day6_two")
    shell = workshop.terminal()
    completer = Completer(shell, Session(workshop.desk.scheduler, None, ["bash"], env=shell.environment, cwd=shell.cwd))

    def offered(line: str) -> list[str]:
        answers: list[tuple[list[str], int]] = []

        async def ask() -> None:
            answers.append(await completer.complete(line))

        workshop.desk.scheduler.spawn(ask(), "tab")
        workshop.wait(lambda: bool(answers))
        return answers[0][0]

    assert offered("colcon b") == ["build"]
    assert offered("colcon build --sym") == ["--symlink-install"]
    assert offered("colcon build --packages-select day6_o") == ["day6_one"]
    assert offered("colcon build --packages-select day6_one day6_") == ["day6_two"]


@pytest.mark.process
def test_a_log_that_cannot_be_written_fails_no_build(workshop: Workshop, monkeypatch: pytest.MonkeyPatch) -> None:
    workshop.create("hello")

    def full(*arguments: object, **options: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("day6_core.workspace.logs.open", full, raising=False)
    done = workshop.run("colcon build")
    said = "[<T>] WARNING:colcon.colcon_core.logging:the log cannot be written: No space left on device\n"
    assert (done.status, timeless(done.err)) == (0, said), "once"
    assert timeless(done.out).endswith("\nSummary: 1 package finished [<T>]\n")
