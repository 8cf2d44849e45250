"""cp, mv, rm, mkdir, touch, tee, sort -o and sed -i on odd cases: said and left behind is what GNU's tools say and leave."""

from __future__ import annotations

import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

gnu = pytest.mark.skipif(
    sys.platform != "linux" or shutil.which("bash") is None, reason="compares with GNU's tools, of version 9 or later"
)

LINES = [
    "cp f f",
    "cp f ./f",
    "cp f d/../f",
    "mv f f",
    "mv d d/e",
    "mv d d",
    "cp f l; cat f; readlink l",
    "cp g l; readlink l; cat f",
    "mv g l; readlink l; cat l; cat f",
    "cp f dangling; echo $?",
    "mv f dangling; readlink dangling; cat dangling",
    "cp d x",
    "cp -r d f",
    "mv d f",
    "cp f x/",
    "cp f d e nothere",
    "cp nope d",
    "mv nope d",
    "cp f nodir/x",
    "mv f nodir/x",
    "cp f g h",
    "mv f g h",
    "mkdir x/f; cp f x",
    "mkdir x/f; mv f x",
    "mkdir -p x/d; mv d x; find . | sort",
    "mkdir -p x/d; echo q > x/d/q; mv d x; find . | sort",
    "mkdir -p x/d; echo q > x/d/q; cp -r d x; find . | sort",
    "echo q > x/d; cp -r d x",
    "echo q > x/d; mv d x",
    "rm d",
    "rm -r .",
    "rm -rf .",
    "rm -r ..",
    "rm -rf ./",
    "rm -r d/.",
    "rm nope",
    "rm -f nope",
    "rm -r dl; find . | sort",
    "rm dl; find . | sort",
    "rm dl/",
    "rm l; cat f",
    "rm -r d f; find . | sort",
    "rm -rf d nope; echo $?; find . | sort",
    "rmdir d",
    "rmdir x; rmdir f; rmdir nope",
    "rmdir dl",
    "mkdir d",
    "mkdir f",
    "mkdir f/a",
    "mkdir -p f/a",
    "mkdir nope/a",
    "mkdir -p a/b/c d; find . | sort",
    "touch nope/a",
    "touch f/a",
    "touch d",
    "touch",
    "mkdir",
    "rm",
    "cp",
    "cp f",
    "mv",
    "mv f",
    "cp -r d new; find new | sort",
    "cp -r d x; find x | sort",
    "cp -r d/ x; find x | sort",
    "mv d new; find . | sort",
    "mv d/ x; find . | sort",
    "cp -a l l2; readlink l2",
    "cp -r l l2; readlink l2",
    "cp l l2; readlink l2; cat l2",
    "cp -r dl dl2; readlink dl2",
    "mv l l2; readlink l2",
    "mv dl x; readlink x/dl",
    "ln f h; cp f h",
    "ln f h; mv f h; find . | sort",
    "cp -n f g; cat g",
    "mv -n f g; cat g; cat f",
    "cp -f f g; cat g",
    "cp -v f g new2; echo $?",
    "cp -v f n",
    "mv -v f n",
    "mv -v f g d",
    "rm -v f",
    "cp d/a .",
    "cp d/a d",
    "cp . x",
    "cp -r x .",
    "mv . x",
    "mv x .",
    "cp f ''",
    "rm ''",
    "mkdir ''",
    "touch ''",
    "cp f d/",
    "cp f new/",
    "mv f new/",
    "mv d new/; find . | sort",
    "cp -u f g; cat g",
    "cp f g x; find x | sort",
    "cp x f d; echo $?; find d | sort",
    "rm -x f",
    "rm -i",
    "tee d",
    "echo x | tee nope/a; echo $?",
    "echo x | tee d; echo $?",
    "echo x | tee f; cat f",
    "echo x | tee -a f; cat f",
    "echo a > d",
    "echo a > nope/x",
    "cat d",
    "sort -o g f; cat g",
    "sort f -o f; cat f",
    "sort -o d f",
    "sort -o nope/x f",
    "sed -i s/f/F/ f; cat f",
    "sed -i s/f/F/ l; cat l; readlink l",
    "sed -i s/f/F/ d",
    "sed -i s/f/F/ nope",
    "sed -i s/f/F/ nope f; cat f",
    "mv l f; cat f; readlink l",
    "mv f l; cat l",
    "cp -r l f; cat f",
    "cp l f",
    "echo n | rm -i f; echo; cat f",
    "echo y | rm -i f; echo; cat f",
    "echo n | cp -i f g; cat g",
    "echo n | mv -i f g; cat g",
    "mkdir -m 700 pr",
    "rm -r d/",
    "rm -r d/sub/../../d",
    "ln -s . self; rm -r self; find . | sort",
    "cp -r d/. x; find x | sort",
    "cp d/* x",
    "mv d/* x; find . | sort",
    "mkdir gone; cd gone; rmdir ../gone; cp /etc/hostname .; mv /etc/nope .; cp -r /etc/nope ./",
]


def make(folder: Path) -> None:
    """Two files, two folders, a link to each, one to nothing."""
    (folder / "d" / "sub").mkdir(parents=True)
    (folder / "x").mkdir()
    for name, text in (("f", "f\n"), ("g", "g\n"), ("d/a", "a\n"), ("d/sub/s", "s\n")):
        (folder / name).write_text(text)
    for name, target in (("l", "f"), ("dangling", "nothing"), ("dl", "d")):
        (folder / name).symlink_to(target)


def tree(folder: Path) -> list[str]:
    """Every path in the folder with its type, mode and content."""
    found = []
    for path in sorted(folder.rglob("*")):
        mode = stat.filemode(path.lstat().st_mode)
        inside = os.readlink(path) if path.is_symlink() else path.read_text() if path.is_file() else ""
        found.append(f"{path.relative_to(folder)} {mode} {inside!r}")
    return found


@pytest.mark.process
@gnu
@pytest.mark.parametrize("line", LINES)
def test_it_says_and_leaves_what_the_real_tool_does(machine: Any, tmp_path: Path, line: str) -> None:
    ours, real = tmp_path / "ours" / "work", tmp_path / "real" / "work"
    for folder in (ours, real):
        folder.mkdir(parents=True)
        make(folder)
    env = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8"}
    expected = subprocess.run(["bash", "-c", line], cwd=real, env=env, capture_output=True, text=True, check=False)
    result = machine.run(f"cd '{ours}'\n{line}")
    assert result.err == expected.stderr.replace("bash: line 1: ", "bash: ")
    assert result.out == expected.stdout
    assert result.status == expected.returncode
    assert tree(ours) == tree(real)


@pytest.mark.parametrize("line", ["rm -rf /", "rm -rf //", "rm -r /.", "rm -rf ~", "rm -rf ~/..", "rm -rf ../.."])
def test_what_is_above_the_home_folder_is_never_removed(machine: Any, line: str) -> None:
    (machine.desk.home / "mine").write_text("mine")
    result = machine.run(f"cd ~\n{line}")
    assert result.status == 1 and ("dangerous" in result.err or "refusing" in result.err)
    assert (machine.desk.home / "mine").read_text() == "mine"


def test_a_folder_is_not_copied_into_itself_without_end(machine: Any) -> None:
    make(machine.desk.home)
    result = machine.run("cd ~; cp -r . x; cp -r d d/sub; cp -r d d")
    assert result.status == 1 and len(result.err.splitlines()) == 3
    assert not list((machine.desk.home / "x").iterdir())


def test_a_copy_has_the_mode_of_the_original_and_a_file_that_is_overwritten_keeps_its_own(machine: Any) -> None:
    home = machine.desk.home
    make(home)
    (home / "f").chmod(0o600)
    (home / "g").chmod(0o640)
    (home / "l").unlink()
    assert machine.run("cd ~; cp f new; cp d/a g; chmod 755 d/a; cp -p d/a kept").status == 0
    modes = [oct((home / name).stat().st_mode & 0o777) for name in ("new", "g", "kept")]
    if sys.platform != "win32":
        assert modes == ["0o600", "0o640", "0o755"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="/dev/full is Linux's")
def test_a_copy_onto_a_full_disk_is_told(machine: Any) -> None:
    make(machine.desk.home)
    result = machine.run("cd ~; cp f /dev/full")
    assert (result.status, result.err) == (1, "cp: error writing '/dev/full': No space left on device\n")
    assert stat.S_ISCHR(os.stat("/dev/full").st_mode)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="/dev/full is Linux's")
@pytest.mark.parametrize("line", ["sort -o /dev/null f", "sed -i s/f/F/ /dev/null", "cp f /dev/null"])
def test_a_device_stays_a_device(machine: Any, line: str) -> None:
    make(machine.desk.home)
    machine.run(f"cd ~; {line}")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def limited(line: str, folder: Path, size: int) -> subprocess.CompletedProcess[str]:
    """Run a line where no file may grow beyond `size` bytes: a full disk that a normal user can have too."""
    resource = pytest.importorskip("resource")
    return subprocess.run(
        [sys.executable, "-m", "day6_tui.main", "exec", "-c", line],
        cwd=folder,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "XDG_DATA_HOME": str(folder.parent / "data")},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)),
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.process
@pytest.mark.parametrize(
    ("line", "says", "status"),
    [
        ("cp big here", "cp: error writing 'here': {}", 1),
        ("sort -o big big big", "sort: write failed: big: {}", 2),
        ("sed -i s/1/11111111/ big", "sed: couldn't flush big: {}", 4),
        ("cat big | tee here > /dev/null", "tee: here: {}", 1),
        ("cat big big > here", "cat: write error: {}", 1),
    ],
)
def test_what_does_not_fit_is_told_and_what_was_there_is_whole(
    tmp_path: Path, line: str, says: str, status: int
) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    text = "".join(f"{number}\n" for number in range(1000, 5000))
    (folder / "big").write_text(text)
    (folder / "here").write_text("old")
    result = limited(line, folder, 15_000)
    assert (result.stderr.rstrip("\n"), result.returncode) == (says.format("File too large"), status)
    assert (folder / "big").read_text() == text
    assert sorted(path.name for path in folder.iterdir()) == ["big", "here"]
