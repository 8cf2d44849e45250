"""rqt_action: browses action types and shows the live actions. `model` is what the window reads, `rqt_action` the program."""
