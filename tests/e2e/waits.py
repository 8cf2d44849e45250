"""How a program tells that its main thread waits, also inside a call of a library that tells nobody."""

from __future__ import annotations

READY = """\
def ready():
    import sys, threading, time
    main = threading.main_thread().ident

    def watch():
        seen = []
        while len(seen) < 5 or len(set(seen[-5:])) > 1:
            time.sleep(0.01)
            frame = sys._current_frames()[main]
            seen.append((frame.f_code, frame.f_lasti))
        print('ready', flush=True)

    threading.Thread(target=watch, daemon=True).start()

"""
"""Code of a function that has 'ready' printed once the main thread stays where it is, which is in the call that follows."""
