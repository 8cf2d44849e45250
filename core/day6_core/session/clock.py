"""The clock of a machine: world time, by which programs move and wait, and real time, by which they measure.

World time (`steady_ns`) is paced by wall time but advances only as far as the scheduler has run: when a timer due at T runs, the
clock reads exactly T, and it never passes a timer that has not run. Under load it therefore falls behind wall time and never
skips a tick. Paused, it stands still; at another speed a wall second is that many world seconds. Real ROS has no such clock; to a
program it is the steady clock of the machine, which timers run by.

Real time is what the machine's own clocks say, whatever the world does: `now_ns` the date, `wall_ns` the monotonic clock.

Who reads which, of the programs that run here (a student's process has real time alone, as in ROS):

World time is for what moves and what waits:
- timers, periods, `sleep`, timeouts; the pace of `ros2 bag play` and `topic pub`;
- what stops or starts anew for lack of news: a turtle one second after its last command, the wheels of the simulated robot;
- what a window lets grow old, so that a pause ages nothing: RViz' frames, markers and points, the car window's joints;
- the time axis of rqt_plot: a pause holds the picture, a slow world is drawn in its own seconds.

Real time is for what is measured, stamped or compared with other processes:
- `node.get_clock().now()`, so every stamp of a header, a log line or a goal, and the ages and extrapolations of tf; what
  robot_state_publisher holds back, because that is decided by the stamps of others;
- `ros2 topic hz`, `bw` and `delay`, tf2_monitor, rqt_topic; rates and speeds in the inspector, the car window and RViz;
- when a message was sent and received, in its information and in bags; lifespans, deadlines and leases;
- `date`, `time`, names of files; and beside world time: how fast the world runs (the simulated world's window).

With `use_sim_time` a node's clock and timers follow /clock instead of both (`Session.timer_ns`).
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

NANOSECONDS = 1_000_000_000
MIN_SPEED = 0.1
MAX_SPEED = 10.0


def nanoseconds(seconds: float) -> int:
    """Seconds as whole nanoseconds, rounded to the nearest."""
    return round(seconds * NANOSECONDS)


class WorldClock:
    """World time in nanoseconds since the world began, and real time beside it.

    `wall` is the pacing clock (ns, monotonic), `system` the one that tells the date (ns since 1970). With `wall=None` world time
    does not move by itself: tests call `step`. Nothing is real then, so that `now_ns` and `wall_ns` step along, from the date
    `epoch_ns` on.
    Only the scheduler that owns the clock calls `target_ns`, `hold`, `release` and `fall_behind`.
    All methods may be called from any thread.
    """

    def __init__(
        self,
        *,
        wall: Callable[[], int] | None = time.monotonic_ns,
        system: Callable[[], int] = time.time_ns,
        epoch_ns: int | None = None,
    ) -> None:
        self._wall = wall
        self._system = system
        self._epoch_ns = system() if epoch_ns is None else epoch_ns
        self._lock = threading.Lock()
        self._anchor_world = 0
        self._anchor_wall = wall() if wall is not None else 0
        self._speed = 1.0
        self._paused = wall is None
        self.lost_ns = 0
        """World time that was given up because this computer is too slow for its programs; it only grows."""
        self._reading = 0
        """The latest value anything may have read."""
        self._free_until: int | None = 0
        """While the scheduler idles the clock runs freely up to here (None: no limit); -1 while it is held."""
        self.on_change: Callable[[], None] | None = None
        """Called when pace or target was changed from outside, so that a waiting scheduler reads the clock again."""

    def now_ns(self) -> int:
        """Real nanoseconds since 1970: the ROS and system clock."""
        return self._system() if self._wall is not None else self._epoch_ns + self.steady_ns()

    def wall_ns(self) -> int:
        """Real nanoseconds since some fixed moment; never goes back, whatever the date is set to."""
        return self._wall() if self._wall is not None else self.steady_ns()

    def steady_ns(self) -> int:
        """World time in nanoseconds since the world began; never goes back."""
        limit = self._free_until
        if limit is not None and limit < 0:
            return self._reading
        with self._lock:
            if self._free_until is not None and self._free_until < 0:
                return self._reading
            target = self._target()
            if self._free_until is not None:
                target = min(target, self._free_until)
            self._reading = max(self._reading, target)
            return self._reading

    @property
    def speed(self) -> float:
        """World seconds per wall second while not paused."""
        return self._speed

    @property
    def is_paced(self) -> bool:
        """Whether wall time moves it on."""
        return self._wall is not None

    @property
    def paused(self) -> bool:
        """Whether the clock is paused."""
        return self._paused

    def pause(self) -> None:
        """Stop the clock. Keys and messages from outside are still handled, at the time where it stopped."""
        with self._lock:
            self._rebase(self._target())
            self._paused = True
        self._changed()

    def resume(self) -> None:
        """Go on at the clock's speed from where it stopped. Does nothing with `wall=None`."""
        with self._lock:
            if self._wall is None:
                return
            self._rebase(self._target())
            self._paused = False
        self._changed()

    def set_speed(self, factor: float) -> None:
        """Set the pace to `factor` world seconds per wall second.

        Raises:
            ValueError: `factor` is outside 0.1 to 10.
        """
        if not MIN_SPEED <= factor <= MAX_SPEED:
            raise ValueError(f"speed must be between {MIN_SPEED} and {MAX_SPEED}, not {factor}")
        with self._lock:
            self._rebase(self._target())
            self._speed = factor
        self._changed()

    def step(self, seconds: float) -> None:
        """Move the paused clock on by `seconds`: everything due until then runs, tick by tick."""
        with self._lock:
            self._rebase(self._target() + nanoseconds(seconds))
        self._changed()

    def target_ns(self) -> int:
        """World time at which the world should be by now."""
        with self._lock:
            return max(self._target(), self._reading)

    def hold(self, steady_ns: int) -> None:
        """Make the clock read exactly `steady_ns` (never less than before) until the next call."""
        with self._lock:
            self._free_until = -1
            self._reading = max(self._reading, steady_ns)

    def release(self, limit_ns: int | None) -> None:
        """Nothing is running: follow wall time, up to `limit_ns`, the next deadline (None: no limit)."""
        with self._lock:
            self._free_until = limit_ns

    def fall_behind(self, target_ns: int) -> None:
        """Forget the lag: from now on `target_ns` is where the world should be."""
        with self._lock:
            before, now = self._target(), max(target_ns, self._reading)
            self.lost_ns += max(0, before - now)
            self._rebase(now)

    def wall_seconds_until(self, steady_ns: int) -> float | None:
        """Wall seconds until the clock reaches `steady_ns`; None while it is paused before that."""
        with self._lock:
            left = steady_ns - self._target()
            if left <= 0:
                return 0.0
            if self._paused:
                return None
            return left / self._speed / NANOSECONDS

    def _target(self) -> int:
        """World time at which the world should be by the wall. The caller holds the lock."""
        if self._paused or self._wall is None:
            return self._anchor_world
        return self._anchor_world + int((self._wall() - self._anchor_wall) * self._speed)

    def _rebase(self, world_ns: int) -> None:
        """Go on from `world_ns` now. The caller holds the lock."""
        self._anchor_world = world_ns
        if self._wall is not None:
            self._anchor_wall = self._wall()

    def _changed(self) -> None:
        if self.on_change is not None:
            self.on_change()
