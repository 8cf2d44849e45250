"""rqt_graph: the picture of nodes and topics.

`_content` holds the rules of its filters. `_layout` places boxes and edges, with `_layers` (order), `_places` (rows and
columns), `_clusters` (namespace boxes) and `_shapes` (the plain data); `_drawing` turns that into text, `_fit` chooses what fits
a window, `_dot` and `_image` write and read files. `_model` is what the window reads; `rqt_graph` is the program.
"""
