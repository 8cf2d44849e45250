"""rqt_console: the log of all nodes. `model` keeps and chooses the messages, `rqt_console` is the program."""
