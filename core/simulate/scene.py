"""The appearance of a simulated photograph: light, weather, ground cover, foreground and camera faults."""

from __future__ import annotations

from dataclasses import dataclass

CLOUDS = ("none", "behind", "lid", "fog", "valley")
FOREGROUNDS = ("none", "trees", "people")


@dataclass(frozen=True)
class SceneOptions:
    """Light, weather and camera of one simulated photograph.

    Attributes
    ----------
    seed : int
        Seed of everything random; the same seed gives the same picture.
    sun_azimuth_deg, sun_elevation_deg : float
        Azimuth clockwise from true north and elevation above the horizontal [degrees]; see
        `base.sun_moon.sun_direction_deg`.
    range_m : float
        Distance up to which terrain is drawn [m].
    visibility_m : float
        Meteorological visual range at sea level (contrast falls to 2 %) [m].
    snow_line_m, tree_line_m : float or None
        Elevations above which snow lies and below which forest grows [m]; None takes the shares below.
    snow_share, tree_share : float
        Upper share of the relief in view under snow, and lower share under forest; values beyond 0 and 1 mean none
        and all.
    clouds : str
        'none'; 'behind' the ridge; 'lid', hanging in front of the ridge over `cloud_share` of the width; 'fog', which
        hides nearly all of the ridge; 'valley', a layer below the ridge.
    cloud_share : float
        Share of the width under a lid, or of the sky behind (0 to 1).
    foreground : str
        'none', 'trees' or 'people' near the camera.
    foreground_share : float
        Share of the width that the foreground covers.
    lake_elevation_m : float or None
        Flat ground below this is water that mirrors the sky [m].
    exposure_ev : float
        Deviation above (+) or below (-) the automatic exposure [stops].
    noise : float
        Standard deviation of the sensor's noise at mid-grey, in 8-bit steps.
    sharpening : float
        Strength of the unsharp mask (phones: 0.5 to 1).
    blur_px : float
        Standard deviation of lens and motion blur [pixels].
    vignetting : float
        Loss of light in the corners (0 to 1).
    texture : float
        Contrast of the ground's texture; 1 is natural.
    """

    seed: int = 0
    sun_azimuth_deg: float = 135.0
    sun_elevation_deg: float = 35.0
    range_m: float = 80_000.0
    visibility_m: float = 120_000.0
    snow_line_m: float | None = None
    tree_line_m: float | None = None
    snow_share: float = 0.34
    tree_share: float = 0.40
    clouds: str = "none"
    cloud_share: float = 0.3
    foreground: str = "none"
    foreground_share: float = 0.3
    lake_elevation_m: float | None = None
    exposure_ev: float = 0.0
    noise: float = 2.0
    sharpening: float = 0.6
    blur_px: float = 0.6
    vignetting: float = 0.15
    texture: float = 1.0

    def __post_init__(self):
        if self.clouds not in CLOUDS or self.foreground not in FOREGROUNDS:
            raise ValueError(f"clouds must be one of {CLOUDS} and foreground one of {FOREGROUNDS}, not {self}")
        if not (self.range_m > 0 and self.visibility_m > 0 and self.noise >= 0 and self.blur_px >= 0):
            raise ValueError(f"ranges must be positive, noise and blur not negative, in {self}")
        if not (0 <= self.cloud_share <= 1 and 0 <= self.foreground_share <= 1 and 0 <= self.vignetting < 1):
            raise ValueError(f"shares must lie between 0 and 1, in {self}")
