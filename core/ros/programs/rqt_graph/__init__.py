"""rqt_graph: the picture of nodes and topics.

`_content` holds the rules of its filters, `_layout` places boxes and edges, `_drawing` turns them into text, `_fit`
chooses what fits a window, `_model` is what the window reads; `rqt_graph` is the program.
"""
