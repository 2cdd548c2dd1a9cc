"""The error family: what can go wrong with a photograph or a terrain model, each with its remedy."""


class SkylineViewshedError(Exception):
    """Base of all errors that a user can act on; the message says what to do."""


class PhotoError(SkylineViewshedError):
    """One photograph cannot be used. A batch goes on with the next."""


class UnreadablePhotoError(PhotoError):
    """The file is missing, empty, damaged, too large or of a kind that cannot be decoded here."""

    def __init__(self, path, reason):
        self.path, self.reason = str(path), reason
        super().__init__(f"The photo {self.path} cannot be read: {reason}")


class MissingMetadataError(PhotoError):
    """A fact that the method needs is neither in the file nor given by the user."""

    def __init__(self, fact, remedy):
        self.fact, self.remedy = fact, remedy
        super().__init__(f"The photo has no {fact}. {remedy}")


class SkylineNotFoundError(PhotoError):
    """No believable boundary between sky and terrain in the picture."""

    def __init__(self, reason="No boundary between sky and terrain was found."):
        super().__init__(
            f"{reason} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline."
        )


class TerrainError(SkylineViewshedError):
    """The elevation model as a whole cannot be used. A batch ends early."""


class UnusableDemError(TerrainError):
    """The raster cannot serve as a DEM: no CRS, rotated, no valid cell, unreadable band."""


class ObserverError(PhotoError):
    """The terrain model has nothing to offer at this photo's position."""


class ObserverOutsideDemError(ObserverError):
    """The position lies outside the raster."""

    def __init__(self, longitude_deg, latitude_deg):
        self.longitude_deg, self.latitude_deg = longitude_deg, latitude_deg
        super().__init__(
            f"The position {latitude_deg:.5f}, {longitude_deg:.5f} (latitude, longitude) lies outside the DEM. "
            "Use a DEM that covers it, or correct the photo's coordinates."
        )


class NoElevationAtObserverError(ObserverError):
    """The position lies on a void of the raster."""

    def __init__(self, longitude_deg, latitude_deg):
        self.longitude_deg, self.latitude_deg = longitude_deg, latitude_deg
        super().__init__(
            f"The DEM has no elevation (nodata) at {latitude_deg:.5f}, {longitude_deg:.5f} (latitude, longitude). "
            "Fill the void, use another DEM, or give the eye's elevation in HEIGHT_FIELD."
        )


class MissingPackageError(SkylineViewshedError):
    """An optional package is needed for this one feature and is not installed."""


class OutputError(SkylineViewshedError):
    """A result cannot be written: no such folder, read-only, disk full."""


class UnreadableFeaturesError(SkylineViewshedError):
    """A file of drawn image features is missing, damaged or in none of the known formats."""

    def __init__(self, path, reason):
        self.path, self.reason = str(path), reason
        super().__init__(f"The image features {self.path} cannot be read: {reason}")


class Cancelled(BaseException):
    """The user stopped the run. Not an error, and no handler of errors swallows it."""
