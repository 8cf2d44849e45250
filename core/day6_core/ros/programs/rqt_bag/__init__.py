"""rqt_bag: the timeline of bags. `model` is what the window reads, `rqt_bag` is the program."""
