"""Pictures of real pixels, where the terminal can show them: Kitty's graphics, Sixel, iTerm2's inline images.

`ask` finds out what the terminal can, `pictures` knows what is where on the screen, `kitty`, `sixel` and `iterm` write it,
`raster` draws, `sheet` is the cells below. Only `ask` and `pictures` are imported before a terminal has answered; the others
bring numpy.

The library textual-image was measured first (600x400 pixels, a turtle moving at 15 fps, two cores): its Sixel took 52 % of a
core and 69 kB a frame, its Kitty pictures 24 % and 145 kB, because it sends whole pictures, makes its widgets anew for each, and
writes beside Textual's driver. What is here sends the bands and columns that changed.
"""
