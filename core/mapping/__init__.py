"""From a picture to the map and back, for a photograph of known pose."""
