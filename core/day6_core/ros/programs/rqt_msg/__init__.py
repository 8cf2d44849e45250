"""rqt_msg: browses message types. `model` is what the type browsers' windows read, `rqt_msg` is the program."""
