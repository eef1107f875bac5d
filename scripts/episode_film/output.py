# SPDX-License-Identifier: BSD-3-Clause
"""Writes a film; what is not finished never has its name."""
import contextlib
import os
import pathlib
import zlib

import numpy
from PIL import Image

from command_line.refusal import Refusal

from .palette import MEANINGFUL

FORMATS = (".gif", ".mp4")
CODECS = ("avc1", "mp4v")  # H.264, which browsers play, where this OpenCV can; else MPEG-4
SAMPLES = 12               # pictures from which the colours of a GIF are chosen


class GifFile:
    """Pictures are kept compressed until all are there, for they share their colours."""

    def __init__(self, path, fps, colours):
        self.path, self.fps, self.colours = path, fps, colours
        self.size, self.packed = None, []

    def add(self, picture):
        self.size = picture.shape
        self.packed.append(zlib.compress(picture.tobytes(), 1))

    def _picture(self, k):
        return numpy.frombuffer(zlib.decompress(self.packed[k]), numpy.uint8).reshape(self.size)

    def _palette(self):
        """Rare colours count for more than they cover: people are small, the ground is large."""
        chosen = sorted({round(k) for k in numpy.linspace(0, len(self.packed) - 1, SAMPLES)})
        sample = numpy.concatenate([self._picture(k).reshape(-1, 3) for k in chosen])
        colours, counts = numpy.unique(sample, axis=0, return_counts=True)
        by_count = numpy.argsort(-counts, kind="stable")
        kept, others = by_count[:self.colours // 3], by_count[self.colours // 3:]
        meaningful = [round(255.0 * part) for colour in MEANINGFUL for part in colour]
        exact = (meaningful if self.colours > 3 * len(MEANINGFUL) else []) + \
            colours[kept].ravel().tolist()
        if len(others):
            weighed = numpy.repeat(colours[others], numpy.ceil(counts[others] ** 0.5).astype(int), 0)
            room = self.colours - len(exact) // 3
            found = Image.fromarray(weighed[numpy.newaxis]).quantize(room, Image.MEDIANCUT, dither=0)
            exact += found.getpalette()[:3 * room]
        return numpy.array(exact, dtype=numpy.int32).reshape(-1, 3)[:self.colours]

    def _indices(self, k, palette):
        """The nearest colour of each pixel."""
        pixels = self._picture(k).reshape(-1, 3).astype(numpy.int32)
        codes, places = numpy.unique(pixels @ (65536, 256, 1), return_inverse=True)
        colours = numpy.stack([codes >> 16, codes >> 8 & 255, codes & 255], axis=1)
        distances = ((colours[:, numpy.newaxis] - palette) ** 2).sum(axis=2)
        nearest = distances.argmin(axis=1).astype(numpy.uint8)
        return nearest[places.ravel()].reshape(self.size[:2])

    def _changes(self, palette):
        """Each picture with what is as before left out: transparent."""
        table = palette.ravel().tolist() + [0] * (3 * (self.colours - len(palette))) + [255] * 3
        before = None
        for k in range(len(self.packed)):
            indices = self._indices(k, palette)
            changed = indices if before is None else numpy.where(
                indices == before, self.colours, indices).astype(numpy.uint8)
            before = indices
            image = Image.fromarray(changed, "P")
            image.putpalette(table)
            yield image

    def close(self):
        first, *others = self._changes(self._palette())
        first.save(self.path, format="GIF", save_all=True, append_images=others, loop=0,
                   duration=round(1000.0 / self.fps), disposal=1, optimize=False,
                   transparency=self.colours)


class Mp4File:
    def __init__(self, path, fps, _):
        try:
            import cv2
        except ImportError:
            raise Refusal("an MP4 needs OpenCV for Python: install python3-opencv, or write a "
                          ".gif") from None
        self.cv2, self.path, self.fps, self.writer = cv2, path, fps, None

    def _open(self, size):
        for codec in CODECS:
            writer = self.cv2.VideoWriter(str(self.path), self.cv2.VideoWriter_fourcc(*codec),
                                          self.fps, size)
            if writer.isOpened():
                return writer
        raise Refusal("OpenCV cannot write an MP4 here: write a .gif")

    def add(self, picture):
        if self.writer is None:
            self.writer = self._open((picture.shape[1], picture.shape[0]))
        self.writer.write(numpy.ascontiguousarray(picture[:, :, ::-1]))

    def close(self):
        self.writer.release()


def require_output(name):
    """Where the film goes; refused before any work is done."""
    path = pathlib.Path(name)
    if path.suffix.lower() not in FORMATS:
        raise Refusal(f"--output: '{name}' must end with one of: {', '.join(FORMATS)}")
    if path.is_dir():
        raise Refusal(f"--output: '{name}' is a folder")
    if not path.parent.is_dir():
        raise Refusal(f"--output: there is no folder '{path.parent}'")
    if not os.access(path.parent, os.W_OK):
        raise Refusal(f"--output: the folder '{path.parent}' cannot be written")
    return path


@contextlib.contextmanager
def film_file(path, fps, colours):
    """A file to add pictures to, which gets its name when all went well."""
    kind = path.suffix.lower()
    partial = path.with_name(f".{path.stem}.{os.getpid()}.partial{kind}")
    try:
        film = (GifFile if kind == ".gif" else Mp4File)(partial, fps, colours)
        yield film
        film.close()
        os.replace(partial, path)
    except OSError as error:
        raise Refusal(f"--output: cannot write '{path}': {error.strerror}") from None
    finally:
        with contextlib.suppress(OSError):
            partial.unlink()
