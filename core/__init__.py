"""The simulator. Knows nothing of Textual: `tui` may import it, it imports neither `tui` nor `textual` nor `rich`.

From the ground up: `graph` and `interfaces` (nodes, messages; each alone), `link` (joins the graphs of several processes),
`session` (what a program of ours gets), `ros` (what a ROS installation provides), `workspace` (colcon), `shell` (the simulated
machine that has all this). What is imported with a module lies below it; upwards only functions import, where they run.
"""
