"""What a lesson's installing commands, the editors and the questions about the machine answer, to the letter."""

from __future__ import annotations

import os
from typing import Any

import pytest

from day6_core.shell.builtins import download

READ = "Reading package lists... Done\n"


@pytest.mark.parametrize(
    ("line", "status", "out", "err"),
    [
        ("apt update", 0, f"{READ}All packages are up to date.\n", ""),
        ("apt-get upgrade -y", 0, f"{READ}All packages are up to date.\n", ""),
        ("sudo -E apt full-upgrade", 0, f"{READ}All packages are up to date.\n", ""),
        ("apt autoremove", 0, f"{READ}All packages are up to date.\n", ""),
        ("apt remove x", 0, f"{READ}Nothing was removed: day6-tui has no packages of its own.\n", ""),
        ("apt purge x", 0, f"{READ}Nothing was removed: day6-tui has no packages of its own.\n", ""),
        ("apt", 1, "", "apt: nothing to do: packages are not managed on this machine\n"),
        ("apt install", 100, "", "E: Invalid operation install\n"),
        ("apt nonsense", 100, "", "E: Invalid operation nonsense\n"),
        ("apt install -y ros-humble-desktop", 0, (f"{READ}ros-humble-desktop is already the newest version "
         "(day6-tui stands in for ROS 2 jazzy).\n"), ""),
        ("apt install python3-colcon-common-extensions", 0,
         f"{READ}python3-colcon-common-extensions is already the newest version.\n", ""),
        ("apt install python3-rosdep", 0, f"{READ}python3-rosdep is already the newest version.\n", ""),
        ("apt install nano cowsay", 0, (f"{READ}nano is already the newest version.\n"
         "cowsay: not needed on this machine; nothing was installed.\n"), ""),
        ("apt install ros-dev-tools", 0, f"{READ}ros-dev-tools is already the newest version (colcon, rosdep).\n", ""),
        ("sudo", 1, "", "usage: sudo COMMAND\n"),
        ("sudo -n echo -n a", 0, "a", ""),
        ("sudo nothing", 127, "", "bash: nothing: command not found\n"),
        ("rosdep init", 0, "rosdep is initialised\n", ""),
        ("rosdep update", 0, "nothing to fetch: day6-tui works offline\n", ""),
        ("rosdep --version", 1, "", "Usage: rosdep [options] <command> <args>\n\nrosdep: error: Please enter a command\n"),
        ("rosdep install --from-paths nowhere", 1, "", "ERROR: Could not find path: HOME/nowhere\n"),
        ("rosdep install --from-paths ros2_ws/src -y", 0, "#All required rosdeps installed successfully\n", ""),
        ("whoami; hostname; uname; uname -a", 0, "student\nday6\nLinux\nLinux day6 day6-tui\n", ""),
        ("id; id -u; id -un; id -G; id -gn", 0,
         "uid=1000(student) gid=1000(student) groups=1000(student)\n1000\nstudent\n1000\nstudent\n", ""),
        ("reset; clear", 0, "", ""),
        ("dircolors -b; lesspipe", 0, "LS_COLORS='';\nexport LS_COLORS\n", ""),
        ("tput", 2, "", "usage: tput [-V] [-S] [-T terminal-type] capname\n"),
        ("tput nope", 4, "", "tput: unknown terminfo capability 'nope'\n"),
        ("tput cols; tput lines; tput colors", 0, "80\n24\n256\n", ""),
        ("LANG=de_DE.UTF-8 LC_ALL= LANGUAGE=de LC_TIME=C locale", 0,
         ('LANG=de_DE.UTF-8\nLANGUAGE=de\nLC_CTYPE="de_DE.UTF-8"\nLC_NUMERIC="de_DE.UTF-8"\nLC_TIME=C\n'
         'LC_COLLATE="de_DE.UTF-8"\nLC_MONETARY="de_DE.UTF-8"\nLC_MESSAGES="de_DE.UTF-8"\nLC_ALL=\n'), ""),
    ],
)  # fmt: skip
def test_the_answer_is(machine: Any, line: str, status: int, out: str, err: str) -> None:
    result = machine.run(line)
    home = str(machine.desk.home)
    assert (result.status, result.out.replace(home, "HOME"), result.err.replace(home, "HOME")) == (status, out, err)


@pytest.mark.parametrize(
    ("line", "sequence"),
    [
        ("tput setaf 1", "\x1b[31m"),
        ("tput setab 2", "\x1b[42m"),
        ("tput setaf 7", "\x1b[37m"),
        ("tput setaf 8", "\x1b[38;5;8m"),
        ("tput setab 200", "\x1b[48;5;200m"),
        ("tput bold", "\x1b[1m"),
        ("tput dim", "\x1b[2m"),
        ("tput smul", "\x1b[4m"),
        ("tput rmul", "\x1b[24m"),
        ("tput rev", "\x1b[7m"),
        ("tput sgr0", "\x1b(B\x1b[m"),
        ("tput civis", "\x1b[?25l"),
        ("tput cnorm", "\x1b[?25h"),
        ("tput clear", "\x1b[H\x1b[2J"),
        ("clear", "\x1b[H\x1b[2J\x1b[3J"),
    ],
)
def test_a_terminal_is_sent_the_sequence(seat: Any, line: str, sequence: str) -> None:
    written: list[str] = []
    before = seat.terminal.write
    seat.terminal.write = lambda text: (written.append(text), before(text))
    seat.line(line)
    assert sequence in "".join(written).split("\x1b[?2004l\r\n", 1)[1].replace("\x1b[?2004h", "")


def test_the_system_tells_its_name(machine: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> None:
    from day6_core.shell.builtins import machine as module

    release = tmp_path / "os-release"
    release.write_text('ID=ubuntu\nPRETTY_NAME="Ubuntu 24.04.1 LTS"\nVERSION_ID="24.04"\nVERSION_CODENAME=noble\n')
    monkeypatch.setattr(module, "_RELEASE", release)
    told = "No LSB modules are available.\n"
    everything = "Distributor ID:\tUbuntu\nDescription:\tUbuntu 24.04.1 LTS\nRelease:\t24.04\nCodename:\tnoble\n"
    assert machine.run("lsb_release -a") == (0, everything, told)
    assert machine.run("lsb_release") == (0, everything, told)
    assert machine.run("lsb_release -cs") == (0, "noble\n", "")
    assert machine.run("lsb_release -d") == (0, "Description:\tUbuntu 24.04.1 LTS\n", "")
    assert machine.run("lsb_release -sir") == (0, "Ubuntu\n24.04\n", "")
    monkeypatch.setattr(os, "cpu_count", lambda: None)
    assert machine.run("nproc").out == "1\n"


def test_our_own_notes_are_in_the_language_of_the_terminal(machine: Any) -> None:
    machine.run("export DAY6_LANG=zh")
    out = machine.run("sudo apt install ros-jazzy-turtlesim ros-jazzy-nav2-bringup nothing").out
    assert "is already the newest version (这里由 day6-tui 代替 ROS 2 jazzy)" in out
    assert "ros-jazzy-nav2-bringup: day6-tui 里没有它" in out and "nothing: 这台机器不需要它" in out
    assert machine.run("ros2 --version").err == "说明：真正安装的 ros2 没有 --version，它只会打印用法\n"
    assert machine.run("rosdep update").out == "不用下载：day6-tui 不需要网络\n"


@pytest.mark.parametrize("language", ["en", "zh"])
def test_help_names_every_command_once(machine: Any, language: str) -> None:
    from day6_core.shell.commands import command_names

    out = machine.run(f"DAY6_LANG={language} help").out
    words = out.replace(",", " ").replace(";", " ").split()
    assert all(name in words for name in command_names() if name.isalpha())
    assert "{others}" not in out


ANSWERS = {
    "ok": download.Response(200, "OK", "text 你\n".encode(), ""),
    "gone": download.Response(404, "Not Found", b"nothing\n", ""),
    "edge": download.Response(400, "Bad Request", b"bad\n", ""),
    "moved": download.Response(399, "Odd", b"odd\n", ""),
    "down": download.Response(0, "", b"", "Connection refused"),
}


@pytest.fixture
def net(monkeypatch: pytest.MonkeyPatch) -> None:
    async def fetch(session: Any, url: str) -> Any:
        return ANSWERS[url.rpartition("/")[2].partition(".")[0]]

    monkeypatch.setattr(download, "_fetch", fetch)


@pytest.mark.usefixtures("net")
@pytest.mark.parametrize(
    ("line", "status", "out", "err"),
    [
        ("curl http://h/ok.py", 0, "text 你\n", ""),
        ("curl h/ok.py -o f; cat f", 0, "text 你\n", ""),
        ("curl -O https://h/a/ok.py; cat ok.py", 0, "text 你\n", ""),
        ("curl --output f h/ok; cat f", 0, "text 你\n", ""),
        ("curl h/ok h/ok", 0, "text 你\ntext 你\n", ""),
        ("curl h/gone", 0, "nothing\n", ""),
        ("curl -f h/gone", 22, "", "curl: (22) The requested URL returned error: 404\n"),
        ("curl --fail h/edge", 22, "", "curl: (22) The requested URL returned error: 400\n"),
        ("curl -f h/moved", 0, "odd\n", ""),
        ("curl -sf h/gone", 22, "", ""),
        ("curl -sSf h/gone", 22, "", "curl: (22) The requested URL returned error: 404\n"),
        ("curl h/down", 7, "", "curl: (7) Failed to connect to h: Connection refused\n"),
        ("curl ftp://h/ok", 1, "", 'curl: (1) Protocol "ftp" not supported\n'),
        ("curl", 2, "", "curl: (2) no URL specified\n"),
        ("curl -Z h", 2, "", "curl: invalid option -- 'Z'\ncurl: try 'curl --help' for more information\n"),
        ("curl -o no/where h/ok", 23, "",
         "curl: (23) Failure writing output to destination: no/where: No such file or directory\n"),
        ("wget -q h/ok.py; cat ok.py", 0, "text 你\n", ""),
        ("wget -q h/ok.py -O -", 0, "text 你\n", ""),
        ("wget -qO f h/ok; cat f", 0, "text 你\n", ""),
        ("mkdir d; wget -q -P d h/ok.py; cat d/ok.py", 0, "text 你\n", ""),
        ("wget -q h/gone", 8, "", ""),
        ("wget -q h/edge", 8, "", ""),
        ("wget -q h/moved.py; cat moved.py", 0, "odd\n", ""),
        ("wget -q h/down", 4, "", ""),
        ("wget", 1, "", "wget: missing URL\nUsage: wget [OPTION]... [URL]...\n"),
        ("wget -Z h", 2, "", "wget: invalid option -- 'Z'\nTry 'wget --help' for more information.\n"),
        ("wget ftp://h/ok", 1, "", "ftp://h/ok: Unsupported scheme.\n"),
        ("wget -q -O no/where h/ok", 3, "", "no/where: No such file or directory\n"),
        ("wget --quiet --output-document=f h/ok h/ok; cat f", 0, "text 你\n", ""),
    ],
)  # fmt: skip
def test_wget_and_curl_answer_as_the_real_ones(machine: Any, line: str, status: int, out: str, err: str) -> None:
    assert machine.run(line) == (status, out, err)


@pytest.mark.usefixtures("net")
def test_wget_tells_what_it_does(machine: Any) -> None:
    said = machine.run("wget h/ok.py").err.splitlines()
    assert said[0].startswith("--20") and said[0].endswith("--  http://h/ok.py")
    assert said[1] == "HTTP request sent, awaiting response... 200 OK"
    assert said[2] == "Saving to: ‘ok.py’"
    assert said[4].endswith(" - ‘ok.py’ saved [9]")
    assert "ERROR 404: Not Found." in machine.run("wget h/gone").err
    assert machine.run("wget h/down").err.splitlines()[-1] == "failed: Connection refused."


@pytest.mark.usefixtures("net")
@pytest.mark.parametrize(("command", "status"), [("wget -q", 4), ("curl", 6), ("curl -s", 6)])
def test_a_host_that_nobody_knows(machine: Any, monkeypatch: pytest.MonkeyPatch, command: str, status: int) -> None:
    unknown = download.Response(0, "", b"", "x", unknown_host=True)
    monkeypatch.setitem(ANSWERS, "ok", unknown)
    err = "wget: unable to resolve host address ‘h’\n" if status == 4 else "curl: (6) Could not resolve host: h\n"
    assert machine.run(f"{command} h/ok") == (status, "", "" if "-s" in command else err)


@pytest.mark.parametrize("name", ["nano", "vim", "vi", "gedit", "code", "mousepad", "gnome-text-editor"])
def test_an_editor_stays_until_its_window_is_closed(machine: Any, name: str) -> None:
    program = machine.start(f"{name} -w +3 ros2_ws/new.py")
    (window,) = machine.desk.display.windows
    assert (window.kind, window.title) == ("editor", name)
    assert window.model.folder == machine.desk.home / "ros2_ws"
    assert window.model.file.path == machine.desk.home / "ros2_ws" / "new.py"
    assert program.status is None
    window.close_by_user()
    machine.go()
    assert program.status is not None


def test_an_editor_of_a_folder_shows_the_folder(machine: Any) -> None:
    machine.start("code .")
    assert machine.desk.display.windows[0].model.folder == machine.desk.home
    assert machine.desk.display.windows[0].model.file is None


def test_what_cannot_be_edited_is_told(machine: Any) -> None:
    machine.run("printf '\\xff' > bytes")
    result = machine.run("gedit bytes")
    assert (result.status, result.err) == (1, f"gedit: {machine.desk.home}/bytes: not UTF-8 text (byte 0)\n")
