"""How a program tells that its main thread waits, also inside a call of a library that tells nobody."""

from __future__ import annotations

READY = """\
def ready():
    import sys, threading, time
    main = threading.main_thread().ident

    number = threading.main_thread().native_id

    def look():
        frame = sys._current_frames()[main]
        try:
            with open(f'/proc/self/task/{number}/stat') as file:
                sleeps = file.read().rpartition(')')[2].split()[0] == 'S'
        except OSError:
            sleeps = True  # not Linux
        return frame.f_code, frame.f_lasti, sleeps

    def watch():
        seen = []
        while len(seen) < 5 or len(set(seen[-5:])) > 1 or not seen[-1][2]:
            time.sleep(0.01)
            seen.append(look())
        print('ready', flush=True)

    threading.Thread(target=watch, daemon=True).start()

"""
"""Code of a function that has 'ready' printed once the main thread waits where it is, which is in the call that follows.

On a busy machine it can be held up anywhere while others run, but then it isn't asleep.
"""
