"""The programs of the tf2 tutorials: a turtle's place as a frame, and a turtle that follows a frame."""
