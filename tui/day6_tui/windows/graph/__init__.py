"""rqt_graph's window."""
