"""From a picture to the rows in which its sky ends."""
