"""rqt_plot: numbers over time. `model` is what the window reads, `rqt_plot` is the program."""
