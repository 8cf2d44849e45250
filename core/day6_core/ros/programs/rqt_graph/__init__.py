"""rqt_graph: the picture of nodes and topics. `model` is what the window reads, `rqt_graph` is the program."""
