"""rqt_publisher: publishes messages of expressions. `model` is what the window reads, `rqt_publisher` is the program."""
