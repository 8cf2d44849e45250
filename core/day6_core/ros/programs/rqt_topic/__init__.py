"""rqt_topic: the topic monitor. `_measure` counts messages, `model` is what the window reads, `rqt_topic` is the program."""
