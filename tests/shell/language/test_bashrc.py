"""A .bashrc as Ubuntu writes it and students extend it, the prompt it sets, and earlier lines called back with `!`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.line.recall import NoSuchLine, recalled

UBUNTU = r"""
case $- in
    *i*) ;;
      *) return;;
esac
HISTCONTROL=ignoreboth
shopt -s histappend checkwinsize
[ -x /usr/bin/lesspipe ] && eval "$(SHELL=/bin/sh lesspipe)"
if [ -z "${debian_chroot:-}" ] && [ -r /nowhere/debian_chroot ]; then debian_chroot=$(cat /nowhere/debian_chroot); fi
case "$TERM" in
    xterm-color|*-256color) color_prompt=yes;;
esac
if [ -n "$force" ]; then
    if [ -x /usr/bin/tput ] && tput setaf 1 >&/dev/null; then color_prompt=yes; else color_prompt=; fi
fi
if [ "$color_prompt" = yes ]; then
    PS1='${debian_chroot:+($debian_chroot)}\[\033[01;32m\]\u@\h\[\033[00m\]:\[\033[01;34m\]\w\[\033[00m\]\$ '
else
    PS1='${debian_chroot:+($debian_chroot)}\u@\h:\w\$ '
fi
unset color_prompt force
case "$TERM" in
xterm*|rxvt*) PS1="\[\e]0;${debian_chroot:+($debian_chroot)}\u@\h: \w\a\]$PS1" ;;
*) ;;
esac
test -r ~/.dircolors && eval "$(dircolors -b ~/.dircolors)" || eval "$(dircolors -b)"
alias ls='ls --color=auto'
alias ll='ls -alF'
alias last='echo "$([ $? = 0 ] && echo well || echo badly)" "$(history | tail -n1 | sed -e '\''s/^ *[0-9]* *//'\'')"'
if [ -f ~/.bash_aliases ]; then . ~/.bash_aliases; fi
if ! shopt -oq posix; then
  if true; then . /usr/share/bash-completion/bash_completion; elif false; then . /etc/bash_completion; fi
fi
source /opt/ros/jazzy/setup.bash
source /usr/share/colcon_cd/function/colcon_cd.sh
source /usr/share/colcon_argcomplete/hook/colcon-argcomplete.bash
export ROS_DOMAIN_ID=0 _colcon_cd_root=/opt/ros/jazzy/
"""


def written(machine: Any, text: str) -> Any:
    """A terminal of a student whose .bashrc this is."""
    home: Path = machine.desk.home
    (home / ".bashrc").write_text(text, encoding="utf-8")
    return machine.desk.open_terminal(80, 24)


@pytest.fixture
def student(machine: Any, seat: Any) -> Any:
    """Types in a terminal whose .bashrc is given."""

    def sit(bashrc: str) -> Any:
        seat.terminal = written(machine, bashrc)
        seat.settle()
        return seat

    return sit


def test_ubuntus_bashrc_runs_without_a_word_and_its_aliases_work(student: Any) -> None:
    seat = student(UBUNTU)
    assert seat.look() == "student@day6:~$"
    assert seat.line("false").splitlines()[-1] == "student@day6:~$"
    assert seat.line("last").splitlines()[-2] == "badly last"
    assert seat.line("touch f; ll f | wc -l").splitlines()[-2] == "1"
    assert seat.line("echo $debian_chroot$color_prompt.").splitlines()[-2] == "."


def test_lines_before_a_mistake_in_bashrc_count(student: Any) -> None:
    seat = student('export KEPT=yes\nsource "install/setup.bash\n')
    assert "unexpected EOF while looking for matching `\"'" in seat.look()
    assert seat.line("echo $KEPT").splitlines()[-2] == "yes"


def test_ps1_is_the_prompt(student: Any) -> None:
    seat = student(r"""PS1='[\!] \W$(echo +)\$ '""")
    assert seat.look() == "[1] ~+$"
    assert seat.line("mkdir 'a $HOME'; cd a*").splitlines()[-1] == "[2] a $HOME+$"
    seat.line(r"PS1='\[\e[31m\]\u\n\[\e]0;title\a\]> '")
    assert seat.look().splitlines()[-2:] == ["student", ">"]
    # The cursor stands behind what is seen of the prompt.
    seat.type("abc")
    assert (seat.terminal.screen.cursor.x, seat.look().splitlines()[-1]) == (5, "> abc")


def test_an_alias_can_be_several_commands_and_a_function_is_a_command(student: Any) -> None:
    seat = student(
        "alias both='echo one | cat; echo two'\nsay() { echo \"said $1\"; }\nalias sudo='sudo '\nalias both2='both'\n"
    )
    assert seat.line("both three").splitlines()[-3:-1] == ["one", "two three"]
    assert seat.line("both2").splitlines()[-3:-1] == ["one", "two"]
    assert seat.line("say it; 'both'").splitlines()[-3:-1] == ["said it", "bash: both: command not found"]


def test_colcon_cd_goes_to_a_package(student: Any) -> None:
    seat = student("source /usr/share/colcon_cd/function/colcon_cd.sh")
    seat.line("mkdir -p ros2_ws/src && cd ros2_ws/src && ros2 pkg create p1 > /dev/null 2>&1; cd ..; clear", 1.0)
    seat.wait_prompt()
    seat.line("colcon_cd p1")
    assert seat.wait_prompt().splitlines()[-1] == "student@day6:~/ros2_ws/src/p1$"
    seat.line("colcon_cd p2")
    assert "Could not find package 'p2'" in seat.wait_prompt()


def test_earlier_lines_are_called_back_and_shown_before_they_run(seat: Any) -> None:
    seat.line("echo one two")
    assert seat.line("!!").splitlines()[-3:-1] == ["echo one two", "one two"]
    seat.line("true")
    assert seat.line("!echo; echo !$").splitlines()[-3:-1] == ["one two", "true"]
    assert seat.line("!nope").splitlines()[-2] == "bash: !nope: event not found"
    assert seat.line("echo 'a!!' b! \\!!").splitlines()[-2] == "a!! b! !!"


@pytest.mark.parametrize(
    ("line", "result"),
    [
        ("!2", "ls -l"),
        ("!-1", "ros2 topic list"),
        ("sudo !!", "sudo ros2 topic list"),
        ("!?-l?", "ls -l"),
        ("echo !* !^", "echo topic list topic"),
        ("^list^info", "ros2 topic info"),
        ("if ! true; then echo a != b; fi", "if ! true; then echo a != b; fi"),
        ('echo "!2"', 'echo "ls -l"'),
        ("echo hi!", "echo hi!"),
    ],
)
def test_what_a_line_recalls(line: str, result: str) -> None:
    assert recalled(line, ["cd", "ls -l", "ros2 topic list"]) == result


def test_what_is_not_there_is_told_as_bash_does() -> None:
    for line, message in (("!9", "!9: event not found"), ("^x^y", ":s^x^y: substitution failed")):
        with pytest.raises(NoSuchLine) as problem:
            recalled(line, ["ls"])
        assert str(problem.value) == message
