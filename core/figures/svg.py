"""Drawings as SVG text: a few elements, linear scales, ticks, and one style sheet for light and dark.

Figures have classes, not colours. In a page the style sheet is in the head once, and its CSS variables can be
redefined; `standalone` puts it into the figure, which then is a file of its own. No style attribute is written, so that
a page may forbid them (Content-Security-Policy).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.angles import wrap_360
from .text import escape

NAMESPACE = "http://www.w3.org/2000/svg"

LIGHT = {
    "ink": "#1c2430",
    "muted": "#5d6978",
    "line": "#d5dbe3",
    "paper": "#ffffff",
    "best": "#d95f02",
    "extracted": "#0086a3",
    "alternative": "#b5179e",
    "compass": "#3d7a1f",
    "shade": "#8593a5",
}
"""Colours on white: orange for the DEM and the answer, cyan for the picture, magenta for the alternatives, green for
the compass."""

DARK = {
    "ink": "#e6ebf2",
    "muted": "#9aa7b8",
    "line": "#333e4d",
    "paper": "#171d26",
    "best": "#ff9a3c",
    "extracted": "#35d0ee",
    "alternative": "#f06bdc",
    "compass": "#8fd464",
    "shade": "#66748a",
}
"""The same hues on a dark page."""

DISTANCE_LIGHT = ("#3b3226", "#55503f", "#5f6f5a", "#5d8a80", "#6f9fae", "#8fb4cc", "#b4cbe2", "#d5e1ef")
DISTANCE_DARK = ("#8d7a5e", "#86845f", "#72896a", "#5d8a80", "#4f8096", "#47708f", "#3d5c7c", "#334862")
"""From near to far, as haze colours mountains: brown, green, blue, pale (on the dark page, fading into it)."""


@dataclass(frozen=True)
class Scale:
    """Linear map from values to drawing units; `start` and `stop` may be in either order."""

    low: float
    high: float
    start: float
    stop: float

    def __call__(self, value):
        """Map values (scalar or array) to positions."""
        span = self.high - self.low or 1.0
        return self.start + (np.asarray(value, float) - self.low) / span * (self.stop - self.start)


def ticks(low, high, count=5):
    """Choose round values, 1, 2 or 5 times a power of ten apart, within [low, high], about `count` of them.

    Parameters
    ----------
    low, high : float
    count : int

    Returns
    -------
    array
        Only `low` if `high` is not above it.
    """
    if not high > low:
        return np.array([low])
    rough = (high - low) / max(count, 1)
    power = 10.0 ** np.floor(np.log10(rough))
    step = power * next(m for m in (1, 2, 5, 10) if m * power >= rough * 0.999)
    first, last = np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9)
    return np.arange(first, last + 1) * step + 0.0


def round_below(value):
    """Largest 1, 2 or 5 times a power of ten that does not exceed a positive value: the length of a scale bar."""
    power = 10.0 ** np.floor(np.log10(value) + 1e-9)
    return float(power * max(m for m in (1, 2, 5) if m * power <= value * (1 + 1e-9)))


def spans_360(first_deg, width_deg):
    """Cut an arc that starts at `first_deg`, clockwise, into spans (from, to) of the axis 0 to 360 [degrees]."""
    first = float(wrap_360(first_deg))
    last = first + min(float(width_deg), 360.0)
    return [(first, min(last, 360.0))] + ([(0.0, last - 360.0)] if last > 360 else [])


def element(name, content="", **attributes):
    """Write an element. Trailing underscores of names are dropped, inner ones become hyphens; None is left out."""
    given = {key.rstrip("_").replace("_", "-"): value for key, value in attributes.items() if value is not None}
    written = "".join(f' {key}="{_value(value)}"' for key, value in given.items())
    return f"<{name}{written}>{content}</{name}>" if content else f"<{name}{written}/>"


def text(x, y, words, class_="label", anchor="start", **attributes):
    """Write text at a position, escaped.

    Parameters
    ----------
    x, y : float
        Drawing units, y downwards.
    words : str
    class_ : str
        Class of the style sheet.
    anchor : str
        'start', 'middle' or 'end'.
    **attributes
        Further attributes of the element.
    """
    return element("text", escape(words), x=x, y=y, class_=class_, text_anchor=anchor, **attributes)


def line(x1, y1, x2, y2, class_):
    """Draw a straight line.

    Parameters
    ----------
    x1, y1, x2, y2 : float
        Its ends in drawing units, y downwards.
    class_ : str
        Class of the style sheet.
    """
    return element("line", x1=x1, y1=y1, x2=x2, y2=y2, class_=class_)


def polyline_path(x, y):
    """Path data of a line through points, broken where either coordinate is not finite; '' if nothing is left.

    Coordinates are rounded to tenths of a drawing unit and written as steps between points, half as long as positions.
    """
    return "".join(_trace(x[run], y[run]) for run, x, y in _known_runs(x, y))


def area_path(x, y, base):
    """Path data of the area between a line and the level `base`; nothing for unknown stretches.

    Parameters
    ----------
    x, y : (N,) arrays
        The line in drawing units, y downwards; not finite where unknown.
    base : float
        The y of the base level.
    """
    return "".join(
        _trace(np.r_[x[run.start], x[run], x[run.stop - 1]], np.r_[base, y[run], base]) + "Z"
        for run, x, y in _known_runs(x, y)
    )


def _known_runs(x, y):
    x, y = np.asarray(x, float), np.asarray(y, float)
    edges = np.flatnonzero(np.diff(np.r_[False, np.isfinite(x) & np.isfinite(y), False].astype(int)))
    return [(slice(first, stop), x, y) for first, stop in zip(edges[::2], edges[1::2])]


def _trace(x, y):
    tenths = np.rint(np.column_stack([x, y]) * 10).astype(np.int64)
    # Rounding positions, not steps, keeps errors from adding up.
    steps = " ".join(f"{a / 10:g} {b / 10:g}" for a, b in np.diff(tenths, axis=0).tolist())
    first_x, first_y = (tenths[0] / 10).tolist()
    return f"M{first_x:.10g} {first_y:.10g}" + (f"l{steps}" if steps else "")


def sector_path(centre_x, centre_y, inner, outer, from_deg, width_deg):
    """Path data of a ring's sector, azimuths clockwise from the top, `width_deg` clockwise from `from_deg`.

    Parameters
    ----------
    centre_x, centre_y : float
        Drawing units, y downwards.
    inner, outer : float
        Radii; an inner one of 0 or less gives a slice.
    from_deg, width_deg : float
        First azimuth, and the angle that the sector spans clockwise from it [degrees].
    """
    width_deg = min(float(width_deg), 359.99)
    large = int(width_deg > 180)

    def at(radius, azimuth_deg):
        x, y = on_circle(centre_x, centre_y, radius, azimuth_deg)
        return f"{_number(x)} {_number(y)}"

    last = from_deg + width_deg
    outer_arc = f"M{at(outer, from_deg)}A{_number(outer)} {_number(outer)} 0 {large} 1 {at(outer, last)}"
    if inner <= 0:
        return f"{outer_arc}L{_number(centre_x)} {_number(centre_y)}Z"
    return f"{outer_arc}L{at(inner, last)}A{_number(inner)} {_number(inner)} 0 {large} 0 {at(inner, from_deg)}Z"


def on_circle(centre_x, centre_y, radius, azimuth_deg):
    """Point at an azimuth, clockwise from the top.

    Parameters
    ----------
    centre_x, centre_y, radius : float
        Circle in drawing units, y downwards.
    azimuth_deg : float or array
        [degrees]

    Returns
    -------
    x, y : float or array
    """
    angle = np.radians(azimuth_deg)
    return centre_x + radius * np.sin(angle), centre_y - radius * np.cos(angle)


def figure(width, height, title, description, *parts, class_="figure"):
    """Wrap parts into an accessible drawing: role, name and description are read out; the name is also a tooltip.

    Parameters
    ----------
    width, height : float
        Size of the drawing, in its own units.
    title, description : str
        Plain text; it is escaped.
    *parts : str
        Elements, in the order in which they are drawn.
    class_ : str
        Class of the style sheet.
    """
    body = "".join((element("title", escape(title)), element("desc", escape(description, 2000)), *parts))
    return (
        f'<svg class="{class_}" viewBox="0 0 {_number(width)} {_number(height)}" '
        f'role="img" aria-label="{escape(title)}">{body}</svg>'
    )


def standalone(drawing):
    """Make a figure a file of its own, with its namespace and a style sheet that follows light or dark themes."""
    end = drawing.index(">")
    return f'{drawing[:end]} xmlns="{NAMESPACE}"><style>{STYLE}</style>{drawing[end + 1 :]}'


def _number(value):
    return f"{round(float(value), 2) + 0.0:.2f}".rstrip("0").rstrip(".")


def _value(value):
    return _number(value) if isinstance(value, (int, float, np.number)) else value


def _variables(colours, distances):
    named = "".join(f"--{name}:{colour};" for name, colour in colours.items())
    return named + "".join(f"--far{index}:{colour};" for index, colour in enumerate(distances))


_RULES = """
.figure{display:block;width:100%;height:auto;font:12px system-ui,'Segoe UI','DejaVu Sans',sans-serif}
.label{fill:var(--muted);font-size:11px}.name{fill:var(--ink);font-size:12px}
.strong{fill:var(--ink);font-size:12px;font-weight:600}
.name-best{fill:var(--best);font-weight:600;font-size:12px}.name-alternative{fill:var(--alternative);font-size:11px}
.name-compass{fill:var(--compass);font-size:11px}
.name-best,.name-alternative,.name-compass{paint-order:stroke;stroke:var(--paper);stroke-width:3px;stroke-linejoin:round}
.grid{stroke:var(--line);stroke-width:1;fill:none}.axis{stroke:var(--muted);stroke-width:1;fill:none}
.curve{stroke:var(--ink);stroke-width:1.3;fill:none;stroke-linejoin:round}
.under{fill:var(--shade);fill-opacity:.18}
.best{stroke:var(--best);stroke-width:2;fill:none}.mark-best{fill:var(--best);stroke:var(--paper);stroke-width:1.5}
.alternative{stroke:var(--alternative);stroke-width:1.5;stroke-dasharray:5 3;fill:none}
.mark-alternative{fill:var(--paper);stroke:var(--alternative);stroke-width:2}
.compass{stroke:var(--compass);stroke-width:1.5;stroke-dasharray:1.5 3;stroke-linecap:round;fill:none}
.mark-compass{fill:var(--compass)}
.interval{fill:var(--best);fill-opacity:.22;stroke:none}.view{fill:var(--best);fill-opacity:.13;stroke:none}
.residual{stroke:var(--extracted);stroke-width:1.4;fill:none}.residual-fill{fill:var(--extracted);fill-opacity:.2}
.zero{stroke:var(--best);stroke-width:1.5;fill:none}
.unknown{fill:var(--shade);fill-opacity:.28}.clipped{fill:var(--alternative);fill-opacity:.16}
.arrow{fill:var(--ink);stroke:none}
.bars{fill:var(--shade);fill-opacity:.6}
.dots{fill:none;stroke-width:5;stroke-linecap:round;stroke-opacity:.7}
.bias{stroke-width:1.5;stroke-dasharray:6 3}
.device0{stroke:var(--best)}.device1{stroke:var(--extracted)}.device2{stroke:var(--alternative)}.device3{stroke:var(--compass)}
.horizon{stroke:var(--ink);stroke-width:1;fill:none;stroke-linejoin:round}
"""


def _style():
    far = "".join(f".far{index}{{fill:var(--far{index});stroke:none}}" for index in range(len(DISTANCE_LIGHT)))
    dark = _variables(DARK, DISTANCE_DARK)
    return (
        f":root{{color-scheme:light dark;{_variables(LIGHT, DISTANCE_LIGHT)}}}"
        f"@media (prefers-color-scheme:dark){{:root{{{dark}}}}}" + _RULES.replace("\n", "") + far
    )


STYLE = _style()
"""The figures' style sheet: variables for light and dark, and the classes."""
