"""The language of the shell: what a line means, checked against bash 5.2."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.language.arithmetic import evaluate

SAME_AS_BASH = [
    'for v in x "$((1 +))"; do\n  echo $v\ndone\necho $LINENO\nif true; then\n  echo $((1/0))\n\nfi\necho $LINENO',
    "f() { echo $((1/0)); }\n{\n  f\n  echo no\n}\necho $LINENO",
    'echo "a\nb" $LINENO\necho a "b\n" $LINENO; x="a\nb" ; echo $LINENO',
    "echo hi",
    "echo a   b 'c   d' \"e   f\"",
    "echo -n a; echo b",
    "echo -e 'a\\tb\\n\\x41\\0101'",
    "X=1; echo $X ${X} \"$X\" '$X' $XX ${XX:-none} ${X:+set} ${#X}",
    "X='a  b'; echo $X; echo \"$X\"; set -- $X; echo $#",
    "true && echo yes || echo no; false && echo yes || echo no",
    "! true; echo $?; ! false; echo $?",
    "echo one; echo two # comment; echo three",
    "echo a#b '#c'",
    "echo {a,b}{1..3} x{,y} {not} {1..1}",
    'echo "{a,b}" {a,b',
    "echo $((1 + 2 * 3)) $(( (1+2)*3 )) $((7/2)) $((-7/2)) $((2**10)) $((5 % 3)) $((1<2)) $((3==3 && 1))",
    "X=5; echo $((X + 1)) $(($X * 2))",
    'echo $(echo a; echo b) "$(echo a; echo b)" `echo c`',
    'echo "$(echo "inner $(echo deep)")"',
    "for i in 1 2 3; do echo n$i; done",
    "for i in 1 2 3 4; do if [ $i = 3 ]; then break; fi; echo $i; done; echo after $i",
    "for i in 1 2 3; do [ $i = 2 ] && continue; echo $i; done",
    "i=0; while [ $i -lt 3 ]; do echo $i; i=$((i+1)); done",
    "i=0; until [ $i -ge 2 ]; do echo $i; i=$((i+1)); done",
    "if false; then echo a; elif true; then echo b; else echo c; fi",
    '(X=2; cd /; echo $X; pwd); echo "[$X]"',
    "{ echo a; echo b; } | wc -l",
    'echo a b c | { read x y; echo "$y-$x"; }',
    "cat <<E\nhello $((1+1))\n  two\nE",
    "cat <<'E'\n$X `x`\nE",
    "cat <<-E\n\ttabbed\n\tE",
    "cat <<< word",
    "echo hi > f; cat f; echo more >> f; cat < f; wc -l < f",
    "ls nothere 2> e; wc -l < e; echo x 2>&1 | cat; (echo o; echo e >&2) 2>/dev/null",
    "echo to-err >&2 2>/dev/null; echo both &> f; cat f",
    "touch b.py a.py .hidden; echo *.py; echo '*.py' \"*\" nothing*; echo a.p[xy]",
    'echo ~/x "~" a~',
    'A=1 B=2 printenv A; echo "[$A]"',
    "export A=1; B=2; printenv A B; echo $?",
    'echo a\\ b \\$X "\\$X \\\\ \\"q\\""',
    "echo a \\\n b",
    "x=$(false); echo $?",
    "exit 3; echo no",
    "(exit 4); echo $?",
    "sh -c 'echo $0 $1' name one",
    'set -- a \'b c\'; for x in "$@"; do echo "<$x>"; done; echo "$*" $#; shift; echo $1',
    "f=dir/name.tar.gz; echo ${f%.gz} ${f%%.*} ${f#*/} ${f##*/}",
    "printf '%s-%d|%5.2f\\n' a 3 2.5 b 4 1",
    "test -z '' && echo empty; [ 3 -gt 2 ] && echo gt; [ a != b ] && echo ne; [ -e /nowhere ] || echo gone",
    "seq 3; seq 2 2 6",
    "printf 'b\\na\\nb\\n' | sort | uniq -c",
    "printf 'a\\nb\\nc\\n' | head -2; printf 'a\\nb\\nc\\n' | tail -n 1; printf 'a\\nb\\nc\\n' | tail -n +2",
    "printf 'one\\ntwo\\nthree\\n' | grep -n t; printf 'one\\ntwo\\n' | grep -v one; echo $?; echo x | grep y; echo $?",
    "printf 'one\\ntwo\\nONE\\n' | grep -ic one; printf 'ab ab\\n' | grep -o 'a.'; printf 'a.b\\naxb\\n' | grep -F a.b",
    "printf 'a\\nb\\nc\\nd\\n' | grep -A1 b; printf '1\\n2\\n3\\n' | grep -E '1|3'; printf 'a+b\\n' | grep 'a+b'",
    "basename /a/b.py .py; dirname /a/b.py",
    "echo a | cat - | cat; echo $?",
    "false | true; echo $?; true | false; echo $?",
    "wait; echo $?",
    "set -e; false; echo no",
    "set -e; if false; then :; fi; false || true; echo yes",
    "eval 'echo a; echo b'",
    'cd /; cd - > /dev/null; basename "$PWD"',
    "echo 'X=7' > rc; . ./rc; echo $X; echo 'return 5' > r2; source r2; echo $?",
    "type cd; command -v nothing; echo $?",
    "echo \"a'b\" 'c\"d'",
    "echo ${X:=new}; echo $X",
    "echo 你好 | wc -m",
    "mkdir -p a/b; touch a/b/c; ls a a/b; rm -r a; ls",
    "echo $'",
]


MORE_AS_IN_BASH = [
    'for f in a.py b.txt "c d" x; do case $f in *.py) echo py;; *.txt|"c d") echo other;; *) echo "no $f";; esac; done',
    (
        "case a in (a) echo 1;& b) echo 2;; c) echo 3;; esac; case x in y) ;; esac; echo $?; "
        "case x in x) false;; esac; echo $?"
    ),
    (
        "case a in a) echo 1;;& [a-c]) echo 2;; *) echo 3; esac; case '*' in \\*) echo star;; "
        "esac; case ab in 'a*') echo no;; esac"
    ),
    "case $- in\n  *i*) echo interactive;;\n  *) echo script ;;\nesac\necho $(case x in x) echo inner;; esac)",
    'f() { echo "$1-$#"; return 3; }; f a b; echo $?; f; function g { echo g; }; g; h () (cd /; pwd); h; pwd | wc -l',
    'f() { local x=1 y; y=2; echo $x$y; }; x=0; f; echo "$x[$y]"; f() { x=9; }; f; echo $x',
    "f() { if [ $1 -gt 0 ]; then echo $1; f $(($1-1)); fi; }; f 3; f() { echo out; } > file; f; cat file",
    "f() { echo a; echo b >&2; }; f 2>/dev/null | cat; type f | head -1; unset -f f; f 2>/dev/null; echo $?",
    "f() { for i in 1 2 3; do [ $i = 2 ] && return 5; echo $i; done; }; f || echo $?; f && echo no; echo done",
    '[[ a == a ]] && echo 1; [[ abc == a* ]] && echo 2; [[ abc == "a*" ]] || echo 3; [[ -z "" && -n x ]] && echo 4',
    "[[ 3 -gt 2 || x == y ]] && echo 1; [[ ! -e /nowhere ]] && echo 2; [[ ( a == b || a == a ) && b < c ]] && echo 3",
    "x='a b'; [[ $x == 'a b' ]] && echo 1; [[ $x ]] && echo 2; [[ $nothing ]] || echo 3; [[ -d / && -f / ]]; echo $?",
    (
        "[[ turtle12 =~ ^[a-z]+([0-9]+)$ ]] && echo yes; [[ abc =~ b ]] && echo 2; "
        "[[ a.c =~ 'a.c' ]] && echo 3; [[ abc =~ 'a.c' ]]; echo $?"
    ),
    "[[ 5 -lt 10 ]] && echo less; [[ 5 < 10 ]] || echo texts; x=4; [[ x -eq 4 ]] && echo sum; [[ a != b ]]; echo $?",
    "((x = 5)); echo $x $?; ((x == 5)) && echo yes; ((x > 9)); echo $?; ((x++)); ((x += 2)); echo $x; ((0)); echo $?",
    "for ((i = 0; i < 3; i++)); do echo $i; done; for ((;;)); do break; done; echo $i",
    "for ((i=0;i<4;i++)) do ((i==2)) && continue; echo $i; done; i=5; while ((i-- > 3)); do echo w$i; done",
    "echo $((1 ? 2 : 3)) $((0 && (x=1))) $x $((x = 4, x * 2))",
    "echo $((0x1f)) $((010)) $((2#101)) $((1 << 4 | 1)) $((~0)) $((!5))",
    (
        "x=3; y=x; "
        "echo $((y + 1)) $((x++ + ++x)) $x $(( (1+(2)) )) $((-x)) $(($x*2)) ${#x} $(($(echo 2)+${x})); echo $((2**3**0))"
    ),
    "n=0; printf 'a b\\nc  d\\n' > f; while read -r one two; do n=$((n+1)); echo \"$n:$one:$two\"; done < f; echo $n",
    (
        "printf 'a,b,c\\n' | while IFS=, read x y; do echo \"$x|$y\"; done; "
        "printf 'no end' | { read x; echo \"$? $x\"; }; read x < /dev/null; echo $?"
    ),
    (
        "IFS=: read a b c <<< 'x:y:z:w'; echo \"$a $b $c\"; read -r l <<< 'a\\b'; echo \"$l\"; "
        "read l <<< '  sp  '; echo \"[$l]\""
    ),
    (
        "for i in {1..3} {a..c} {3..1}; do printf '%s ' $i; done; echo; for i in; do echo no; "
        "done; for x in a b; do :; done; echo $x"
    ),
    (
        "x=hello_world; "
        "echo ${x/o/0} ${x//o/0} ${x/#hell/H} ${x/%ld/LD} ${x//_} ${x^} ${x^^} ${x:1:3} ${x:6} ${x: -3} ${x:0:-2}"
    ),
    'x=Abc; echo ${x,} ${x,,}; y=x; echo ${!y}; echo ${z:-${x:-deep}} "${z:-a b}" ${x:+($x)} "${x:+($x)}" ${#z}',
    'x=/a/b/c.tar.gz; echo ${x##*/} ${x%/*} ${x%%.*} "${x%\'.gz\'}" ${x#*/}; p=*.gz; echo ${x%$p} "${x%"$p"}"',
    "echo $'a\\tb\\n\\'q\\' \\x41\\101\\u4f60' | cat; echo $'x'y",
    "(echo a; (echo b)); ((echo c); (echo d)); x=$( (echo e) ); echo $x; echo $(( $(echo 2) + 1 ))",
    (
        "if [ -f ~/.none ]; then . ~/.none; fi; [ -x /usr/none ] && echo no; "
        "test -r /none && a || echo b; ! [ a = b ]; echo $?"
    ),
    (
        "x=1\nshopt -s histappend; shopt -q histappend; echo $?; shopt -oq posix; echo $?; set -u; "
        "(echo $nothing) 2>/dev/null; echo $?"
    ),
    (
        "declare -i n=3+4; echo $n; declare -x V=7; printenv V; declare w=1; echo $w; "
        "readonly r=2; echo $r; let 'a = 3 * 2' b=a+1; echo $a $b; let 0; echo $?"
    ),
    (
        'export A=1 B; A+=2; echo $A; x=a; x+=b; echo $x; echo ${x}c${x}; f() { echo "$@" $*; }; '
        "f 'a b' c; set -- ; echo \"[$*]\""
    ),
    "trap 'echo bye' TERM; umask 022; echo $?; true; echo $? $$ | wc -w; false; echo $?; sleep 0 & wait $!; echo $?",
    "echo `echo \\`echo deep\\` \\$HOME | wc -w`; echo \"`echo 'in quotes'`\" `echo a\\\\b`",
    "cat <<A; cat <<B\none\nA\ntwo $((1+1))\nB\necho three",
    'while true; do\n  read l || break\n  echo "<$l>"\ndone <<E\none\ntwo\nE',
    'x=$(cat <<E\nin $HOME\nE\n); echo "$x" | wc -l; if true; then cat <<E; fi\nbody\nE',
    'function hello() {\n  # comment\n  local who=${1:-you}\n  echo "hello $who"\n}\nhello; hello me',
    "test 1 -lt 2 -a 2 -lt 3 && echo and; [ a -nt b ]; echo $?; touch a; [ a -ef ./a ] && echo same; [ -h a ]; echo $?",
    (
        "until false; do break; done; echo $?; if ! grep -q x /dev/null; then echo none; fi; "
        "echo a && { echo b; } || echo c"
    ),
    "echo {1..10..3} {a,b{c,d}} pre{1,2}post; mkdir -p pkg/{src,launch,config}; ls pkg",
    'x=\'1 2\'; for i in $x "$x"; do echo "<$i>"; done; for i in "$@"; do echo no; done; echo ~root | wc -l',
]


@pytest.mark.process
@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash to compare with")
@pytest.mark.parametrize("line", SAME_AS_BASH[:-1] + MORE_AS_IN_BASH)
def test_a_line_means_what_it_means_in_bash(machine: Any, line: str, tmp_path: Path) -> None:
    home = tmp_path / "home"
    real_home = tmp_path / "real" / "home"
    real_home.mkdir(parents=True)
    real = subprocess.run(
        ["bash", "-c", line], cwd=real_home, env={"PATH": "/usr/bin:/bin", "HOME": str(real_home), "LC_ALL": "C.UTF-8"},
        capture_output=True, text=True, timeout=300, check=False, stdin=subprocess.DEVNULL,
    )  # fmt: skip
    (home / "ros2_ws" / "src").rmdir()
    (home / "ros2_ws").rmdir()
    ours = machine.run(line)
    assert ours.out.replace(str(home), "HOME") == real.stdout.replace(str(real_home), "HOME")
    assert ours.status == real.returncode


@pytest.mark.parametrize(
    ("line", "message", "status"),
    [
        ("foo", "bash: foo: command not found", 127),
        ("rso2 topic list", "bash: rso2: command not found", 127),
        ("| wc", "bash: syntax error near unexpected token `|'", 2),
        ("echo a | | wc", "bash: syntax error near unexpected token `|'", 2),
        ("echo a && && b", "bash: syntax error near unexpected token `&&'", 2),
        ("echo )", "bash: syntax error near unexpected token `)'", 2),
        ("ls >", "bash: syntax error near unexpected token `newline'", 2),
        ("do x", "bash: syntax error near unexpected token `do'", 2),
        ("echo 'a", "bash: unexpected EOF while looking for matching `''", 2),
        ("cd nowhere", "bash: cd: nowhere: No such file or directory", 1),
        ("touch f; cd f", "bash: cd: f: Not a directory", 1),
        ("cd a b", "bash: cd: too many arguments", 1),
        ("cat < nowhere", "bash: nowhere: No such file or directory", 1),
        ("echo x > no/where", "bash: no/where: No such file or directory", 1),
        ("echo x > ros2_ws", "bash: ros2_ws: Is a directory", 1),
        ("./nowhere", "bash: ./nowhere: No such file or directory", 127),
        ("./ros2_ws", "bash: ./ros2_ws: Is a directory", 126),
        ("touch x.py; ./x.py", "bash: ./x.py: Permission denied", 126),
        ("source nowhere", "bash: nowhere: No such file or directory", 1),
        ("kill %3", "bash: kill: %3: no such job", 1),
        ("kill 99999", "bash: kill: (99999) - No such process", 1),
        ("kill abc", "bash: kill: abc: arguments must be process or job IDs", 1),
        ("fg", "bash: fg: current: no such job", 1),
        ("export 1a=2", "bash: export: `1a=2': not a valid identifier", 1),
        ("cat nowhere", "cat: nowhere: No such file or directory", 1),
        ("cat ros2_ws", "cat: ros2_ws: Is a directory", 1),
        ("ls nowhere", "ls: cannot access 'nowhere': No such file or directory", 2),
        ("ls -%", "ls: invalid option -- '%'\nTry 'ls --help' for more information.", 2),
        ("mkdir ros2_ws", "mkdir: cannot create directory ‘ros2_ws’: File exists", 1),
        ("rm nowhere", "rm: cannot remove 'nowhere': No such file or directory", 1),
        ("rm ros2_ws", "rm: cannot remove 'ros2_ws': Is a directory", 1),
        ("cp ros2_ws x", "cp: -r not specified; omitting directory 'ros2_ws'", 1),
        ("mv nowhere x", "mv: cannot stat 'nowhere': No such file or directory", 1),
        ("sleep x", "sleep: invalid time interval ‘x’\nTry 'sleep --help' for more information.", 1),
        ("grep", "Usage: grep [OPTION]... PATTERNS [FILE]...\nTry 'grep --help' for more information.", 2),
        ("grep x nowhere", "grep: nowhere: No such file or directory", 2),
        ("timeout 5", "Try 'timeout --help' for more information.", 125),
        ("[ 1 -eq x ]", "bash: [: x: integer expression expected", 2),
        ("[ 1", "bash: [: missing `]'", 2),
        ("echo $((1/0))", 'bash: 1/0: division by 0 (error token is "0")', 1),
        ("echo ${a b}", "bash: ${a b}: bad substitution", 1),
    ],
)
def test_wrong_input_is_answered_in_bashs_words(machine: Any, line: str, message: str, status: int) -> None:
    if os.name == "nt" and line.endswith("./x.py"):
        pytest.skip("files have no mode there that forbids to run them")
    result = machine.run(line)
    assert result.err.strip() == message
    assert result.status == status


def test_a_file_that_sources_itself_ends_with_a_message(machine: Any) -> None:
    result = machine.run("echo 'source ./loop' > loop; source ./loop")
    assert result.err == "bash: source: maximum nesting level exceeded (100)\n"


def test_a_script_that_runs_itself_ends_with_a_message(machine: Any) -> None:
    result = machine.run("echo 'bash bomb' > bomb; bash bomb")
    assert result.err == "bash: maximum nesting level exceeded (100)\n"


def test_a_machine_full_of_programs_says_so(machine: Any) -> None:
    result = machine.run("for i in {1..1100}; do sleep 1000 & done")
    assert result.err.splitlines()[0] == "bash: fork: Resource temporarily unavailable"


@pytest.mark.parametrize(
    ("source", "value"),
    [("1+1", 2), ("2+3*4", 14), ("(2+3)*4", 20), ("-7%3", -1), ("1<<4|1", 17), ("!0", 1), ("~0", -1), ("x+1", 4)],
)
def test_arithmetic(source: str, value: int) -> None:
    assert evaluate(source, {"x": "3"}) == value


@pytest.mark.parametrize("source", ["1+", "1 2", "(1", "@"])
def test_what_is_no_sum_is_an_error(source: str) -> None:
    with pytest.raises(ValueError, match=r"syntax error|operand|missing"):
        evaluate(source, {})


def test_time_tells_how_long_a_pipeline_took_by_the_clock_of_the_machine(machine: Any) -> None:
    done = machine.run("time sleep 61.5 | cat; echo $?; ! time false; echo $?", seconds=70.0)
    assert done.out == "0\n0\n"
    first, second = done.err.strip("\n").split("\n\n")
    assert [line.split("\t")[0] for line in first.splitlines()] == ["real", "user", "sys"]
    assert first.startswith("real\t1m1.5") and second.startswith("real\t0m0.0")


def test_at_the_prompt_a_word_without_a_value_costs_the_rest_of_its_line_only(seat: Any) -> None:
    screen = seat.line("echo ${name:?who are you} || echo not; echo this")
    assert screen.split("\n")[1:] == ["bash: name: who are you", "student@day6:~$"]
    seat.line("clear")
    screen = seat.line("f() { echo $((1/0)); echo nor; }; for i in 1 2; do f; done; f")
    assert screen.split("\n")[1:] == ['bash: 1/0: division by 0 (error token is "0")', "student@day6:~$"]
    assert seat.line("echo $?").split("\n")[-2:] == ["1", "student@day6:~$"]
    assert "unbound" in seat.line("set -u; echo $nothing") and seat.terminal.idle
