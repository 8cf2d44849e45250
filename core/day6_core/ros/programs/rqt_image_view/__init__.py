"""rqt_image_view 1.3 (Jazzy): `decoding` makes pixels of a message, `model` is what the window reads.

`rqt_image_view` is the program.
"""
