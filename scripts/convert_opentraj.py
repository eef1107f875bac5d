#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Brings a recording of OpenTraj into the CSV of recorded people: time_s,ped_id,x_m,y_m

  convert_opentraj.py obsmat FILE > people.csv
      FILE is an obsmat.txt: frame, person, x, z, y, velocities; 25 frames a second, metres.
  convert_opentraj.py vsp FILE --homography H.txt > people.csv
      FILE is an annotation.vsp: splines of x, y, frame, gaze in pixels from the centre of the
      picture, which H.txt takes to metres. Between two control points the way is a monotone cubic
      (PCHIP), sampled every 0.4 s.

Times begin with the first frame of the recording. People and metres go to standard error, to be
compared with what is expected. Exit status 2 and one line for a file that is none of these.
"""
import argparse
import math
import sys

FRAMES_PER_SECOND = 25.0
FRAMES_PER_SAMPLE = 10  # 0.4 s


def numbers_of(line, path, number):
    try:
        return [float(word) for word in line.split()]
    except ValueError:
        raise SystemExit(f"{path}:{number}: expected numbers, got '{line.strip()}'") from None


def read_obsmat(path):
    """(frame, person, x, y) of each row."""
    rows = []
    with open(path, encoding="ascii") as file:
        for number, line in enumerate(file, 1):
            values = numbers_of(line, path, number)
            if not values:
                continue
            if len(values) != 8:
                raise SystemExit(f"{path}:{number}: expected 8 columns, got {len(values)}")
            rows.append((values[0], int(values[1]), values[2], values[4]))
    return rows


def read_homography(path):
    with open(path, encoding="ascii") as file:
        rows = [numbers_of(line, path, i) for i, line in enumerate(file, 1) if line.strip()]
    if [len(row) for row in rows] != [3, 3, 3]:
        raise SystemExit(f"{path}: expected 3 rows of 3 numbers")
    return rows


def to_metres(homography, x, y):
    u, v, w = (row[0] * x + row[1] * y + row[2] for row in homography)
    return u / w, v / w


def read_splines(path):
    """For each person the control points (frame, x, y), by increasing frame."""
    with open(path, encoding="ascii") as file:
        lines = [(i, line.split(" - ")[0]) for i, line in enumerate(file, 1)]
    rows = [(i, numbers_of(line, path, i)) for i, line in lines if line.strip()]
    splines, missing = [], 0
    for number, values in rows[1:]:  # the first is the number of splines
        if missing == 0 and len(values) == 1:
            missing = int(values[0])
            splines.append({})
        elif missing > 0 and len(values) == 4:
            missing -= 1
            splines[-1][values[2]] = (values[0], values[1])
        else:
            raise SystemExit(f"{path}:{number}: expected a control point or their number")
    if missing > 0 or not splines or len(splines) != rows[0][1][0]:
        raise SystemExit(f"{path}: ends early, {len(splines)} of {rows[0][1][0]:g} splines")
    return [sorted((frame, x, y) for frame, (x, y) in spline.items()) for spline in splines]


def end_slope(h0, h1, d0, d1):
    slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if slope * d0 <= 0:
        return 0.0
    return 3 * d0 if d0 * d1 < 0 and abs(slope) > 3 * abs(d0) else slope


def slopes_of(t, y):
    """Fritsch and Carlson's: no overshoot between two points."""
    h = [b - a for a, b in zip(t, t[1:])]
    d = [(y[i + 1] - y[i]) / h[i] for i in range(len(h))]
    if len(d) == 1:
        return [d[0], d[0]]
    slopes = [end_slope(h[0], h[1], d[0], d[1])]
    for i in range(1, len(d)):
        if d[i - 1] * d[i] <= 0:
            slopes.append(0.0)
            continue
        w1, w2 = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
        slopes.append((w1 + w2) / (w1 / d[i - 1] + w2 / d[i]))
    return slopes + [end_slope(h[-1], h[-2], d[-1], d[-2])]


def pchip(t, y, at):
    """Values of the monotone cubic through (t, y) at increasing times within t."""
    slopes, values, i = slopes_of(t, y), [], 0
    for time in at:
        while i + 2 < len(t) and time > t[i + 1]:
            i += 1
        h = t[i + 1] - t[i]
        s = (time - t[i]) / h
        values.append((1 + 2 * s) * (1 - s) ** 2 * y[i] + s * (1 - s) ** 2 * h * slopes[i]
                      + s * s * (3 - 2 * s) * y[i + 1] + s * s * (s - 1) * h * slopes[i + 1])
    return values


def sample(splines, homography):
    """(frame, person, x, y) at every multiple of FRAMES_PER_SAMPLE; persons are numbered from 1."""
    rows = []
    for person, points in enumerate(splines, 1):
        if len(points) < 2:
            continue
        frames = [frame for frame, _, _ in points]
        places = [to_metres(homography, x, y) for _, x, y in points]
        first = math.ceil(frames[0] / FRAMES_PER_SAMPLE) * FRAMES_PER_SAMPLE
        at = range(first, math.floor(frames[-1]) + 1, FRAMES_PER_SAMPLE)
        ways = [pchip(frames, [place[axis] for place in places], at) for axis in (0, 1)]
        rows.extend((frame, person, x, y) for frame, x, y in zip(at, *ways))
    return rows


def write(rows):
    begin = min(row[0] for row in rows)
    print("time_s,ped_id,x_m,y_m")
    for frame, person, x, y in sorted(rows):
        print(f"{(frame - begin) / FRAMES_PER_SECOND:.2f},{person},{x:.3f},{y:.3f}")
    xs, ys = [row[2] for row in rows], [row[3] for row in rows]
    print(f"{len(rows)} rows, {len({row[1] for row in rows})} people, "
          f"{(max(row[0] for row in rows) - begin) / FRAMES_PER_SECOND:.1f} s, "
          f"x {min(xs):.2f} to {max(xs):.2f} m, y {min(ys):.2f} to {max(ys):.2f} m",
          file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("format", choices=["obsmat", "vsp"])
    parser.add_argument("file")
    parser.add_argument("--homography", help="3 x 3 numbers, from pixels to metres; for vsp")
    options = parser.parse_args()
    if (options.format == "vsp") != (options.homography is not None):
        parser.error("--homography goes with vsp, and vsp needs it")
    if options.format == "obsmat":
        rows = read_obsmat(options.file)
    else:
        rows = sample(read_splines(options.file), read_homography(options.homography))
    if not rows:
        raise SystemExit(f"{options.file}: nobody walks in it")
    write(rows)


if __name__ == "__main__":
    try:
        main()
    except (OSError, UnicodeDecodeError) as failure:
        print(f"convert_opentraj.py: {failure}", file=sys.stderr)
        sys.exit(2)
    except SystemExit as end:
        if not isinstance(end.code, str):
            raise
        print(f"convert_opentraj.py: {end.code}", file=sys.stderr)
        sys.exit(2)
