"""Programs of one process, and those that start others, in virtual time: what they print is what the time of the world says."""

from __future__ import annotations

import pytest

from tests.virtual.world import World

pytestmark = pytest.mark.process

PROGRAMS = {
    "clocks": (
        """
import datetime, time
print(time.time(), time.strftime("%F %T", time.gmtime()), datetime.datetime.now(datetime.timezone.utc))
began = time.monotonic(), time.perf_counter(), time.time(), time.clock_gettime(time.CLOCK_MONOTONIC)
time.sleep(3600)
ended = time.monotonic(), time.perf_counter(), time.time(), time.clock_gettime(time.CLOCK_MONOTONIC)
print(*(round(b - a, 3) for a, b in zip(began, ended)))
day = datetime.date.today()
print(repr(day), isinstance(day, datetime.date), repr(datetime.datetime.now().replace(microsecond=0)), datetime.datetime.max)
print(isinstance(datetime.datetime.now(), datetime.date), datetime.datetime.min + datetime.timedelta(1))
try: time.sleep(-1)
except ValueError as error: print(error)
""",
        """\
1767225600.000001 2026-01-01 00:00:00 2026-01-01 00:00:00.000003+00:00
3600.0 3600.0 3600.0 3600.0
datetime.date(2026, 1, 1) True datetime.datetime(2026, 1, 1, 1, 0) 9999-12-31 23:59:59.999999
True 0001-01-02 00:00:00
sleep length must be non-negative
""",
    ),
    "functions that a class keeps, or that are sent to another process": (
        """
import logging, multiprocessing, os, pickle, select, selectors, signal, sys, threading, time
def now(): return round(time.monotonic(), 2)
class Kept:
    sleep, clock, ns, date, select = time.sleep, time.monotonic, time.time_ns, time.gmtime, select.select
    read, write, open, random = os.read, os.write, open, os.urandom
    kill, fork, waitpid, alarm = os.kill, os.fork, os.waitpid, signal.alarm
kept = Kept()
kept.sleep(1); print(round(kept.clock(), 2), kept.ns() // 10**9, kept.date(0)[0], kept.select([], [], [], 1), now())
reading, writing = os.pipe(); kept.write(writing, b"read"); print(kept.read(reading, 9), len(kept.random(3)))
with kept.open("file", "w") as file: print("text", file=file)
kept.kill(os.getpid(), 0); print(kept.alarm(0))
pid = kept.fork()
if not pid: os._exit(7)
print(os.waitstatus_to_exitcode(kept.waitpid(pid, 0)[1]))
logging.Formatter.converter = time.gmtime
logging.basicConfig(format="%(asctime)s %(message)s", stream=sys.stdout); logging.warning("logged")
selector = selectors.SelectSelector(); selector.register(reading, selectors.EVENT_READ); print(selector.select(2), now())
functions = time.sleep, time.time, time.localtime, os.kill, select.select, open
print(all(pickle.loads(pickle.dumps(each)) is each for each in functions))
if __name__ == "__main__":
    multiprocessing.set_start_method("fork")
    with multiprocessing.Pool(2) as pool: print(pool.map(time.sleep, [1, 2]), now())
""",
        """\
1.0 1767225601 1970 ([], [], []) 2.0
b'read' 3
0
7
2026-01-01 00:00:02,000 logged
[] 4.0
True
[None, None] 6.0
""",
    ),
    "a busy wait": (
        """
import threading, time
threading.Timer(1, print, ["one second"]).start()
end = time.time() + 2
while time.time() < end: pass
print("two", round(time.monotonic(), 2))
""",
        "one second\ntwo 2.0\n",
    ),
    "threads": (
        """
import concurrent.futures, queue, threading, time
def now(): return round(time.monotonic(), 2)
condition, box = threading.Condition(), []
def produce():
    time.sleep(5)
    with condition: box.append(now()); condition.notify()
thread = threading.Thread(target=produce); thread.start()
with condition:
    while not box: condition.wait(1.5)
thread.join(); print(box, now(), thread.is_alive())
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    print(list(pool.map(lambda s: (time.sleep(s), s)[1], [3, 2, 1])), now())
q = queue.Queue()
try: q.get(timeout=2)
except queue.Empty: print("empty", now())
event = threading.Event(); threading.Timer(1, event.set).start()
print(event.wait(60), now())
barrier = threading.Barrier(3)
for n in 1, 2: threading.Thread(target=lambda n=n: (time.sleep(n), barrier.wait())).start()
barrier.wait(); print(now())
late = threading.Thread(target=lambda: (time.sleep(1), print("after the end", now()))); late.start()
late.join(0.5); print(late.is_alive(), now())
""",
        "[5.0] 5.0 False\n[3, 2, 1] 8.0\nempty 10.0\nTrue 11.0\n13.0\nTrue 13.5\nafter the end 14.0\n",
    ),
    "asyncio": (
        """
import asyncio, sys, time
async def main():
    await asyncio.gather(asyncio.sleep(2), asyncio.to_thread(time.sleep, 3))
    print(round(time.monotonic(), 2))
    try: await asyncio.wait_for(asyncio.sleep(60), 1)
    except asyncio.TimeoutError: print("timeout", round(time.monotonic(), 2))
    code = "import time; time.sleep(1); print(round(time.monotonic(), 2))"
    process = await asyncio.create_subprocess_exec(sys.executable, "-c", code, stdout=asyncio.subprocess.PIPE)
    print(await process.communicate(), process.returncode, round(time.monotonic(), 2))
asyncio.run(main())
""",
        "3.0\ntimeout 4.0\n(b'5.0\\n', None) 0 5.0\n",
    ),
    "processes": (
        """
import os, shlex, subprocess, sys, time
def now(): return round(time.monotonic(), 2)
python = shlex.quote(sys.executable)
code = "import time, sys; time.sleep(3); print(sys.stdin.read().strip(), round(time.monotonic(), 2)); sys.exit(4)"
done = subprocess.run([sys.executable, "-c", code], input="hi", capture_output=True, text=True)
print(done.stdout.strip(), done.returncode, now())
try: subprocess.run([sys.executable, "-c", "import time; time.sleep(9)"], timeout=2)
except subprocess.TimeoutExpired as error: print(round(error.timeout), now())
pair = [subprocess.Popen([sys.executable, "-c", f"import time; time.sleep({n}); print({n})"]) for n in (2, 1)]
print([each.wait() for each in pair], now())
print(os.system(f'{python} -c "import time; time.sleep(1); raise SystemExit(5)"') >> 8, now())
pid = os.fork()
if not pid:
    time.sleep(4); print("child", now()); os._exit(3)
print(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), now())
print(subprocess.run(["sh", "-c", "sleep 0.01; echo real"], capture_output=True, text=True).stdout.strip(), now())
script = f'{python} -c "import time; time.sleep(5)"; echo then; {python} -c "import time; time.sleep(5)"'
print(subprocess.run(["sh", "-c", script], capture_output=True, text=True).stdout.strip(), now())
""",
        "hi 3.0 4 3.0\n2 5.0\n1\n2\n[0, 0] 7.0\n5 8.0\nchild 12.0\n3 12.0\nreal 12.0\nthen 22.0\n",
    ),
    "processes that end at once": (
        """
import subprocess, sys
code = '''
import subprocess
for _ in range(30):
    child = subprocess.Popen(["true"])
    while child.poll() is None: pass
print("all")
'''
print(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip())
""",
        "all\n",
    ),
    "descriptors that are opened": (
        """
import os, threading, time
reading, writing = os.pipe()
def write():
    with open(writing, "w") as file:
        for n in range(3): time.sleep(1); print(n, file=file, flush=True)
threading.Thread(target=write).start()
for line in os.fdopen(reading): print(line.strip(), round(time.monotonic(), 2))
big, end = os.pipe()
def send():
    with os.fdopen(end, "wb", 0) as file: print(file.write(b"x" * 300_000))
threading.Thread(target=send).start()
with open(big, "rb") as file: print(len(file.read()))
""",
        "0 1.0\n1 2.0\n2 3.0\n300000\n300000\n",
    ),
    "a terminal whose reading waits for nothing, or for a time": (
        """
import os, pty, termios, threading, time
ours, side = pty.openpty()
def read_with(tenths):
    mode = termios.tcgetattr(side)
    mode[3] &= ~(termios.ICANON | termios.ECHO)
    mode[6][termios.VMIN], mode[6][termios.VTIME] = 0, tenths
    termios.tcsetattr(side, termios.TCSANOW, mode)
    print(os.read(side, 9), round(time.monotonic(), 1))
read_with(0)
read_with(20)
threading.Timer(1, os.write, [ours, b"typed"]).start()
read_with(20)
print(open(side, "rb", 0).read(9), round(time.monotonic(), 1))
""",
        "b'' 0.0\nb'' 2.0\nb'typed' 3.0\nb'' 5.0\n",
    ),
    "Ctrl-C in a terminal": (
        """
import fcntl, os, pty, subprocess, sys, termios, time
ours, side = pty.openpty()
code = '''
import time
print("ready", flush=True)
for n in range(200):
    try: time.sleep(60)
    except KeyboardInterrupt: assert abs(time.monotonic() - 1 - n / 100) < 0.005, (n, time.monotonic())
time.sleep(60)
'''
def own_terminal(): os.setsid(); fcntl.ioctl(0, termios.TIOCSCTTY, 0)
pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
child = subprocess.Popen([sys.executable, "-c", code], stdin=side, preexec_fn=own_terminal, **pipes)
print(child.stdout.readline())
time.sleep(1 - time.monotonic())
for n in range(201): os.write(ours, bytes([3])); time.sleep(0.01)
print(child.wait(), round(time.monotonic(), 2), child.stderr.read().splitlines()[-1])
""",
        "b'ready\\n'\n-2 3.01 b'KeyboardInterrupt'\n",
    ),
    "a socket in the place of a pipe": (
        """
import os, select, socket, subprocess, sys, time
listening = socket.socket(socket.AF_UNIX); listening.bind("s"); listening.listen()
code = "import socket, time; s = socket.socket(socket.AF_UNIX); s.connect('s'); print(s.recv(9), round(time.monotonic(), 1))"
child = subprocess.Popen([sys.executable, "-c", code])
time.sleep(1)
reading, writing = os.pipe()
poll = select.poll(); poll.register(reading, select.POLLIN); poll.poll(1000)
os.fdopen(reading).close()
connected, _ = listening.accept()
print(connected.fileno() == reading)
connected.send(b"hello"); time.sleep(5); print(child.wait())
""",
        "True\nb'hello' 2.0\n0\n",
    ),
    "multiprocessing": (
        """
import multiprocessing, time
def square(n): time.sleep(n); return n * n
def put(queue, lock, n):
    with lock: time.sleep(1); queue.put(n)
if __name__ == "__main__":
    multiprocessing.set_start_method("fork")
    with multiprocessing.Pool(2) as pool: print(pool.map(square, [1, 2, 3]))
    queue, lock = multiprocessing.Queue(), multiprocessing.Lock()
    children = [multiprocessing.Process(target=put, args=(queue, lock, n)) for n in range(3)]
    began = time.monotonic()
    for child in children: child.start()
    print(sorted(queue.get() for _ in children)); [child.join() for child in children]
    print(round(time.monotonic() - began, 1), [child.exitcode for child in children])
""",
        "[1, 4, 9]\n[0, 1, 2]\n3.0 [0, 0, 0]\n",
    ),
    "signals": (
        """
import os, signal, subprocess, sys, threading, time
def now(): return round(time.monotonic(), 2)
signal.signal(signal.SIGUSR1, lambda number, frame: print("handler", number, now()))
print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)
threading.Timer(1, os.kill, [os.getpid(), signal.SIGUSR1]).start()
time.sleep(3); print(now())
threading.Timer(1, signal.raise_signal, [signal.SIGINT]).start()
try: time.sleep(9)
except KeyboardInterrupt: print("interrupted", now())
code = "import time\\ntry: time.sleep(99)\\nexcept KeyboardInterrupt: print('in the child', round(time.monotonic(), 2))"
signal.signal(signal.SIGALRM, lambda number, frame: print("alarm", now()))
signal.alarm(3); signal.pause(); print(signal.alarm(9), signal.alarm(0)); time.sleep(10)
for number in signal.SIGINT, signal.SIGTERM, signal.SIGKILL:
    child = subprocess.Popen([sys.executable, "-c", code]); time.sleep(1)
    child.send_signal(number); print(child.wait(), now())
""",
        """\
True
handler 10 1.0
3.0
interrupted 4.0
alarm 7.0
0 9
in the child 18.0
0 18.0
-15 19.0
-9 20.0
""",
    ),
    "chance": (
        """
import random, uuid, subprocess, sys
first = random.random(), random.Random().random(), uuid.uuid4(), hash("x")
again = random.Random(1).random() == __import__("random").Random(1).random()
other = subprocess.run([sys.executable, "-c", "import random; print(random.random())"], capture_output=True, text=True)
print(len(set(map(str, first))) == 4, again, float(other.stdout) != first[0])
print(*first, other.stdout)
""",
        None,
    ),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_sees_the_time_of_the_world(world: World, name: str) -> None:
    program, expected = PROGRAMS[name]
    done = world.python(program)
    assert (done.returncode, done.stderr) == (0, "")
    if expected is None:
        assert done.stdout.startswith("True True True\n")
        expected = world.python(program).stdout
    assert done.stdout == expected


ERRORS = """
import threading, time, traceback
def fail():
    time.sleep(1)
    raise ValueError("in a thread")
thread = threading.Thread(target=fail, name="worker"); thread.start(); thread.join()
lock = threading.Lock()
def deep():
    try: lock.release()
    except RuntimeError: raise OSError("second")
try: deep()
except OSError: traceback.print_exc()
traceback.print_stack()
try: __import__("queue").Queue().get(timeout=1)
except Exception as error: print(traceback.format_exc())
import os, signal
threading.Timer(1, os.kill, [os.getpid(), signal.SIGINT]).start()
time.sleep(60)
"""


WRONG = """
import _thread, copy, pickle, os, select, signal, threading, time
for wrong in (
    lambda: copy.deepcopy(threading.Lock()), lambda: pickle.dumps(threading.RLock()), lambda: type(threading.Lock()),
    lambda: threading.Lock().acquire(timeout="1"), lambda: threading.RLock().acquire(False, 1), lambda: os.urandom("3"),
    lambda: signal.setitimer(signal.ITIMER_REAL, -1), lambda: signal.alarm("1"), lambda: _thread.start_new_thread(1, ()),
    lambda: _thread.start_new_thread(print, 1), lambda: threading.RLock().release(), lambda: threading.Lock().release(),
    lambda: time.sleep(), lambda: time.sleep("1"), lambda: time.sleep(None), lambda: time.sleep(1, 2),
    lambda: time.sleep(seconds=1), lambda: time.sleep(-1), lambda: time.sleep(float("nan")), lambda: time.sleep(2j),
    lambda: time.sleep(float("inf")), lambda: time.localtime("x"), lambda: time.asctime(None), lambda: time.strftime(),
    lambda: time.strftime(1), lambda: time.ctime("now"),
):
    try: print(wrong())
    except Exception as error: print(type(error).__name__, error)
print(time.sleep.__name__, time.sleep.__doc__, time.localtime.__module__)
"""


def test_wrong_calls_are_answered_as_in_real_time(world: World) -> None:
    fast = world.python(WRONG)
    real = world.run("python", "program.py")
    assert (fast.stdout, fast.stderr) == (real.stdout, real.stderr)


def test_hashes_are_the_same_each_time(world: World) -> None:
    command = 'python3 -c \'print(hash("day6"), {"a", "b", "c"})\''
    assert world.fast(command).stdout == world.fast(command).stdout != ""


def test_a_module_of_the_programs_own_with_a_name_of_pythons_stays_as_it_is(world: World) -> None:
    for name in ("random", "secrets"):
        world.file(f"{name}.py", "mine = True")
    assert world.python("import random, secrets\nprint(random.mine, secrets.mine)").stdout == "True True\n"


def test_tracebacks_are_those_of_real_time(world: World) -> None:
    fast = world.python(ERRORS)
    real = world.run("python", "program.py")
    assert fast.stderr == real.stderr
    assert (fast.returncode, fast.stdout) == (real.returncode, real.stdout)
    assert "KeyboardInterrupt" in fast.stderr
