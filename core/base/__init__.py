"""Values, camera, terrain, angles, pictures, errors and progress, on which all other rooms depend."""
