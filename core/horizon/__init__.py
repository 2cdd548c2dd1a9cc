"""From a DEM to elevation angles: horizon profile, inner ridges, sky view, panorama."""
