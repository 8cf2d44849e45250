"""`ros2 launch` itself: which file, which arguments, and what the process that launches is told."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest

from day6_core.session.session import KilledBySignal


class Processes:
    """Stands for Python processes: keeps how each was started, and ends it with `status`."""

    def __init__(self, machine):
        machine.daemon = True  # a shell of day6-tui started the command
        machine.python = self._run
        self.started = []
        self.env = {}
        self.ends = 0

    async def _run(self, session, args):
        self.started.append(args)
        self.env = dict(session.env)
        if isinstance(self.ends, BaseException):
            raise self.ends
        return self.ends

    @property
    def told(self):
        """The only launch's options."""
        ((script, command, options),) = self.started
        assert Path(script).name == "_process" and command == "launch"
        return json.loads(options)


@pytest.fixture
def processes(machine):
    return Processes(machine)


def package(machine, name="lab"):
    """Install a package; returns its share folder."""
    prefix = machine.cwd / "install"
    marker = prefix / "share" / "ament_index" / "resource_index" / "packages" / name
    marker.parent.mkdir(parents=True, exist_ok=True)
    marker.touch()
    machine.env["AMENT_PREFIX_PATH"] = str(prefix)
    share = prefix / "share" / name
    (share / "launch").mkdir(parents=True)
    return share


def test_a_file_is_launched_with_its_arguments(machine, processes):
    (machine.cwd / "a.launch.py").touch()
    processes.ends = 3
    assert machine.ros2("launch", "a.launch.py", "x:=1", "y:=2", "x:=3").status == 3
    assert processes.told == {
        "path": "a.launch.py",
        "argv": ["x:=1", "y:=2", "x:=3"],
        "arguments": [["y", "2"], ["x", "3"]],
        "debug": False,
        "log_file_name": None,
        "noninteractive": False,
        "show": "",
        "guarded": False,
        "terminals": [],
    }
    assert "OVERRIDE_LAUNCH_PROCESS_OUTPUT" not in processes.env


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["-d"], {"debug": True}),
        (["-n"], {"noninteractive": True}),
        (["-p"], {"show": "description"}),
        (["-s"], {"show": "arguments"}),
        (["--launch-prefix", "nice -n 5"], {"argv": ["launch-prefix:=nice -n 5"]}),
        (
            ["--launch-prefix", "nice", "--launch-prefix-filter", "a.*"],
            {"argv": ["launch-prefix:=nice", "launch-prefix-filter:=a.*"]},
        ),
    ],
)
def test_options_are_handed_on(machine, processes, options, told):
    (machine.cwd / "a.launch.py").touch()
    assert machine.ros2("launch", *options, "a.launch.py").status == 0
    assert {name: processes.told[name] for name in told} == told


def test_the_log_file_gets_a_name_since_lyrical(machine, processes, in_distribution):
    in_distribution("lyrical")
    (machine.cwd / "a.launch.py").touch()
    assert machine.ros2("launch", "-f", "mine", "a.launch.py").status == 0
    assert processes.told["log_file_name"] == "mine"


def test_all_output_is_asked_for_by_a_variable(machine, processes):
    (machine.cwd / "a.launch.py").touch()
    machine.ros2("launch", "-a", "a.launch.py")
    assert processes.env["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] == "both"


def test_what_is_only_shown_needs_no_well_formed_arguments(machine, processes):
    (machine.cwd / "a.launch.py").touch()
    assert machine.ros2("launch", "-s", "a.launch.py", "x").status == 0
    assert (processes.told["argv"], processes.told["arguments"]) == (["x"], [])


@pytest.mark.parametrize("word", ["x", "x=1", ":=1", "x:=", "x:1", ""])
def test_malformed_arguments_are_refused(machine, processes, word):
    (machine.cwd / "a.launch.py").touch()
    error = f"malformed launch argument '{word}', expected format '<name>:=<value>'\n"
    assert machine.ros2("launch", "a.launch.py", "y:=1", word) == ("", error, 1)
    assert processes.started == []


@pytest.mark.parametrize(("word", "pair"), [("x:=a:=b", ["x", "a:=b"]), ("x:=:=", ["x", ":="]), ("x:= ", ["x", " "])])
def test_values_may_look_like_arguments(machine, processes, word, pair):
    (machine.cwd / "a.launch.py").touch()
    machine.ros2("launch", "a.launch.py", word)
    assert processes.told["arguments"] == [pair]


def test_a_file_of_a_package_is_found_wherever_it_is(machine, processes):
    share = package(machine)
    (share / "launch" / "deep").mkdir()
    file = share / "launch" / "deep" / "b.launch.xml"
    file.touch()
    machine.ros2("launch", "lab", "b.launch.xml", "x:=1")
    assert (processes.told["path"], processes.told["argv"]) == (str(file), ["x:=1"])


def test_a_file_that_a_package_has_not_or_twice_is_refused(machine, processes):
    share = package(machine)
    where = "in the share directory of package 'lab'"
    missing = machine.ros2("launch", "lab", "b.launch.py")
    assert missing == ("", f"file 'b.launch.py' was not found {where} which is at '{share}'\n", 1)
    for folder in (share, share / "launch"):
        (folder / "b.launch.py").touch()
    twice = machine.ros2("launch", "lab", "b.launch.py")
    listed = f"['{share}/b.launch.py', '{share}/launch/b.launch.py']"
    assert twice == ("", f"file 'b.launch.py' was found more than once {where}: {listed}\n", 1)
    unknown = machine.ros2("launch", "nope", "b.launch.py")
    assert unknown.stderr.startswith("Package 'nope' not found: ") and unknown.status == 1
    assert processes.started == []


def test_a_filter_without_a_prefix_is_refused(machine, processes):
    (machine.cwd / "a.launch.py").touch()
    assert machine.ros2("launch", "--launch-prefix-filter", "x", "a.launch.py") == (
        "",
        "--launch-prefix must be specified if --launch-prefix-filter is provided\n",
        1,
    )


def test_the_launch_arguments_count_as_missing(machine):
    assert machine.ros2("launch").stderr.endswith(
        "error: the following arguments are required: package_name, launch_arguments\n"
    )


def test_in_a_real_terminal_the_command_becomes_the_launch(machine, monkeypatch):
    import os
    import sys

    class Replaced(BaseException):
        pass

    seen = []

    def execve(*words):
        seen.extend(words)
        raise RuntimeError("replaced")

    if os.name != "posix":
        pytest.skip("a process cannot be replaced")
    monkeypatch.setattr(os, "execve", execve)
    monkeypatch.chdir(machine.cwd)
    (machine.cwd / "a.launch.py").touch()
    machine.env["ONLY"] = "here"
    assert machine.ros2("launch", "a.launch.py").stderr == "replaced\n"
    program, words, env = seen
    assert program == words[0] == sys.executable and words[2] == "launch"
    assert json.loads(words[3])["path"] == "a.launch.py"
    assert env["ONLY"] == "here"


# -- Tab ---------------------------------------------------------------------------------------------------------------


def test_tab_offers_folders_launch_files_and_packages(machine):
    share = package(machine)
    for name in ("one.launch.py", "two.launch.xml", "three.launch.yaml", "four.yml", "notes.txt", ".hid.launch.py"):
        (machine.cwd / name).touch()
        (share / "launch" / name).touch()
    (share / "package.xml").touch()
    (machine.cwd / "sub").mkdir()
    (machine.cwd / "sub" / "five.launch").touch()
    (machine.cwd / "dir.launch.py").mkdir()
    offered = machine.complete("launch", "")
    assert [word for word in offered if word in ("lab", "turtlesim")] == ["lab", "turtlesim"]
    local = [word for word in offered if "." in word or "/" in word]
    assert local == ["dir.launch.py/", "four.yml", "install/", "one.launch.py", "sub/", "three.launch.yaml",
                     "two.launch.xml"]  # fmt: skip
    assert machine.complete("launch", ".h") == [".hid.launch.py"]
    assert machine.complete("launch", "sub/") == ["sub/five.launch"]
    assert machine.complete("launch", "nowhere/") == []
    assert machine.complete("launch", "lab", "t") == ["three.launch.yaml", "two.launch.xml"]
    assert "package.xml" not in machine.complete("launch", "lab", "")
    assert machine.complete("launch", "no_such_package", "") == []


def test_tab_knows_home(machine):
    (machine.cwd / "home" / "work").mkdir(parents=True)
    (machine.cwd / "home" / "work" / "a.launch.py").touch()
    machine.env["HOME"] = str(machine.cwd / "home")
    assert machine.complete("launch", "~/wo") == ["~/work/"]
    assert machine.complete("launch", "~/work/") == ["~/work/a.launch.py"]


PYTHON = """
from launch.actions import DeclareLaunchArgument, OpaqueFunction
import launch
def generate_launch_description():
    return [
        DeclareLaunchArgument('speed', default_value='1.5'), OpaqueFunction(function=print),
        launch.actions.DeclareLaunchArgument(name='use_sim_time', default_value='True'),
        DeclareLaunchArgument('mode', default_value='a', choices=['a', 'b']),
        DeclareLaunchArgument('shout', choices=('no', some_function())),
        DeclareLaunchArgument('pick', choices=['true']),
        DeclareLaunchArgument('bare'), DeclareLaunchArgument(computed), DeclareLaunchArgument(),
    ]
"""
XML = """<launch>
  <arg name="speed" default="1.5"/> <arg name="use_sim_time" default="false"/>
  <arg name="mode"><choice value="a"/><choice value="b"/></arg>
  <arg name="where" default="$(find-pkg-share lab)/x"/>
  <include file="x"><arg name="theirs" value="1"/></include>
  <arg/>
</launch>"""
YAML = """launch:
- arg: {name: speed, default: 1.5}
- arg: {name: use_sim_time, default: false}
- arg: {name: mode}
- node: {pkg: a}
- text
- arg: text
"""


@pytest.mark.parametrize(
    ("file", "text", "names", "values"),
    [
        (
            "a.launch.py",
            PYTHON,
            ["bare", "mode", "pick", "shout", "speed", "use_sim_time"],
            {"mode": ["a", "b"], "use_sim_time": ["True", "false"], "pick": ["false", "true"], "bare": []},
        ),
        (
            "a.launch.xml",
            XML,
            ["mode", "speed", "use_sim_time", "where"],
            {"mode": ["a", "b"], "use_sim_time": ["false", "true"], "speed": ["1.5"], "where": []},
        ),
        ("a.launch.yml", YAML, ["mode", "speed", "use_sim_time"], {"use_sim_time": ["false", "true"], "mode": []}),
        ("b.launch.py", "def (", [], {}),
        ("b.launch.xml", "<launch", [], {}),
        ("b.launch.xml", "<!DOCTYPE x [<!ENTITY a 'b'>]><launch><arg name='x'/></launch>", [], {}),
        ("b.launch.yaml", "a: [", [], {}),
        ("b.launch.yaml", "launch: 5", [], {}),
        ("b.launch.yaml", "- launch", [], {}),
    ],
)
@pytest.mark.parametrize("installed", [False, True])
def test_tab_offers_the_arguments_that_a_file_declares(machine, file, text, names, values, installed):
    words = ["lab", file] if installed else [file]
    folder = package(machine) / "launch" if installed else machine.cwd
    (folder / file).write_text(text, encoding="utf-8")
    assert machine.complete("launch", *words, "") == [f"{name}:=" for name in names]
    for name, offered in values.items():
        assert machine.complete("launch", *words, f"{name}:=") == [f"{name}:={value}" for value in offered]
    if names:
        begun = machine.complete("launch", *words, f"{names[0]}:=x", "")
        assert begun == [f"{name}:=" for name in names[1:]], "what was given is not offered again"


def test_a_file_that_is_far_too_long_is_not_read(machine):
    (machine.cwd / "a.launch.xml").write_text(f"<launch><arg name='x'/>{' ' * 1_000_000}</launch>")
    assert machine.complete("launch", "a.launch.xml", "") == []


# -- ros2 run: the same processes --------------------------------------------------------------------------------------


def executable(machine, name="go"):
    package(machine)
    path = machine.cwd / "install" / "lib" / "lab" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n", encoding="utf-8")
    path.chmod(0o755)
    return path


@pytest.mark.parametrize(
    ("ends", "told", "status"),
    [
        (0, "", 0),
        (3, "[ros2run]: Process exited with failure 3\n", 3),
        (KilledBySignal(11), "[ros2run]: Segmentation fault\n", 245),
        (KilledBySignal(9), "[ros2run]: Killed\n", 247),
        (KilledBySignal(2), "[ros2run]: Interrupt\n", 254),
        (KeyboardInterrupt(), "[ros2run]: Interrupt\n", 254),
    ],
)
def test_run_starts_the_file_of_a_workspace_and_tells_how_it_ended(machine, processes, ends, told, status):
    path = executable(machine)
    processes.ends = ends
    result = machine.ros2("run", "lab", "go", "-x", "--ros-args")
    assert processes.started == [[str(path), "-x", "--ros-args"]]
    assert (result.stdout, result.stderr, result.status) == (told, "", status)


def test_run_with_a_prefix_is_a_line_of_the_shell(machine, processes):
    path = executable(machine)
    lines = []

    class Shell:
        async def run_line(self, line, session):
            lines.append(line)
            return self.status

    shell = Shell()
    session_of = machine.session

    def session(argv, stdin=""):
        made = session_of(argv, stdin)
        made.host = shell
        return made

    machine.session = session
    for shell.status, told, status in (
        (0, "", 0),
        (1, "[ros2run]: Process exited with failure 1\n", 1),
        (128, "[ros2run]: Process exited with failure 128\n", 128),
        (139, "[ros2run]: Segmentation fault\n", 245),
    ):
        result = machine.ros2("run", "--prefix", "nice -n '5 6'", "lab", "go", "a b")
        assert (result.stdout, result.status) == (told, status)
    assert lines[0] == f"nice -n '5 6' {shlex.quote(str(path))} 'a b'"


def test_run_with_a_prefix_needs_a_shell_of_ours(machine):
    path = executable(machine)
    result = machine.ros2("run", "--prefix", "nice", "lab", "go")
    assert result == (
        "",
        f"--prefix needs the shell of day6-tui, which did not start this command: nice {shlex.quote(str(path))}\n",
        1,
    )


def test_run_says_when_a_package_has_several_of_the_name(machine):
    path = executable(machine)
    (path.parent / "deep").mkdir()
    other = path.parent / "deep" / "go"
    other.write_text("#!/bin/sh\n", encoding="utf-8")
    other.chmod(0o755)
    result = machine.ros2("run", "lab", "go")
    assert result.status == 1
    assert result.stderr.splitlines()[0] == "Multiple executables found:"
    assert sorted(result.stderr.splitlines()[1:]) == [f"- {other}", f"- {path}"]
