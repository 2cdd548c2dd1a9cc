"""Find the pose at which the DEM horizon fits the skyline of a picture."""
