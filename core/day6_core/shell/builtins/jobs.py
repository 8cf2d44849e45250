"""jobs, fg, bg, wait, kill, disown, ps, pkill, killall."""

from __future__ import annotations

from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.signals import NUMBERS
from day6_core.shell.builtins.options import UsageError, complain_as_shell, parse
from day6_core.shell.commands import find_command
from day6_core.shell.language.control_flow import Interrupted
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.jobs import Job, JobTable
from day6_core.shell.language.redirection import Streams


async def jobs(session: Session) -> int:
    """`jobs [-lnprs] [JOB …]`, `jobs -x COMMAND …`, where each `%JOB` stands for its process number."""
    shell = shell_of(session)
    table = shell.jobs if shell.jobs.jobs or shell.outer_jobs is None else shell.outer_jobs
    if session.argv[1:2] == ["-x"]:
        found = [table.find(word) if word.startswith("%") else None for word in session.argv[2:]]
        words = [str(job.pid) if job else word for job, word in zip(found, session.argv[2:], strict=True)]
        return await session.execute(find_command(words[0], shell), words) if words else 0
    if (given := _given(session, "lnprs")) is None:
        return 2
    options, specs = given
    chosen = table.ordered()
    if specs:
        named = [_job(session, spec, table) for spec in specs]
        chosen = [job for job in named if job is not None]
    for job in chosen:
        if (
            ("r" in options and job.state != "Running")
            or ("s" in options and not job.stopped)
            or ("n" in options and (job.stop_is_told or job.state == "Running"))
        ):
            continue
        session.print(job.pid if "p" in options else table.line(job, job.pid if "l" in options else 0))
        job.stop_is_told = job.stopped
    shell.jobs.take_finished()
    return 1 if specs and len(chosen) < len(specs) else 0


_USAGE = {
    "jobs": "[-lnprs] [jobspec ...] or jobs -x command [args]",
    "disown": "[-h] [-ar] [jobspec ... | pid ...]",
}


def _given(session: Session, flags: str) -> tuple[dict[str, str], list[str]] | None:
    """Options and operands; None, with a message, for a wrong option."""
    try:
        return parse(session.argv, flags)
    except UsageError:
        wrong = next(
            f"-{letter}" for word in session.argv[1:] if word[:1] == "-" for letter in word[1:] if letter not in flags
        )
        complain_as_shell(session, f"{wrong}: invalid option")
        session.print_error(f"{session.name}: usage: {session.name} {_USAGE[session.name]}")
        return None


def _job(session: Session, spec: str, table: JobTable | None = None) -> Job | None:
    job = (table or shell_of(session).jobs).find(spec if spec.startswith("%") else f"%{spec}")
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
    """Wait for jobs; none that stands still is waited for, which bash says in two ways."""
    shell = shell_of(session)
    if len(session.argv) == 1:
        for job in shell.jobs.ordered():
            await job.wait()
            if job.stopped:
                complain_as_shell(session, f"warning: job {job.number}[{job.pid}] stopped")
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
        if found.stopped:
            session.print_error(f"{shell.name}: warning: wait_for_job: job {found.number} is stopped")
        await found.wait()
        status = found.status
        if found.finished:
            shell.jobs.remove(found)
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
    """`disown [-h] [-ar] [JOB …]`: out of the table or (`-h`) not ended with the shell; `-r` all that run, `-a` all."""
    shell = shell_of(session)
    if (given := _given(session, "har")) is None:
        return 2
    options, specs = given
    every = shell.jobs.ordered() if options.keys() & set("ar") and not specs else None
    found = [_job(session, spec) for spec in specs or ["%+"]] if every is None else every
    for job in found:
        if job is None or ("r" in options and job.state != "Running"):
            continue
        if "h" in options:
            job.outlives_shell = True
            continue
        if job.stopped:
            session.print_error(
                f"{shell.name}: warning: deleting stopped job {job.number} with process group {job.pid}"
            )
        shell.jobs.remove(job)
    return 1 if None in found else 0


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
