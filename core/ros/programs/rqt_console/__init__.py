"""rqt_console: the log of all nodes. `_model` keeps and chooses the messages, `rqt_console` is the program."""
