"""Virtual time: the processes of a graph share a clock that goes on only when all of them wait, and run one at a time.

So a run takes no longer than what is computed in it, and is the same each time. Nothing of the programs is changed, nor of ours:
Python imports `startup/sitecustomize.py` in each process of such a world, which puts in place what waits or tells the time
(`follow`); the rest of day6-tui doesn't know. The threads of a process are the `kernel`'s, the processes the `coordinator`'s.

A world with a person in it, the desktop's, is `paced`: time goes on as fast as the person wants, and what draws the picture and
takes keys lives in real time. Where many programs begin, as in grading, interpreters are `ready` for them.

`surroundings` says how a world begins, and what its processes find in their environment.
"""
