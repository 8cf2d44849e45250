"""The picture of nodes and topics without a screen; `rqt_graph.RqtGraph` is what the window reads.

`content` holds the rules of its filters. `layout` places boxes and edges, with `layers` (order), `places` (rows and columns),
`clusters` (namespace boxes) and `shapes` (the plain data); `drawing` turns that into text, `fit` chooses what fits a window,
`dot` and `image` write and read files.
"""
