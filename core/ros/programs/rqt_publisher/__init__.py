"""rqt_publisher: publishes messages whose fields are expressions. `model` is what the window reads, `rqt_publisher` the program."""
