# SPDX-License-Identifier: BSD-3-Clause
"""Pictures with their names below, in rows; and small PNG files."""
from PIL import Image, ImageDraw, ImageFont

GAP = 9             # [px]
LABEL = 30          # [px], height
BACKGROUND = (255, 255, 255)
FONTS = ("DejaVuSans.ttf", "LiberationSans-Regular.ttf")


def font_of(size):
    for name in FONTS:
        try:
            return ImageFont.truetype(name, size)
        except OSError:
            pass
    raise RuntimeError(f"none of these fonts is installed: {', '.join(FONTS)}")


def sheet(tiles, columns):
    """`tiles`: (name, picture), all of one size."""
    width, height = tiles[0][1].size
    rows = -(-len(tiles) // columns)
    image = Image.new("RGB", (columns * (width + GAP) - GAP, rows * (height + LABEL + GAP) - GAP),
                      BACKGROUND)
    draw, font = ImageDraw.Draw(image), font_of(20)
    for i, (name, picture) in enumerate(tiles):
        x, y = (i % columns) * (width + GAP), (i // columns) * (height + LABEL + GAP)
        image.paste(picture, (x, y))
        draw.rectangle([x, y, x + width - 1, y + height - 1], outline=(190, 190, 190))
        draw.text((x + width / 2, y + height + LABEL / 2), name, (20, 20, 20), font, anchor="mm")
    return image


def save(image, path):
    """With a palette in which the colours of thin lines are kept: that of median cut follows areas."""
    image.quantize(256, method=Image.MAXCOVERAGE, kmeans=1, dither=Image.NONE).save(
        path, optimize=True)
