"""A class on a network, as a teacher's or a pupil's desktop takes part in it."""
