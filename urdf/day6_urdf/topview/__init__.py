"""A robot seen from above.

`plan` finds its parts, `frame` says where they are in a picture, `paint` draws them with anything that can fill a polygon
(`blocks` here: half blocks, whole cells, braille; in the desktop also real pixels), `letters` draws them with ASCII alone,
`words` finds room for what is written beside them, and `view` puts all of it together.
"""
