"""Errors that can occur with photographs, terrain models and outputs; each message tells the user the remedy."""

from __future__ import annotations

from typing import Any

from .messages import Message


class SkylineViewshedError(Exception):
    """Base of all errors that a user can act on; its `Message` tells the user what to do."""

    @property
    def message(self) -> Message:
        """The `Message`, for the code that translates it; `str(error)` is the plain English sentence."""
        return self.args[0]

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as message and attributes, whatever the arguments of `__init__`: errors cross processes."""
        return _restored, (type(self), self.args, self.__dict__)


def _restored(kind: type[SkylineViewshedError], args: tuple[Any, ...], state: dict[str, Any]) -> SkylineViewshedError:
    error: SkylineViewshedError = kind.__new__(kind)
    error.args = args
    error.__dict__.update(state)
    return error


class PhotoError(SkylineViewshedError):
    """One photograph cannot be used. A batch continues with the next one."""


class UnreadablePhotoError(PhotoError):
    """The file is missing, empty, damaged, too large or in a format that cannot be decoded here."""

    def __init__(self, path: object, reason: str) -> None:
        self.path, self.reason = str(path), reason
        super().__init__(Message("The photo {path} cannot be read: {reason}", path=self.path, reason=reason))


class MissingMetadataError(PhotoError):
    """A value that the method needs is neither in the file nor given by the user."""


class SkylineNotFoundError(PhotoError):
    """The picture contains no plausible boundary between sky and terrain."""

    def __init__(self, reason: str) -> None:
        super().__init__(
            Message(
                "{reason} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline.",
                reason=reason,
            )
        )


class TerrainError(SkylineViewshedError):
    """The elevation model as a whole cannot be used, so a batch ends early."""


class UnusableDemError(TerrainError):
    """The raster cannot serve as a DEM: no CRS, rotated, no valid cell, unreadable band."""


class ObserverError(PhotoError):
    """The terrain model has no usable data at this photo's position."""


class ObserverOutsideDemError(ObserverError):
    """The position lies outside the raster."""

    def __init__(self, longitude_deg: float, latitude_deg: float) -> None:
        self.longitude_deg, self.latitude_deg = longitude_deg, latitude_deg
        super().__init__(
            Message(
                "The position {latitude}, {longitude} (latitude, longitude) lies outside the DEM. "
                "Use a DEM that covers it, or correct the photo's coordinates.",
                latitude=f"{latitude_deg:.5f}",
                longitude=f"{longitude_deg:.5f}",
            )
        )


class NoElevationAtObserverError(ObserverError):
    """The position lies on a raster cell without data."""

    def __init__(self, longitude_deg: float, latitude_deg: float) -> None:
        self.longitude_deg, self.latitude_deg = longitude_deg, latitude_deg
        super().__init__(
            Message(
                "The DEM has no elevation (nodata) at {latitude}, {longitude} (latitude, longitude). "
                "Fill the void, use another DEM, or give the eye's elevation in HEIGHT_FIELD.",
                latitude=f"{latitude_deg:.5f}",
                longitude=f"{longitude_deg:.5f}",
            )
        )


class MissingPackageError(SkylineViewshedError):
    """A feature needs an optional package that is not installed."""


class OutputError(SkylineViewshedError):
    """A result cannot be written: the folder does not exist or is read-only, or the disk is full."""

    @classmethod
    def of_file(cls, path: object, reason: str) -> OutputError:
        """Make the error for a file from the reason: text from the operating system, or a `Message`."""
        return cls(
            Message(
                "The file {path} cannot be written: {reason}. Choose another folder or free some space.",
                path=path,
                reason=reason,
            )
        )


class UnreadableFeaturesError(SkylineViewshedError):
    """A file of drawn image features is missing, damaged or in an unknown format."""

    def __init__(self, path: object, reason: str) -> None:
        self.path, self.reason = str(path), reason
        super().__init__(Message("The image features {path} cannot be read: {reason}", path=self.path, reason=reason))


class Cancelled(BaseException):
    """The user stopped the run. This is not an error: it derives from `BaseException`, so error handlers ignore it."""
