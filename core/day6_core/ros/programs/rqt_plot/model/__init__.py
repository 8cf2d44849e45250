"""Curves without a screen: `field` finds numbers in messages, `plot` keeps them, `axis` and `lines` are for drawing."""
