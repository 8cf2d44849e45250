"""rqt_robot_steering 2.0 (Jazzy): drives by two sliders. `model` is what the window reads, `rqt_robot_steering` the program."""
