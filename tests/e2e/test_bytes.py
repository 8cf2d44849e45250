"""Bytes that are not UTF-8 pass through the shell as they are: in files, names, pipes, scripts and arguments."""

from __future__ import annotations

import shutil
import sys
from typing import TYPE_CHECKING

import pytest

from tests.e2e.place import DAY6
from tests.support.waiting import run

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = [
    pytest.mark.person,
    pytest.mark.skipif(sys.platform != "linux", reason="elsewhere names of files are Unicode"),
]

BASH = shutil.which("bash")

SCRIPT = (
    rb"""
echo $'\xff\xe4\xb8\xad\377' $'\u00ff' $'\xe4''\xb8'
printf '\xff\377\n'
echo -e '\xff' '\u00ff'
touch $'b\xff'
ls
echo b*
echo hi > $'b\xff'
cat b*
cp b* $'c\xfe'
cat $'c\xfe'
mv $'c\xfe' $'e\xfd'; ls | cat
cat < s
echo "$(cat s)"
python3 -c 'import sys; sys.stdout.buffer.write(b"\xff\n")' | cat
python3 -c 'import sys; sys.stdout.buffer.write(b"\xfe\n")' > f; cat f
python3 -c 'import sys; print(ascii(sys.stdin.buffer.read()))' < s
cat s | python3 -c 'import sys; print(ascii(sys.stdin.buffer.read()))'
python3 -c 'import sys; print(ascii(sys.argv[1]))' $'\xff'
tail -n 1 s; sed s/e/E/ s; sort s; cut -c 1-9 s; tr e E < s; tee u < s; cat u; wc -c s; wc s; wc -m s; uniq s
while read -r x; do echo "$x"; done < s
read -r y <<< $'\xff'; echo "$y"
x=$'\xff'; echo ${#x} "${x/$'\xff'/z}"
cat <<E
$x
E
export x; python3 -c 'import os; print(os.environb[b"x"])'
mkdir $'d\xff'; cd $'d\xff'; pwd | sed 's/.*\///'; cd ..; find . -name 'd*'
. ./s; bash s
echo """
    b"\xff\xfe\nrm b* e*; ls\n"
)


def test_a_script_with_bad_bytes_does_what_bash_does_with_it(place: Place) -> None:
    if BASH is None:
        pytest.skip("no bash to compare with")
    outputs = []
    for command in ([BASH], [*DAY6, "exec", "--home", str(place.home)]):
        for way in ("stdin", "file"):
            shutil.rmtree(place.work)
            place.work.mkdir()
            (place.work / "s").write_bytes(b"echo \xff\n")
            script = place.work.parent / "script"
            script.write_bytes(SCRIPT)
            done = run(
                [*command, *([str(script)] if way == "file" else [])],
                SCRIPT if way == "stdin" else b"",
                cwd=place.work,
                env=place.variables(LC_ALL="C.UTF-8"),  # how many characters bytes are depends on it
                text=False,
            )
            outputs.append((done.stdout + done.stderr).split(b"\n"))
    assert outputs[2] == outputs[0]
    assert outputs[3] == outputs[1]


def test_standard_input_and_the_commands_of_exec_keep_their_bytes(place: Place) -> None:
    every = bytes(range(1, 256)) * 3 + b"\r\n\xff"
    for commands, wanted in ((b"cat", every), (b"echo \xff", b"\xff\n"), (b"cat | cat > f; cat f", every)):
        done = run(
            [*map(str.encode, DAY6), b"exec", b"--home", bytes(place.home), b"-c", commands],
            every,
            cwd=place.work,
            env=place.variables(),
            text=False,
        )
        assert (done.stdout, done.stderr) == (wanted, b"")


def test_a_name_that_is_not_utf8_is_completed_shown_and_removed_on_the_desktop(place: Place) -> None:
    place.home_file("x", "")
    with open(bytes(place.home) + b"/name\xff.txt", "wb") as file:
        file.write(b"inside \xff here\n")
    with place.desktop("--scene", "empty", columns=120) as desk:
        desk.wait("$")
        desk.send("cat na\t")
        desk.wait("cat name")
        desk.press("Enter")
        desk.wait_lines("inside \ufffd here")
        desk.send("rm -v na\t\r")
        desk.wait("removed")
        desk.line("echo $((6*7))")
        desk.wait_lines("42")
    assert [path.name for path in place.home.glob("na*")] == []
