"""From a DEM to elevation angles: the horizon profile, inner ridges, the sky view factor and the panorama."""
