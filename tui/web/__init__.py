"""The browser door: `day6-tui serve` gives every pupil a desktop in a browser tab."""
