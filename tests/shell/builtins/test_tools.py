"""find, cut, tr, sed, diff print what the real tools print; less, man, apt and rosdep answer a beginner."""

from __future__ import annotations

import shutil
import subprocess
import sys
from inspect import iscoroutinefunction
from pathlib import Path
from typing import Any

import pytest

TREE = (
    "mkdir -p a/b; echo one > a/x.py; echo two > a/b/car.urdf; : > a/b/empty; "
    "printf 'x=1\\ny=2\\n' > f; printf 'x=1\\ny=3\\nz\\n' > g"
)

SAME_AS_THE_TOOLS = [
    "find a -name '*.py' -o -name '*.urdf' | sort",
    "find . -type d | sort",
    "find a -empty",
    "find . -maxdepth 1 -type f ! -name f",
    "find a -iname '*.URDF'",
    "find . -path './a/b/*' | sort",
    "find a -name empty -delete; find a -type f | sort",
    "find nope; echo $?",
    "find a -maxdepth x; echo $?",
    "find . -type f -size -2c | sort",
    "printf 'a:b:c\\n1:2:3\\nno\\n' | cut -d: -f1,3",
    "printf 'a:b:c\\nno\\n' | cut -s -d: -f2-",
    "echo abcdef | cut -c2-4",
    "echo hello World | tr a-z A-Z",
    "echo hello | tr -d l",
    "echo 'a   b    c' | tr -s ' '",
    "echo 'a b c' | tr ' ' '\\n'",
    "echo abc123 | tr -d '[:digit:]'",
    "echo abc123 | tr -cd '[:digit:]'",
    "echo w | tr a b c; echo w | tr -d a b; echo w | tr -ds a; echo w | tr -s a b c; echo w | tr -d; echo $?",
    "mkdir -pv new/er; mkdir -v new/er; touch -c none; ls none; grep -s x none; echo $?; ls -C a | cat; ls --color=never a",
    "printf 'a b\\nc\\n' | xargs -L 1 echo got; head -n 1k f; time -p true 2> /dev/null",
    "sed 's/=/ is /' f",
    "sed -n '2p' f",
    "sed '/x/d' f g",
    "sed 's|=|-|g; s/x/y/' f",
    "sed -E 's/(.)=(.)/\\2=\\1/' f",
    "sed 's/\\(.\\)=\\(.\\)/\\2=\\1/' f",
    "sed '$d' f",
    "sed '1,2s/[0-9]/&&/' g",
    "sed -i 's/1/9/' f; cat f",
    "sed 's/X/q/I' f",
    "diff f g; echo $?",
    "diff f f; echo $?",
    "diff -q f g",
    "diff -u f g | tail -n +3",
    "diff g f",
    "ln -s a/x.py link; cat link; readlink link; readlink f; echo $?; ln -s f link; echo $?; ln -sf f link; readlink link",
    "ln f hard; echo more >> hard; tail -1 f; ln nope x; echo $?; ln -s ../f a; cat a/f; ln",
    "ln -s a dir; realpath dir/b | sed 's|.*/a|a|'; readlink -f dir/x.py | sed 's|.*/a|a|'; realpath no/where; echo $?",
    "printf 'a b\\nc\\n' | xargs; printf 'a b c\\n' | xargs -n 2 echo got; printf 'x y\\nz\\n' | xargs -I {} echo '<{}>'",
    "find a -name '*.py' | xargs cat; printf '' | xargs echo none; printf '' | xargs -r echo never; echo f g | xargs wc -l",
    "printf 'a\\0b c\\0' | xargs -0 -n1 echo; echo 1 | xargs false; echo $?; echo \"'a b' c\" | xargs -n1 echo",
    'n=/dev/null; pushd a > $n; pushd b > $n; basename "$PWD"; popd > $n; basename "$PWD"; popd > $n; popd; echo $?',
    "wc f g; wc -l f g; wc f; wc -lw f a/x.py; wc < f",
    "ln -sf f f; echo $?; cat f; ln -f f f; echo $?; cat f; ln -sf ./f f; echo $?; cat f; ln -f nope f; echo $?; cat f",
    "ln -s f l; ln -sf f l; cat l; ln -f f l; cat l; ln -sf a l; readlink l; ln -sf f a/f; readlink a/f; ls -A",
    "echo n | rm -i f; cat f; echo y | rm -i f; ls; echo n | rm -ri a; find a | sort; echo y | rm -i nope; echo $?",
    "echo n | mv -i f g; cat f g; echo y | cp -i f g; cat g; echo n | cp -i a/x.py g; cat g; echo y | mv -i f g; ls",
    "pushd nowhere; echo $?; (cd a; pushd b | wc -l); dirs | wc -l",
]


@pytest.mark.process
@pytest.mark.skipif(sys.platform != "linux" or shutil.which("bash") is None, reason="compares with GNU tools")
@pytest.mark.parametrize("command", SAME_AS_THE_TOOLS)
def test_a_tool_prints_what_the_real_one_prints(machine: Any, tmp_path: Path, command: str) -> None:
    folder = tmp_path / "real"
    folder.mkdir()
    real = subprocess.run(
        ["bash", "-c", f"{TREE}; {command}"], cwd=folder, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"}
    )
    ours = machine.run(f"mkdir ours; cd ours; {TREE}; {command}")
    assert (ours.out, ours.status) == (real.stdout, real.returncode)
    assert bool(ours.err) == bool(real.stderr)


def test_less_without_a_terminal_passes_the_text_on(machine: Any) -> None:
    assert machine.run("echo one > f; less f; cat f | less").out == "one\none\n"


def test_man_speaks_the_language_of_the_terminal(machine: Any) -> None:
    assert "list files and folders" in machine.run("LANG=C man ls").out
    assert "列出文件和文件夹" in machine.run("LANG=zh_CN.UTF-8 man ls").out
    assert machine.run("man nothing") == (16, "", "No manual entry for nothing\n")


def test_every_command_is_a_function() -> None:
    from day6_core.shell.commands import builtin, command_names

    assert [name for name in command_names() if not iscoroutinefunction(builtin(name))] == []


def test_every_example_of_the_manual_is_a_command_that_exists(machine: Any) -> None:
    from day6_core.shell.commands import command_names
    from day6_core.shell.manual import _PAGES

    assert set(_PAGES) <= set(command_names())
    for page in _PAGES.values():
        assert all(example.split()[0] in command_names() for example in page.examples)


def test_apt_says_of_each_package_what_becomes_of_it(machine: Any) -> None:
    out = machine.run("sudo apt install -y ros-jazzy-turtlesim ros-jazzy-nav2-bringup tree").out
    assert "ros-jazzy-turtlesim is already the newest version" in out
    assert "ros-jazzy-nav2-bringup: not part of day6-tui" in out
    assert "tree is already the newest version." in out


def test_rosdep_looks_at_the_packages_and_names_what_nobody_has(machine: Any) -> None:
    manifest = (
        '<package format="3"><name>car</name><version>0.0.0</version><description>x</description>'
        '<maintainer email="a@example.org">a</maintainer><license>x</license>'
        "<depend>rclpy</depend><exec_depend>{}</exec_depend></package>"
    )
    (machine.desk.home / "ros2_ws/src/car").mkdir(parents=True)
    file = machine.desk.home / "ros2_ws/src/car/package.xml"
    file.write_text(manifest.format("turtlesim"))
    done = machine.run("cd ~/ros2_ws; rosdep install --from-paths src --ignore-src -y")
    assert done == (0, "#All required rosdeps installed successfully\n", "")
    for known in (
        "tf2_ros_py",
        "tf2",
        "pluginlib",
        "rosbag2_cpp",
        "libqt5-core",
        "qtbase5-dev",
    ):  # of the tutorials' packages
        file.write_text(manifest.format(known))
        assert machine.run("cd ~/ros2_ws; rosdep install -i --from-path src -y") == done
    file.write_text(manifest.format("no_such_package"))
    done = machine.run("cd ~/ros2_ws; rosdep install --from-paths src -y")
    assert done.status == 1 and "car: Cannot locate rosdep definition for [no_such_package]" in done.err
    (file.parent / "COLCON_IGNORE").touch()
    assert machine.run("cd ~/ros2_ws; rosdep install --from-paths src -y").status == 0


@pytest.mark.parametrize(
    ("package", "answer"),
    [
        ("liburdfdom-tools", "liburdfdom-tools is already the newest version (check_urdf, urdf_to_graphviz)."),
        ("ros-${ROS_DISTRO}-joint-state-publisher-gui", "joint-state-publisher-gui is already the newest version"),
        ("'~nros-jazzy-rqt*'", "ros-jazzy-rqt* is already the newest version"),
        ("ros-jazzy-rosbag2", "ros-jazzy-rosbag2 is already the newest version"),
        ("ros-jazzy-nav2-bringup", "ros-jazzy-nav2-bringup: not part of day6-tui"),
        ("cowsay", "cowsay: not needed on this machine"),
    ],
)
def test_apt_install_says_what_a_package_is_here(machine: Any, package: str, answer: str) -> None:
    """Sections 4.4 and 5.4 of the lesson and the page "rqt" of the official tutorials."""
    result = machine.run(f"sudo apt install {package}")
    assert result.status == 0 and answer in result.out


def test_watch_shows_a_command_anew_until_ctrl_c(machine: Any) -> None:
    machine.run("echo one > f")
    program = machine.start("watch -n 5 cat f; echo no")
    machine.go(1.0)
    (machine.desk.home / "f").write_text("two\n")
    machine.go(5.0)
    assert machine.out.text == "Every 5.0s: cat f\n\none\nEvery 5.0s: cat f\n\ntwo\n"
    program.interrupt()
    machine.go()
    assert program.status == 130 and "no" not in machine.out.text


def test_the_machine_says_what_it_is(machine: Any) -> None:
    import os

    assert machine.run("id -u; id -un; [ $(id -u) -ge 1000 ] && id -gn").out == "1000\nstudent\nstudent\n"
    assert machine.run("nproc").out == f"{os.cpu_count()}\n"
    assert machine.run("lsb_release -a").out.startswith("Distributor ID:\t")
    assert machine.run("LC_ALL=C.UTF-8 locale").out.endswith("LC_ALL=C.UTF-8\n")
