"""Which command lines of the text tools are ours, and that whichever answers, it is what bash and GNU answer."""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.text_tools import is_exactly_ours

LINES = r"""
printf 'a\nb\n' | sed -e 's/a/1/' -e 's/b/2/'; printf 'abc\n' | sed -n 's/b/X/p'; printf 'aaa\n' | sed 's/a/b/2'
printf 'a\n' > q; sed -i -e 's/a/b/' -e 's/b/c/' q; cat q
printf '3 a\n1 b\n2 a\n' | sort -k2,2 -k1,1n; printf '1K\n2M\n' | sort -h; printf 'v1.10\nv1.9\n' | sort -V
seq -s, 1 5; seq -w 8 11; date -d @0 +%Y
mkdir -p d/e; touch d/a.txt d/e/b.py; chmod 600 d/e/b.py; chmod -R 755 d; stat -c %a d/e/b.py
find d -name "*.py" -exec echo {} \; ; find d -print0 | xargs -0 -n1 echo | sort
echo hello > d/a.txt; grep -r --include=*.txt hello d; grep -L hello d/a.txt d/e/b.py; grep -oE '[a-z]+' d/a.txt
printf 'a,b,c\n' | cut -d, -f2-; echo abc | tr a-z A-Z; tail -n +2 d/a.txt; diff <(echo a) <(echo b); echo $?
sed -n '/hel/,$p' d/a.txt; sed 's/\(h\)\(e\)/\2\1/' d/a.txt; sed '1i top' d/a.txt; basename -s .txt d/a.txt
printf 'd/a.txt\nd/e/b.py\n' | while read f; do sed -E 's/(h)(e)/\2\1/' "$f"; echo "$f"; done; seq 100000 | sort -V | head -1
sort nofile; grep x nofile; sed p nofile; echo $?
printf '3\n1\n2\n' > g; { read h; sort -V; } < g; { read h; sort -V; echo $h; cat; } < g; { head -c 3; cat; } < g
while read l; do echo "$l"; sort -V; done < g; while read l; do echo "$l"; stat -c %n g; done < g
cat g | while read l; do echo "$l"; awk 'BEGIN { print "b" }'; done; cat g | while read l; do echo "$l"; sort -V; done
cat g | { read h; awk 'NR == 1 { print; exit }'; echo "$h"; }; yes | awk 'NR == 2 { print; exit }'
seq 100000 | awk 'END { print NR }'
echo abc | grep -o .; touch -d 2020-01-01 t; date -r t +%Y; ls --hyperlink=never d; chmod -v 600 t
cp --parents t d; mv -t d t; ls d
printf 'echo a\r\nls\r\n' > w.sh; bash w.sh 2> /dev/null | od -c; seq 1e2 101
"""


@pytest.mark.process
@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("bash"), reason="compares with GNU's tools and bash")
def test_what_answers_answers_as_the_real_ones(machine: Any, tmp_path: Path) -> None:
    for name in ("real", "here"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "lines.sh").write_text(LINES, encoding="utf-8")
    done = subprocess.run(
        ["bash", "lines.sh"],
        cwd=tmp_path / "real",
        capture_output=True,
        text=True,
        env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"},
    )
    ours = machine.run(f"cd {shlex.quote(str(tmp_path / 'here'))}; export LC_ALL=C.UTF-8; bash lines.sh")
    assert ours.out == done.stdout
    assert ours.err == done.stderr and "sort: cannot read: nofile" in ours.err


@pytest.mark.parametrize(
    "line",
    [
        "grep -in hello a.txt",
        "sed 's/a/b/g' x",
        "sed -n 3p x",
        "sort -r x",
        "head -5 x",
        "cut -d : -f 1 x",
        "grep --color=auto x",
        "ls -la --color=auto",
        "chmod +x a.py",
        "mkdir -p a/b",
        "cp -r a b",
    ],
)
def test_the_usual_lines_cost_no_process(line: str) -> None:
    assert is_exactly_ours(shlex.split(line))


@pytest.mark.parametrize(
    "line",
    [
        "grep 'a*' x",
        "sed -e s/a/b/ -e s/b/c/ x",
        "sed s/a/b/2 x",
        "sort -k2 x",
        "sort -rn x",
        "date -d now",
        "find . -type f",
        "grep -rL a .",
        "head -c 3 x",
        "tr a b c",
        "touch -d now x",
        "chmod u=rwX x",
        "ls -i",
    ],
)
def test_what_ours_might_do_in_another_way_is_the_machines(line: str) -> None:
    assert not is_exactly_ours(shlex.split(line))


TOPIC = "/a std_msgs/msg/Int32"


@pytest.mark.parametrize(
    ("line", "shown"),
    [
        ("topics() { echo 1; echo 1; echo 2; sleep 100; }; topics | uniq", "1\n2\n"),
        (f"ros2 topic pub -r 5 {TOPIC} '{{data: 7}}' > /dev/null & ros2 topic echo --csv {TOPIC} | uniq", "7\n"),
    ],
)
def test_uniq_shows_a_line_when_it_comes(machine: Any, line: str, shown: str) -> None:
    """What has changed is of use now, not when it changes again."""
    program = machine.start(line)
    machine.go(3)
    assert (machine.out.text, program.status) == (shown, None)
