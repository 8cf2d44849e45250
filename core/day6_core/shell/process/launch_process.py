"""Becomes a student's process: `python -I -S launch_process.py tty|no-tty NICE MEMORY PROGRAM NAME ARG…`.

Run as a file, before the program, because a process with threads must not run Python between fork and exec. It leads
a session already; here it takes its standard input as controlling terminal, lowers its priority, limits its memory (bytes,
0: no limit) and resets ignored signals.
"""

import os
import signal
import sys


def main() -> None:
    if sys.platform == "win32":
        raise NotImplementedError("processes are started without this there")
    mode, nice, memory, program, *argv = sys.argv[1:]
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE):
        signal.signal(number, signal.SIG_DFL)
    if mode == "tty":
        import fcntl
        import termios

        fcntl.ioctl(0, termios.TIOCSCTTY, 0)  # from now on Ctrl-C is a signal
    os.nice(int(nice))
    leave_no_core()
    if int(memory):
        limit_memory(int(memory))
    try:
        os.execv(program, argv)
    except OSError as error:  # it was there a moment ago, or no system calls it a program
        sys.stderr.write(f"bash: {program}: {error.strerror}\n")
        sys.exit(126)


def leave_no_core() -> None:
    """Write no core dump of megabytes into the student's folder when Ctrl-\\ ends the program."""
    if sys.platform == "win32":
        raise NotImplementedError("not there")
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))


def limit_memory(size: int) -> None:
    """Limit the data segment, not the address space: threads and mapped files reserve many addresses they never use."""
    if sys.platform == "win32":
        raise NotImplementedError("not there")
    import resource

    if lowered := lower_limit(size):
        try:
            resource.setrlimit(resource.RLIMIT_DATA, (lowered, resource.getrlimit(resource.RLIMIT_DATA)[1]))
        except (ValueError, OSError):
            return  # a system that does not limit data


def lower_limit(size: int) -> int:
    """Return the limit for the data segment that is to be set for that one, 0 if a lower one is there (or `size` is 0)."""
    if sys.platform == "win32":
        raise NotImplementedError("not there")
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    if hard != resource.RLIM_INFINITY:
        size = min(size, hard)
    return size if soft == resource.RLIM_INFINITY or size < soft else 0


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:  # it came before the first lines of `main`
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGINT)
