"""Becomes a student's process: `python -I -S launch_process.py tty|no-tty NICE PROGRAM ARG…`.

Run as a file, before the program, because between fork and exec of a process with threads nothing may be done in Python. It leads
a session already; here it takes its standard input as controlling terminal, lowers its priority and undoes ignored signals.
"""

import os
import signal
import sys


def main() -> None:
    if sys.platform == "win32":
        raise NotImplementedError("processes are started without this there")
    mode, nice, *argv = sys.argv[1:]
    if mode == "tty":
        import fcntl
        import termios

        fcntl.ioctl(0, termios.TIOCSCTTY, 0)
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    os.nice(int(nice))
    os.execv(argv[0], argv)


if __name__ == "__main__":
    main()
