"""What every room stands on: values, camera, terrain, angles, pictures, errors and progress."""
