"""All file access of the core: photographs, rasters, vector files and coordinate systems."""
