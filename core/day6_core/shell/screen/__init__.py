"""The picture of a terminal, made of what programs write: VT emulation, scrollback, wrapping anew."""
