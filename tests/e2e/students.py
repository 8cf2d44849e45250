"""Programs as students make them of the lesson's, and some of their own."""

from __future__ import annotations

from tests.e2e import lesson_files
from tests.e2e.lesson_files import WHEEL_SPINNER

TALKER = lesson_files.TALKER.replace("Hello from Day 6: %d", "line %d of the talker").replace("Publishing", "I said")

WRONG_NAMES = WHEEL_SPINNER.replace("left_wheel_joint", "wheel_left_joint").replace(
    "right_wheel_joint", "wheel_right_joint"
)
"""The commonest slip of the lesson."""

STUBBORN = """\
import signal
import time

signal.signal(signal.SIGINT, signal.SIG_IGN)
print('you cannot stop me', flush=True)
while True:
    time.sleep(1)
"""

ASKS = """\
import select
import sys
select.select([sys.stdin], [], [])  # asks only when the answer is there
name = input('Your name? ')
print(f'Hello {name}!')
"""
