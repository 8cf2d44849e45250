"""A class on a network: each pupil's graph stays a graph of its own, and the teacher has all of them below /<name>.

The teacher's machine runs a router (`teacher`), each pupil's is a client of it (`pupil`): peers do not forward for each
other, and a router alone can refuse. What pupils send begins with UP, what the teacher sends with DOWN, and the router lets
nothing else through (`access`), so no pupil reaches another. `naming` wraps the keys of a graph into these and renames them;
beside them go the messages of `day6_core/classroom`, which are only bytes here. In a room (`--room`) nothing is renamed: all are
in one graph.
"""
