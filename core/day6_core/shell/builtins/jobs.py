"""jobs, fg, bg, wait, kill, disown, ps, pkill, killall."""

from __future__ import annotations

from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.signals import NUMBERS
from day6_core.shell.builtins.options import complain_as_shell
from day6_core.shell.language.control_flow import Interrupted
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.jobs import Job
from day6_core.shell.language.redirection import Streams


async def jobs(session: Session) -> int:
    shell = shell_of(session)
    options = "".join(word[1:] for word in session.argv[1:] if word.startswith("-"))
    table = shell.jobs if shell.jobs.jobs or shell.outer_jobs is None else shell.outer_jobs
    for job in table.ordered():
        if "p" in options:
            session.print(job.programs[0].pid)
        elif "l" in options:
            line = table.line(job)
            mark_end = line.index("]") + 2
            session.print(f"{line[:mark_end]} {job.programs[0].pid} {line[mark_end:].lstrip()}")
        else:
            session.print(table.line(job))
    shell.jobs.take_finished()
    return 0


def _job(session: Session, spec: str) -> Job | None:
    shell = shell_of(session)
    job = shell.jobs.find(spec if spec.startswith("%") else f"%{spec}")
    if job is None:
        complain_as_shell(session, f"{'current' if spec == '%+' else spec}: no such job")
    return job


async def fg(session: Session) -> int:
    shell = shell_of(session)
    job = _job(session, session.argv[1] if len(session.argv) > 1 else "%+")
    if job is None:
        return 1
    if job.finished:
        shell.jobs.remove(job)
        complain_as_shell(session, "job has terminated")
        return 1
    shell.jobs.remove(job)
    shell.jobs.add(job)
    try:
        return await shell.resume_in_front(job, Streams(session.stdin, session.stdout, session.stderr))
    except Interrupted as end:
        shell_of(session).wanted[session] = end
        return shell.status


async def bg(session: Session) -> int:
    shell = shell_of(session)
    job = _job(session, session.argv[1] if len(session.argv) > 1 else "%+")
    if job is None:
        return 1
    if not job.stopped:
        complain_as_shell(session, f"job {job.number} already in background")
        return 0
    job.resume()
    session.print(f"[{job.number}]{shell.jobs.mark(job)} {job.source} &")
    return 0


async def wait(session: Session) -> int:
    shell = shell_of(session)
    if len(session.argv) == 1:
        for job in shell.jobs.ordered():
            await job.wait()
        shell.jobs.take_finished()
        return 0
    status = 0
    for spec in session.argv[1:]:
        found = shell.jobs.find(spec)
        if found is None:
            known = spec.startswith("%")
            complain_as_shell(session, f"{spec}: no such job" if known else f"pid {spec} is not a child of this shell")
            status = 127
            continue
        await found.wait()
        shell.jobs.remove(found)
        status = found.status
    return status


def _signal_number(text: str) -> int | None:
    if text.isdigit():
        return int(text)
    return NUMBERS.get(text.upper().removeprefix("SIG"))


def _list_signals(session: Session, words: list[str]) -> int:
    """`kill -l`: all signals, or the name of each number (or status of what one ended) and the number of each name."""
    if not words:
        session.print(" ".join(f"{value}) SIG{name}" for name, value in NUMBERS.items()))
    names = {0: "EXIT", **{value: name for name, value in NUMBERS.items()}}
    status = 0
    for word in words:
        number = _signal_number(word)
        if number is not None and number > 128:
            number -= 128
        if number not in names:
            complain_as_shell(session, f"{word}: invalid signal specification")
            status = 1
        else:
            session.print(names[number] if word.isdigit() else number)
    return status


async def kill(session: Session) -> int:
    words = session.argv[1:]
    number: int | None = 15
    if words and words[0] in ("-l", "-L"):
        return _list_signals(session, words[1:])
    if words in (["-s"], ["-n"]):
        complain_as_shell(session, f"{words[0]}: option requires an argument")
        return 1
    if words and words[0] in ("-s", "-n"):
        text, words = words[1], words[2:]
        number = _signal_number(text)
    elif words and words[0].startswith("-") and words[0] != "--":
        text, words = words[0][1:], words[1:]
        number = _signal_number(text)
    if number is None:
        complain_as_shell(session, f"{text}: invalid signal specification")
        return 1
    words = [word for word in words if word != "--"]
    if not words:
        complain_as_shell(
            session, "usage: kill [-s sigspec | -n signum | -sigspec] pid | jobspec ... or kill -l [sigspec]"
        )
        return 2
    status = 0
    for word in words:
        if not _kill_one(session, word, number):
            status = 1
    return status


def _kill_one(session: Session, word: str, number: int) -> bool:
    shell = shell_of(session)
    if word.startswith("%"):
        job = shell.jobs.find(word)
        if job is None:
            complain_as_shell(session, f"{word}: no such job")
            return False
        if number:
            job.send(number)
        return True
    if not word.lstrip("-").isdigit():
        complain_as_shell(session, f"{word}: arguments must be process or job IDs")
        return False
    program = find_program(shell, int(word))
    if program is None:
        complain_as_shell(session, f"({word}) - No such process")
        return False
    if number:
        send(program, number)
    return True


def find_program(shell: Shell, pid: int) -> Program | None:
    """The running program with this process id: ours, or that of the process behind a `python3`."""
    from day6_core.shell.process.process import running_processes

    for process in running_processes(shell.desk.scheduler):
        if 0 != process.pid == pid:
            pid = process.session.pid
    return shell.desk.programs.get(abs(pid))


def send(program: Program, number: int) -> None:
    """Deliver a signal; a stopped program goes on so that it can act on an ending one."""
    program.send(number)
    if program.stopped and number in (1, 2, 9, 15):
        program.resume()


async def disown(session: Session) -> int:
    shell = shell_of(session)
    job = _job(session, session.argv[1] if len(session.argv) > 1 else "%+")
    if job is None:
        return 1
    shell.jobs.remove(job)
    return 0


async def ps(session: Session) -> int:
    shell = shell_of(session)
    session.print("    PID TTY          TIME CMD")
    rows = [
        (shell.pid, "bash"),
        *((program.pid, " ".join(program.session.argv)) for program in shell.desk.programs.values()),
    ]
    for pid, text in sorted(rows):
        if pid != session.pid or text.startswith("ps"):
            session.print(f"{pid:>7} pts/0    00:00:00 {text}")
    return 0


async def pkill(session: Session) -> int:
    """`pkill PATTERN` and `killall NAME`: the programs whose command contains (or is) it."""
    words = session.argv[1:]
    number: int | None = 15
    full = "-f" in words
    words = [word for word in words if word != "-f"]
    if words and words[0].startswith("-"):
        number = _signal_number(words.pop(0)[1:])
    if not words or number is None:
        session.print_error(f"{session.name}: no matching criteria specified")
        return 2
    found = 0
    for program in list(shell_of(session).desk.programs.values()):
        command = " ".join(program.session.argv)
        names = [word.rpartition("/")[2] for word in program.session.argv[:4]]
        matches = words[0] in names if session.name == "killall" else words[0] in (command if full else " ".join(names))
        if matches and program.pid != session.pid:
            send(program, number)
            found += 1
    if not found and session.name == "killall":
        session.print_error(f"{words[0]}: no process found")
    return 0 if found else 1
