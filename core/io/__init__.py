"""The only place of the core that touches files: photographs, rasters, coordinate systems."""
