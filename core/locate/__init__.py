"""From the skyline of a picture and the horizons of many places to the place where the picture was taken."""
