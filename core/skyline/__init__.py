"""Find the rows of a picture in which the sky ends."""
