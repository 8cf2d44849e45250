"""Signal numbers and texts of the simulated machine, which are Linux's, and their numbers on the host system."""

from __future__ import annotations

import signal

NUMBERS = {
    "HUP": 1, "INT": 2, "QUIT": 3, "ILL": 4, "TRAP": 5, "ABRT": 6, "BUS": 7, "FPE": 8, "KILL": 9, "USR1": 10, "SEGV": 11,
    "USR2": 12, "PIPE": 13, "ALRM": 14, "TERM": 15, "CONT": 18, "STOP": 19, "TSTP": 20, "TTIN": 21,
    "TTOU": 22, "XCPU": 24,
}  # fmt: skip

TEXTS = {
    1: "Hangup",
    2: "Interrupt",
    3: "Quit",
    4: "Illegal instruction",
    5: "Trace/breakpoint trap",
    6: "Aborted",
    7: "Bus error",
    8: "Floating point exception",
    9: "Killed",
    10: "User defined signal 1",
    11: "Segmentation fault",
    12: "User defined signal 2",
    13: "Broken pipe",
    14: "Alarm clock",
    15: "Terminated",
    24: "CPU time limit exceeded",
}
"""The shell's message for a program that was ended by a signal."""

STOPPED = {19: "Stopped (signal)", 21: "Stopped (tty input)", 22: "Stopped (tty output)"}
"""What `jobs -l` says of a program that a signal other than Ctrl-Z's has stopped."""

_NAMES = {number: name for name, number in NUMBERS.items()}


def to_system(number: int) -> int:
    """Return the host system's number of a signal (macOS has other numbers for some); unknown ones stay as they are."""
    return int(getattr(signal, f"SIG{_NAMES.get(number)}", number))


def from_system(number: int) -> int:
    """Return the simulated machine's number of a signal of the host system; unknown ones stay as they are."""
    try:
        name = signal.Signals(number).name
    except ValueError:
        return number
    return NUMBERS.get(name.removeprefix("SIG"), number)
