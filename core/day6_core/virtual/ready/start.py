"""Runs `MODULE.main()` in a process whose forks can become programs: `python start.py MODULE`, see `forks.command`.

In such a fork the program runs from here, so that below it on the stack is one frame, which `follow.tracebacks` leaves out.
"""

import sys

if __name__ == "__main__":
    del sys.path[0]

    from day6_core.virtual.ready import unseen

    unseen.begin()

    from day6_core.virtual.ready.becoming import runner_of

    run = runner_of(sys.argv[1])
    if status := run():
        sys.exit(status)
