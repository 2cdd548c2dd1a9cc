"""Turn raw pictures into those of docs/images: cropped, few colours, below 200 kB each; and put the overview together.

Usage: publish.py WORK TARGET
"""

from __future__ import annotations

import io
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image, ImageDraw

LARGEST_BYTES = 195_000
PANEL_BYTES = 80_000
"""The page of the Photo view has many pictures, and all together must stay small."""
PAGE_WIDTH, PAGE_HEIGHT = 1180, 6000
GAP = 6
"""Between frames [pixels]."""
ACCEPTED_BAR = (26, 127, 55)
"""Colour of the bar at the left of an accepted photo's card."""
SHOWN_CARD = 2
"""The photo `morning`, in which a cloud hides part of the ridge."""
CARD_HEAD = 412
"""Height of a card's picture and verdict [pixels]."""


def main(work, target):
    target.mkdir(parents=True, exist_ok=True)
    for raw in sorted((work / "raw").glob("*.png")):
        panel = raw.name.startswith("panel-")
        save_small(Image.open(raw).convert("RGB"), target / raw.name, PANEL_BYTES if panel else LARGEST_BYTES)
    save_small(sequence(sorted((work / "frames").glob("*.png"))), target / "panel-sequence.png", PANEL_BYTES)
    report = work / "results" / "report.html"
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not (report.exists() and browser):
        raise SystemExit("The report cannot be pictured: no report, or no Chromium.")
    page = photograph(browser, report)
    cards = card_rows(page)
    top, bottom = cards[SHOWN_CARD]
    card = page.crop((8, top - 8, PAGE_WIDTH - 8, bottom + 8))
    save_small(page.crop((0, 0, PAGE_WIDTH, cards[0][1] + 12)), target / "report.png")
    save_small(card, target / "report_card.png")
    save_small(overview(card, Image.open(work / "strip.png").convert("RGB")), target / "overview.png")


def sequence(paths):
    """Put the skylines of the frames of a rescue side by side, in rows of two."""
    frames = [skyline_part(Image.open(path).convert("RGB")) for path in paths]
    width = PAGE_WIDTH // 2 - GAP
    height = round(frames[0].height * width / frames[0].width)
    rows = (len(frames) + 1) // 2
    whole = Image.new("RGB", (2 * width + GAP, rows * (height + GAP) - GAP), "white")
    for number, one in enumerate(frames):
        small = one.resize((width, height), Image.LANCZOS)
        ImageDraw.Draw(small).text((8, 6), str(number + 1), fill="white", font_size=24)
        whole.paste(small, (number % 2 * (width + GAP), number // 2 * (height + GAP)))
    return whole


def skyline_part(frame):
    """Give the part of a frame in which the horizon moves."""
    width, height = frame.size
    return frame.crop((round(0.14 * width), round(0.45 * height), round(0.86 * width), round(0.9 * height)))


def photograph(browser, report):
    """Picture a page from its top."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "page.png"
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]
        command += [f"--user-data-dir={folder}/profile", f"--window-size={PAGE_WIDTH},{PAGE_HEIGHT}"]
        command += [f"--screenshot={picture}", report.as_uri()]
        subprocess.run(command, check=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=180)
        return Image.open(picture).convert("RGB")


def card_rows(page):
    """First and last row of each card, found by the bar at its left."""
    column = [page.getpixel((18, row)) for row in range(page.height)]
    inside = [max(abs(a - b) for a, b in zip(colour, ACCEPTED_BAR)) < 12 for colour in column] + [False]
    rows, start = [], None
    for row, yes in enumerate(inside):
        if yes and start is None:
            start = row
        elif not yes and start is not None:
            rows.append((start, row))
            start = None
    return [(first, last) for first, last in rows if last - first > 200]


def overview(card, strip):
    """Photo and verdict above, the ground that it shows below."""
    head = card.crop((0, 0, card.width, CARD_HEAD))
    strip = strip.resize((card.width, round(strip.height * card.width / strip.width)), Image.LANCZOS)
    whole = Image.new("RGB", (card.width, CARD_HEAD + strip.height), "white")
    whole.paste(head, (0, 0))
    whole.paste(strip, (0, CARD_HEAD))
    return whole


def save_small(image, path, largest_bytes=LARGEST_BYTES):
    """Save with as many colours and pixels as fit into the size."""
    for scale, colours in ((1, 256), (1, 128), (1, 64), (0.85, 128), (0.85, 64), (0.7, 128), (0.7, 64), (0.5, 64)):
        smaller = image.resize((round(image.width * scale), round(image.height * scale)), Image.LANCZOS)
        # The octree keeps rare strong colours, such as those of drawn lines, which a median cut would mix away.
        few = smaller.quantize(colours, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        buffer = io.BytesIO()
        few.save(buffer, "PNG", optimize=True)
        if buffer.tell() < largest_bytes:
            path.write_bytes(buffer.getvalue())
            print(f"{path.name}: {smaller.width} x {smaller.height}, {colours} colours, {buffer.tell() // 1000} kB")
            return
    raise SystemExit(f"{path.name} cannot be made smaller than {largest_bytes} bytes")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
