"""The simulator, without user interface: `tui` may import it; it imports neither `tui` nor `textual` nor `rich`.

From the bottom up: small modules for everybody (the files here), `graph` and `interfaces` (nodes, messages; independent of each
other), `link` (joins the graphs of several processes), `session` (the environment of our own programs), `ros` (the contents of
a ROS installation), `workspace` (colcon), `shell` (the simulated machine with all of this). A module imports only lower layers,
inside functions too; the layers are in pyproject.toml. A lower layer gets what it needs of a higher one as an argument: a
callable, or an object for which it has a Protocol.
"""
