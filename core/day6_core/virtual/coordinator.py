"""Says which process of a world goes on, one at a time, and lets time pass when all of them wait.

It lives in the first process of the world and works while that is idle itself, on whichever of its threads waited last.

The processes have their turns in the order in which they were started: who has been sent something, and who has waited for
this moment. Then those that watch descriptors look into them, as nobody tells when something comes through a pipe. When none of
them has anything left to do, time goes on to the first moment that somebody waits for.

The real world holds time still: a process that hasn't come to its first wait yet, one that waits for something real (a C
function that sleeps), a program that isn't Python, and who waits for a key or a machine outside. Meanwhile, others do what is to
be done at this moment.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
import select
import signal
import socket
import struct
from collections.abc import Callable, Iterable
from contextlib import suppress
from time import monotonic as real_time

from day6_core.virtual import processes
from day6_core.virtual.kernel import Kernel
from day6_core.virtual.limit import Limit
from day6_core.virtual.member import state_of
from day6_core.virtual.surroundings import outside
from day6_core.virtual.told import TOLD_AFTER, Used, is_computing, is_waiting
from day6_core.virtual.wire import NEVER, SENT_BY_SYSTEM, SIZE, Flag, Kind, packed, unpacked

_poll, _epoll = select.poll, select.epoll
_recv, _send, _accept = socket.socket.recv, socket.socket.send, socket.socket.accept
_kill, _read, _write = os.kill, os.read, os.write
_getsockopt, _PEER = socket.socket.getsockopt, struct.Struct("3i")

PATIENCE = 0.005
"""Real seconds after which a process that is to run is asked whether it waits for something real."""
FURTHEST_NS = 1_000_000_000
"""How far ahead of the others' a process may say its time is. Reading its clock takes it less, before it has to wait."""
LARGEST_PID = 1 << 22
"""Of Linux (PID_MAX_LIMIT)."""
_MOST_AT_ONCE = 4096
"""Bytes that are taken from a process before others are looked at."""
_SIGNALS = frozenset(map(int, signal.valid_signals()))
_STOPPING = (signal.SIGSTOP, signal.SIGTSTP, signal.SIGTTIN, signal.SIGTTOU)


def _is_child(pid: int, parent: int) -> bool:
    """Whether a process was started by another one."""
    return processes.parent_of(pid) == parent


class _Process:
    """A process of the world, as the coordinator knows it."""

    def __init__(self, number: int, pid: int) -> None:
        self.number = number
        self.pid = pid
        self.pidfd = -1
        self.socket: socket.socket | None = None
        """None until it takes part; a program that isn't Python never does."""
        self.said = _poll()
        """Shows whether it has said something, or the first process is wanted; while it takes part."""
        self.frames = b""
        """Not read yet."""
        self.deadline = NEVER
        self.flags = 0
        """Of `Flag`."""
        self.touched = True
        """Something has been sent to it."""
        self.signals: list[int] = []
        """For its next turn."""
        self.seen = 0
        """How many turns there had been when it looked at its descriptors."""
        self.runs = False
        """It has had a turn and isn't idle yet. (A program that isn't Python always does.)"""
        self.is_real = False
        """It waits for something real: others go on meanwhile."""
        self.is_stopped = False
        self.stirred = 0
        """How often it had run when it was last asked for, if it waits for something real."""
        self.used: Used = (0.0, 0.0)
        """What it had used of the cores when time came to stand still."""

    @property
    def is_idle(self) -> bool:
        return self.socket is not None and not self.runs and not self.is_stopped


class Coordinator:
    """`tell` says something to the user, by what the first process does with it. `limit`: for how long time may be held.

    What processes say is believed only as far as each could do it by itself: they may be anybody's (see `lessons.grading`).
    """

    number = 0
    """Of the first process."""
    _holding = Flag.HOLDS
    """The flag of a process that holds time still."""
    _longest_patience = 0.1
    """Real seconds between two looks at a process that runs."""

    def __init__(self, path: str, tell: Callable[[str, str], None], limit: Limit | None = None) -> None:
        outside()  # which is known from here on, whoever removes the link to it
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        with suppress(FileNotFoundError):
            os.unlink(path)  # of the program that has become this one
        self._listener.bind(path)
        self._listener.listen(128)
        self._listener.setblocking(False)
        self._tell = tell
        self._limit = limit
        self._told: set[int] = set()
        """Which programs have been named; 0 when nothing is left to happen."""
        self._woken, self._waking = os.pipe2(os.O_CLOEXEC | os.O_NONBLOCK)
        self._speaking = _epoll()
        """Shows who of those that take part has said something."""
        self._members: dict[int, _Process] = {}
        """All but the first, by their system's number, in their order."""
        self._own = _Process(0, os.getpid())
        self._numbers = 0
        self._now = 0
        self._turns = 0
        """In which somebody did something."""
        self._running: _Process | None = None
        self._still_since = -1.0
        """Since when time stands still, in real seconds."""

    # -- what the first process does -------------------------------------------------------------------------------------

    def spawned(self, pid: int) -> None:
        """A process was started; time stands still before it takes part or ends."""
        self._numbers += 1
        member = _Process(self._numbers, pid)
        try:
            member.pidfd = os.pidfd_open(pid)
        except OSError:
            return  # its parent has waited for its end already
        member.runs = True
        self._members[pid] = member

    def touched(self, pid: int) -> None:
        """Something was sent to a process."""
        if pid == self._own.pid:
            self._own.touched = True
        elif (member := self._members.get(pid)) is not None:
            member.touched = True

    def killed(self, target: int, number: int) -> None:
        """A signal is sent to a process, or to a group if `target` is negative."""
        if target >= 0:
            self._signal(target, number)
            return
        for pid in sorted(processes.group_members(-target)):
            self._signal(pid, number)

    def typed(self, group: int) -> None:
        """Something was typed for a group of processes, to whom the terminal may have sent a signal."""
        for member in self._members.values():
            with suppress(ProcessLookupError):
                if member.is_idle and SENT_BY_SYSTEM not in member.signals and os.getpgid(member.pid) == group:
                    member.signals.append(SENT_BY_SYSTEM)

    def want(self) -> None:
        """Something has come from outside to the first process itself."""
        _write(self._waking, b"\0")

    def leave(self) -> None:
        """In a forked child: let go of all that is the first process's."""
        self._listener.close()
        self._speaking.close()
        for member in self._members.values():
            if member.socket is not None:
                member.socket.close()

    def idle(self, kernel: Kernel) -> int:
        """Let the others go on until it is the first process's turn; return the time, ns."""
        own = self._own
        own.flags, time, own.deadline = state_of(kernel)
        self._advance(time)
        if own.flags & Flag.RAN:
            self._turns += 1
        own.seen = self._turns
        while not kernel.has_turn and not self._is_own_turn(kernel):
            self._keep_limit()
            member = self._running or self._next()
            if member is not None:
                self._follow(member, kernel)
            elif not self._pass(kernel):
                self._wait(kernel)
        return self._now

    # -- turns -----------------------------------------------------------------------------------------------------------

    def _advance(self, time: int) -> None:
        self._now = max(self._now, time)

    def _is_own_turn(self, kernel: Kernel) -> bool:
        own = self._own
        if self._running is not None:
            return False
        if own.touched or own.seen < self._turns:
            kernel.touched = kernel.touched or own.touched
            own.touched, own.seen = False, self._turns
            if kernel.look():
                return True
        return NEVER != own.deadline <= self._now

    def _next(self) -> _Process | None:
        """Return who goes on, after its GO where it needs one."""
        if any(each.is_real for each in self._members.values()):
            self._hear()
        now, turns = self._now, self._turns
        due: _Process | None = None
        looking: _Process | None = None
        for each in self._members.values():
            if each.is_real or each.is_stopped:
                continue
            if each.runs:
                return each
            if each.touched or each.signals or NEVER != each.deadline <= now:
                due = due or each
            elif each.flags & Flag.WATCHES and each.seen < turns:
                looking = looking or each
        member = due or looking
        if member is not None:
            self._go(member)
        return member

    def _go(self, member: _Process) -> None:
        frames = packed(Kind.GO, Flag.TOUCHED if member.touched else 0, self._now, member.number)
        if member.signals:
            frames = b"".join((*(packed(Kind.SIGNAL, 0, number, 0) for number in member.signals), frames))
            member.signals.clear()
        member.touched, member.runs, self._running = False, True, member
        self._tell_member(member, frames)

    def _tell_member(self, member: _Process, frames: bytes) -> None:
        """Send it something. If it has been killed, that shows when it is followed; who takes nothing is in the world no more."""
        assert member.socket is not None
        try:
            _send(member.socket, frames)
        except BlockingIOError:
            self._lose(member)
        except OSError:
            return

    @staticmethod
    def _lose(member: _Process) -> None:
        """It has ended, has become another program, or behaves like one."""
        assert member.socket is not None
        member.socket.close()
        member.socket, member.runs = None, True

    def _follow(self, member: _Process, kernel: Kernel) -> None:
        """Wait until a process that runs is idle or gone, or waits for something real, or the first process is wanted."""
        self._running = member
        patience = PATIENCE
        stirred = -1
        while member.runs:
            if self._held_until() > self._now:
                member.is_real = True
                break
            if member.socket is None:
                ready = self._poll((self._listener.fileno(), member.pidfd, self._woken), patience)
            else:
                ready = [fd for fd, _ in member.said.poll(1000 * patience)]
            if self._woken in ready:
                _read(self._woken, 4096)
                if kernel.has_turn:
                    break
            elif not ready:
                before, stirred = stirred, processes.stirred(member.pid)
                if member.is_real or stirred == before:
                    member.is_real = True
                    break
                if self._turns_to_people(kernel):
                    break
                patience = min(2 * patience, self._longest_patience)
            elif member.socket is None:
                self._enter(member, ready)
            else:
                self._take(member)
        self._running = None

    def _poll(self, fds: Iterable[int], seconds: float) -> list[int]:
        poll = _poll()
        for fd in fds:
            poll.register(fd, select.POLLIN)
        return [fd for fd, _ in poll.poll(1000 * seconds)]

    # -- who takes part --------------------------------------------------------------------------------------------------

    def _enter(self, expected: _Process | None, ready: Iterable[int]) -> None:
        """Take in who has connected; see who is gone."""
        if self._listener.fileno() in ready:
            try:
                connected, _ = _accept(self._listener)
            except OSError:
                return  # it has thought better of it
            connected.setblocking(False)
            pid = _PEER.unpack(_getsockopt(connected, socket.SOL_SOCKET, socket.SO_PEERCRED, _PEER.size))[0]
            if pid not in self._members:
                self.spawned(pid)  # something else than Python has started it
            member = self._members.get(pid)
            if member is None:
                connected.close()
                return
            if member.socket is not None:
                member.socket.close()
            member.socket, member.frames, member.said = connected, b"", _poll()
            for fd in (connected.fileno(), self._woken):
                member.said.register(fd, select.POLLIN)
            self._speaking.register(connected.fileno(), select.POLLIN)
            member.runs, member.is_real, member.touched = False, False, True
        elif expected is not None and expected.pidfd in ready:
            self._remove(expected)

    def _remove(self, member: _Process) -> None:
        member.runs = False
        del self._members[member.pid]
        os.close(member.pidfd)
        if member.socket is not None:
            member.socket.close()
        self._touch_all()  # it may have been at the other end of something

    def _touch_all(self) -> None:
        self._turns += 1
        for each in (self._own, *self._members.values()):
            each.touched = True

    def _take(self, member: _Process) -> None:
        """Take what a process has to say; what comes first, if it is gone, is its end."""
        assert member.socket is not None
        try:
            data = _recv(member.socket, _MOST_AT_ONCE)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        if not data:
            self._lose(member)
            return
        member.frames += data
        while len(member.frames) >= SIZE:
            kind, flags, first, second = unpacked(member.frames[:SIZE])
            member.frames = member.frames[SIZE:]
            if kind != Kind.IDLE and abs(first) > LARGEST_PID:
                continue
            if kind == Kind.IDLE:
                self._advance(min(first, self._now + FURTHEST_NS))
                member.deadline, member.flags = max(NEVER, second), flags
                member.runs = member.is_real = False
                if flags & Flag.RAN:
                    self._turns += 1
                member.seen = self._turns
            elif kind == Kind.TOUCHED:
                self.touched(first)
            elif kind == Kind.SPAWNED:
                if first not in self._members and _is_child(first, member.pid):
                    self.spawned(first)
            elif kind == Kind.KILLED:
                if second in _SIGNALS:
                    self.killed(first, second)
            elif kind == Kind.TYPED:
                self.typed(first)
            elif kind == Kind.WANTS:
                member.touched = True

    def _signal(self, pid: int, number: int) -> None:
        if not self._may_be_signalled(pid):
            return
        if pid == self._own.pid:
            _kill(pid, number)
            return
        member = self._members.get(pid)
        if member is not None and member.is_idle and number not in (signal.SIGKILL, signal.SIGCONT, *_STOPPING):
            if number not in member.signals:
                member.signals.append(number)
            return
        try:
            _kill(pid, number)
        except OSError:
            return  # gone meanwhile
        if member is None:
            return
        if number == signal.SIGKILL:
            member.runs = True  # until it is gone
            member.is_stopped = False
        elif number == signal.SIGCONT:
            member.is_stopped = False
            self._touch_all()
        elif number in _STOPPING:
            member.is_stopped = processes.is_stopped_soon(pid)
            self._touch_all()

    def _may_be_signalled(self, pid: int) -> bool:
        """Whether a process may be sent signals. Where nobody is trusted, only those that take part or are younger."""
        if self._limit is None or pid in self._members:
            return True
        return processes.started_at(pid) > processes.started_at(self._own.pid)

    # -- time --------------------------------------------------------------------------------------------------------------

    def _held_until(self) -> int:
        """To which time it goes on although somebody holds it for too long; 0 if nobody does."""
        return 0 if self._limit is None else self._limit.time_at(self._now, (self._own.pid, *self._members))

    def _keep_limit(self) -> None:
        """Let time go on to the next moment for which somebody waits, if it is held for too long."""
        if (end := self._held_until()) > self._now:
            deadlines = (each.deadline for each in (self._own, *self._members.values()) if each.deadline > self._now)
            self._advance(min((end, *deadlines)))

    def _pass(self, kernel: Kernel) -> bool:
        """Nobody has anything left to do now: let time pass to the next moment; False if it can't."""
        if self._has_stirred():
            return True
        first = self._next_moment()
        if first is None or first == NEVER:
            return False
        self._pass_to(first)
        return True

    def _pass_to(self, moment: int) -> None:
        self._still_since = -1.0
        self._advance(moment)
        self._hear()

    def _next_moment(self) -> int | None:
        """The first one that somebody waits for, NEVER if nobody does, None if time stands still."""
        first = NEVER
        for each in (self._own, *self._members.values()):
            if each.is_stopped:
                continue
            if each.flags & self._holding or (each.is_real and self._holds(each)):
                return None
            if each.deadline != NEVER and (first == NEVER or each.deadline < first):
                first = each.deadline
        return first

    def _turns_to_people(self, kernel: Kernel) -> bool:
        """Whether the first process goes on for something real while another one runs."""
        return False

    def _has_stirred(self) -> bool:
        """Whether something real has gone on, so that others may find something in their descriptors."""
        found = False
        for each in self._members.values():
            if each.is_real and each.stirred != (now := processes.tree_stirred(each.pid, self._members)):
                each.stirred = now
                found = found or now >= 0
        if found:
            self._touch_all()
        return found

    def _holds(self, member: _Process) -> bool:
        """Whether something real that a process waits for holds time still: not what others in this world give it."""
        return member.stirred < 0 or not processes.tree_waits_for_others(member.pid, self._members, outside())

    def _hear(self) -> None:
        """Take what processes have said unasked."""
        if ready := self._speaking.poll(0):
            by_fd = {each.socket.fileno(): each for each in self._members.values() if each.socket is not None}
            for fd, _ in sorted(ready):
                if fd in by_fd:
                    self._take(by_fd[fd])

    def _wait(self, kernel: Kernel) -> None:
        """Wait for something real."""
        real = self._limit is not None or any(each.is_real for each in self._members.values())
        ready = self._attend(kernel, PATIENCE if real else TOLD_AFTER)
        if not ready and self._still_since < 0:
            self._still_since = real_time()
            for each in self._members.values():
                each.used = processes.used(each.pid)
        if ready:
            self._still_since = -1.0
        elif not real or real_time() - self._still_since > TOLD_AFTER:
            self._say_why()
            if not real:
                self._attend(kernel, None)

    def _attend(self, kernel: Kernel, seconds: float | None) -> bool:
        """Wait for something from outside, at most for real seconds, and take it; False if nothing came."""
        poll = _poll()
        by_fd: dict[int, _Process] = {}
        for member in self._members.values():
            if member.is_idle and self._hears_alone(member):
                self._tell_member(member, packed(Kind.SLEEP, 0, 0, 0))
            if member.socket is not None:
                by_fd[member.socket.fileno()] = member
            by_fd[member.pidfd] = member
        for fd in (*by_fd, self._woken, self._listener.fileno()):
            poll.register(fd, select.POLLIN)
        for watch in kernel.watched:
            for fd, events in watch.fds:
                poll.register(fd, events)
        ready = [fd for fd, _ in poll.poll(None if seconds is None else 1000 * seconds)]
        if self._woken in ready:
            _read(self._woken, 4096)
        for fd in ready:
            found = by_fd.get(fd)
            if found is None or found.pid not in self._members:
                continue
            if found.socket is not None and fd == found.socket.fileno():
                self._take(found)
            elif fd == found.pidfd:
                self._remove(found)
        if self._listener.fileno() in ready:
            self._enter(None, ready)
        self._own.touched = True
        return bool(ready)

    def _hears_alone(self, member: _Process) -> bool:
        """Whether a process that is idle has to look at its own descriptors."""
        return True

    # -- what is said ------------------------------------------------------------------------------------------------------

    def _say_why(self) -> None:
        """Say why time stands still, unless a process that takes part says it itself, or the user is asked for something."""
        everybody = (self._own, *self._members.values())
        real = [each for each in everybody if each.is_real]
        for each in real:
            if each.socket is None and self._holds(each):
                used = processes.used(each.pid)
                if is_computing(each.used, used) or is_waiting(each.used, used):  # else it may be Python that starts
                    self._say("foreign", each.pid, processes.command_of(each.pid))
        if not any(self._holds(each) for each in real) and not any(each.flags & Flag.HOLDS for each in everybody):
            self._say("nothing", 0, ", ".join(processes.command_of(pid) for pid in self._members))

    def _say(self, kind: str, number: int, what: str) -> None:
        if number not in self._told:
            self._told.add(number)
            self._tell(kind, what)
