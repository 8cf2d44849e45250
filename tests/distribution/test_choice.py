"""Which distribution is chosen, by whom, and for what it holds."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.places import data_folder
from day6_core.ros.distribution import DEFAULT, NAMES
from day6_core.ros.setup_lines import last_sourced
from day6_tui.distribution_choice import sourced_by, start_again

from .command import day6


def printed(*words: str, line: str = "echo $ROS_DISTRO", **variables: str) -> str:
    done = day6(*words, "exec", "-c", line, **variables)
    return done.stdout.strip() + done.stderr.strip()


def remember(name: str) -> None:
    path = data_folder() / "settings.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps({"distro": name, "theme": "light"}), encoding="utf-8")


@pytest.mark.process
def test_without_a_choice_it_is_jazzy() -> None:
    assert printed() == DEFAULT == "jazzy"


@pytest.mark.process
def test_an_option_is_stronger_than_the_variable_and_that_than_what_was_chosen_last() -> None:
    remember("kilted")
    assert printed() == "kilted"
    assert printed(ROS_DISTRO="humble") == "humble"
    assert printed("--distro", "rolling", ROS_DISTRO="humble") == "rolling"
    assert printed("--distro=jazzy", ROS_DISTRO="humble") == "jazzy"


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("source /opt/ros/lyrical/setup.bash", "lyrical"),
        ("a=1\n. /opt/ros/humble/setup.sh\nsource '/opt/ros/kilted/setup.bash'\n", "kilted"),
        ("  source /opt/ros/jazzy/local_setup.zsh  # the lab's", "jazzy"),
        ("if true; then source /opt/ros/rolling/setup.bash; fi", "rolling"),
        ("[ -f /opt/ros/jazzy/setup.bash ] && source /opt/ros/jazzy/setup.bash", "jazzy"),
        ("# source /opt/ros/lyrical/setup.bash", None),
        ("source /opt/ros/jazzy/setup.bash\nsource /opt/ros/foxy/setup.bash", "jazzy"),
        ("echo source /opt/ros/jazzy/setup.bash", None),
        ("source /opt/ros/$ROS_DISTRO/setup.bash", None),
        ("source /opt/ros/jazzy/setup.bash.old", None),
        ("", None),
    ],
)
def test_the_line_that_sources_last_is_found(text: str, name: str | None) -> None:
    assert last_sourced(text) == name


@pytest.mark.process
def test_what_bashrc_or_the_lines_source_is_stronger_than_what_was_chosen_last(tmp_path: Path) -> None:
    remember("kilted")
    (tmp_path / ".bashrc").write_text("source /opt/ros/lyrical/setup.bash\n", encoding="utf-8")
    assert sourced_by(["--home", str(tmp_path)]) == sourced_by([f"--home={tmp_path}"]) == "lyrical"
    sourced = "source /opt/ros/humble/setup.bash && ros2 interface show turtlesim/srv/Kill"
    assert sourced_by(["--home", str(tmp_path), "-c", sourced]) == "humble"
    assert printed(line=f"{sourced} && echo $ROS_DISTRO").endswith("string name\n---\nhumble")
    assert day6("exec", "--home", str(tmp_path), "-c", "echo $ROS_DISTRO").stdout == "lyrical\n"
    done = day6("exec", "--home", str(tmp_path), "-c", "echo $ROS_DISTRO", ROS_DISTRO="rolling")
    assert done.stdout == "rolling\n"


def test_a_bashrc_that_cannot_be_read_decides_nothing(tmp_path: Path) -> None:
    assert sourced_by(["--home", str(tmp_path)]) is None
    (tmp_path / ".bashrc").mkdir()
    assert sourced_by(["--home", str(tmp_path)]) is None
    (tmp_path / ".bashrc").rmdir()
    (tmp_path / ".bashrc").write_bytes(b"\xff\xfe\n. /opt/ros/lyrical/setup.bash\r\n")
    assert sourced_by(["--home", str(tmp_path)]) == "lyrical"


@pytest.mark.skipif(os.name == "nt", reason="where exec would leave the terminal to two of them")
@pytest.mark.parametrize(
    ("words", "again"),
    [
        ([], []),
        (["--distro", "jazzy", "--lang", "zh"], ["--lang", "zh"]),
        (["--distro=jazzy", "--home", "x"], ["--home", "x"]),
        (["--lang", "zh", "learn", "1"], ["--lang", "zh", "learn", "1"]),
    ],
)
def test_a_desktop_starts_again_with_its_own_words(
    words: list[str], again: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    taken: list[tuple[str, list[str], dict[str, str]]] = []
    monkeypatch.setattr(os, "execve", lambda *all: taken.append(all))
    monkeypatch.setattr(sys, "argv", ["/bin/day6-tui", *words])
    monkeypatch.setattr(sys, "orig_argv", ["python", "-P", "/bin/day6-tui", *words])
    start_again("lyrical", {"A": "b"}, None)
    assert taken == [
        (sys.executable, [sys.executable, "-P", "/bin/day6-tui", "--distro", "lyrical", *again], {"A": "b"})
    ]


@pytest.mark.process
def test_an_option_before_a_command_is_for_that_command() -> None:
    remember("kilted")
    assert printed("--distro", "humble") == "humble"
    assert printed() == "kilted"


@pytest.mark.process
@pytest.mark.parametrize("name", ["foxy", "iron", "Humble", "", "../humble"])
def test_a_distribution_that_is_none_of_ours_is_no_choice(name: str) -> None:
    assert printed(ROS_DISTRO=name) == "jazzy"
    remember(name)
    assert printed() == "jazzy"


@pytest.mark.process
@pytest.mark.parametrize(
    "words", [("--distro", "foxy", "exec", "-c", "true"), ("--distro=foxy", "ros2"), ("--distro", "foxy")]
)
def test_a_wrong_name_after_the_option_is_told(words: tuple[str, ...]) -> None:
    done = day6(*words)
    assert done.returncode == 2 and "argument --distro: invalid choice: 'foxy' (choose from " in done.stderr


@pytest.mark.process
def test_every_command_takes_the_same_one(tmp_path: Path) -> None:
    program = tmp_path / "mine.py"
    program.write_text("import os, turtlesim_msgs.msg\nprint(os.environ['ROS_DISTRO'])\n", encoding="utf-8")
    assert day6("--distro", "kilted", "python", str(program)).stdout == "kilted\n"
    assert "turtlesim_msgs/msg/Pose" in day6("--distro", "kilted", "ros2", "interface", "list").stdout
    assert "export ROS_DISTRO=kilted\n" in day6("--distro", "kilted", "env").stdout
    assert day6("python", str(program), ROS_DISTRO="kilted").stdout == "kilted\n"


@pytest.mark.process
def test_an_editor_gets_the_folders_of_the_distribution(tmp_path: Path) -> None:
    day6("--distro", "humble", "env", "--vscode", str(tmp_path))
    day6("--distro", "kilted", "env", "--vscode", str(tmp_path))
    paths = json.loads((tmp_path / ".vscode" / "settings.json").read_text(encoding="utf-8"))[
        "python.analysis.extraPaths"
    ]
    assert [Path(each).name for each in paths] == ["stubs-kilted", "python", "kilted"]
    assert (Path(paths[0]) / "turtlesim_msgs").is_dir() and not (Path(paths[0]) / "turtlesim").exists()
    text = (tmp_path / ".env").read_text(encoding="utf-8")
    assert "python_of/kilted" in Path(text).as_posix() and "python_of/humble" not in Path(text).as_posix()


@pytest.mark.process
def test_what_a_program_starts_belongs_to_the_same_distribution(tmp_path: Path) -> None:
    lines = "import subprocess\nsubprocess.run(['ros2', 'interface', 'package', 'turtlesim_msgs'])\n"
    (tmp_path / "starter.py").write_text(lines, encoding="utf-8")
    done = day6(
        "--distro", "rolling", "exec", "--home", str(tmp_path), "-c", f"unset ROS_DISTRO; python3 {tmp_path}/starter.py"
    )
    assert "turtlesim_msgs/srv/Spawn" in done.stdout.split(), done.stderr


@pytest.mark.process
def test_another_ros_distro_in_a_terminal_changes_the_name_only(tmp_path: Path) -> None:
    """As in real ROS, where the variable says what was sourced and chooses nothing."""
    line = "export ROS_DISTRO=kilted; python3 -c 'import turtlesim.msg; import turtlesim_msgs'"
    said = printed("--distro", "humble", line=line)
    assert said.endswith("ModuleNotFoundError: No module named 'turtlesim_msgs'")


@pytest.mark.process
@pytest.mark.parametrize("name", NAMES)
def test_only_its_own_setup_file_can_be_sourced(name: str) -> None:
    other = "humble" if name != "humble" else "jazzy"
    line = f"unset ROS_DISTRO; source /opt/ros/{other}/setup.bash; source /opt/ros/{name}/setup.bash; which ros2"
    done = day6("--distro", name, "exec", "-c", line)
    assert done.stderr == f"bash: /opt/ros/{other}/setup.bash: No such file or directory\n"
    assert done.stdout == f"/opt/ros/{name}/bin/ros2\n"


@pytest.mark.process
@pytest.mark.parametrize(("language", "said"), [("en", "is humble, not foxy"), ("zh", "是 humble，不是 foxy")])
def test_the_card_of_another_setup_file_names_the_option(language: str, said: str) -> None:
    done = day6(
        "why", "bash: /opt/ros/foxy/setup.bash: No such file or directory", ROS_DISTRO="humble", DAY6_LANG=language
    )
    assert said in done.stdout and "day6-tui --distro" in done.stdout
    assert "source /opt/ros/humble/setup.bash" in done.stdout


@pytest.mark.process
def test_apt_and_doctor_name_it() -> None:
    line = "sudo apt install -y ros-$ROS_DISTRO-desktop; ros2 doctor --report | grep 'distribution name'"
    said = printed("--distro", "humble", line=line)
    assert "ros-humble-desktop is already the newest version (day6-tui stands in for ROS 2 humble)." in said
    assert said.endswith(": humble")


def test_lessons_speak_of_it(in_distribution: Callable[[str], None]) -> None:
    from day6_core.ros import differences

    text = (
        "source /opt/ros/jazzy/setup.bash, not /opt/ros/humble; ros-jazzy-desktop; turtlesim/srv/Spawn; turtlesim.msg"
    )
    in_distribution("humble")
    assert differences.retold(text) == (
        "source /opt/ros/humble/setup.bash, not /opt/ros/jazzy; ros-humble-desktop; turtlesim/srv/Spawn; turtlesim.msg"
    )
    in_distribution("kilted")
    assert differences.retold(text).endswith(
        "kilted/setup.bash, not /opt/ros/humble; ros-kilted-desktop; turtlesim_msgs/srv/Spawn; turtlesim_msgs.msg"
    )


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
def test_every_lesson_can_be_read_in_every_distribution(name: str, in_distribution: Callable[[str], None]) -> None:
    from day6_core.lessons import reading

    in_distribution(name)
    files = sorted(Path(reading.__file__).parent.glob("d*s/*.md"))
    assert len(files) > 30
    for path in files:
        assert reading.read_lesson(path).steps


@pytest.mark.process
def test_the_desktops_of_a_server_have_that_of_the_server(in_distribution: Callable[[str], None]) -> None:
    from day6_tui.web.starting import environment

    in_distribution("humble")
    remember("kilted")
    assert printed(**environment(0)) == "humble"


@pytest.mark.process
def test_tab_offers_the_distributions_and_then_commands() -> None:
    assert day6("complete", "bash", "day6-tui --distro ki").stdout.split() == ["kilted"]
    assert "exec" in day6("complete", "bash", "day6-tui --distro kilted e").stdout.split()
