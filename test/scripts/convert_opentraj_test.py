#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/convert_opentraj.py makes of small recordings."""
import pathlib
import subprocess
import sys
import unittest

from surroundings import FolderTest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/convert_opentraj.py"
OBSMAT = """ 1.000000e+00 1.0e+00 1.6413e+00 0.0 2.188291e+00 -0.16 0.0 0.70
 1.000000e+00 2.0e+00 2.2293e-01 0.0 4.477681e+00 0.0 0.0 0.71
 1.100000e+01 1.0e+00 1.57658e+00 0.0 2.469129e+00 -0.25 0.0 1.12
"""
# A person who stands up to frame 10, walks 2 pixels to frame 20 and stands again.
VSP = """1 - the number of splines
4 - Num of control points
0.000000 5.000000 0 -79.695152 - (2D point, m_id)
0.000000 5.000000 10 -79.695152 - (2D point, m_id)
2.000000 5.000000 30 -90.000000 - (2D point, m_id)
2.000000 5.000000 40 -90.000000 - (2D point, m_id)
"""


class ConvertTest(FolderTest):
    def convert(self, *args, status=0):
        result = subprocess.run([sys.executable, str(SCRIPT), *args], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, timeout=30, check=False)
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stderr if status else result.stdout.splitlines()

    def test_obsmat(self):
        self.assertEqual(self.convert("obsmat", self.write("obsmat.txt", OBSMAT)),
                         ["time_s,ped_id,x_m,y_m", "0.00,1,1.641,2.188", "0.00,2,0.223,4.478",
                          "0.40,1,1.577,2.469"])

    def test_splines_go_through_their_points_without_overshoot(self):
        homography = self.write("H.txt", "0.5 0 1\n0 0.5 0\n0 0 1\n")
        rows = self.convert("vsp", self.write("a.vsp", VSP), "--homography", homography)
        self.assertEqual(rows[1:], ["0.00,1,1.000,2.500", "0.40,1,1.000,2.500",
                                    "0.80,1,1.500,2.500", "1.20,1,2.000,2.500",
                                    "1.60,1,2.000,2.500"])

    def test_a_monotone_cubic(self):
        sys.dont_write_bytecode = True
        sys.path.insert(0, str(SCRIPT.parent))
        from convert_opentraj import pchip  # pylint: disable=import-outside-toplevel
        times, ways = [-3, -2, -1, 0, 1, 2, 3], [-1, -1, -1, 0, 1, 1, 1]
        self.assertEqual(pchip(times, ways, [-1.5, -0.5, 0.5, 1.5]), [-1.0, -0.625, 0.625, 1.0])
        self.assertEqual(pchip([0, 4], [0, 8], [1, 3]), [2.0, 6.0])

    def expect_refusal(self, *args):
        message = self.convert(*args, status=2)
        self.assertEqual(len(message.splitlines()), 1, message)
        self.assertTrue(message.startswith("convert_opentraj.py: "), message)
        return message

    def test_bad_files_are_one_line(self):
        self.assertIn("nowhere.txt", self.expect_refusal("obsmat", "nowhere.txt"))
        self.assertIn(":1: expected 8", self.expect_refusal("obsmat", self.write("a", "1 2 3\n")))
        self.assertIn(":1: ", self.expect_refusal("obsmat", self.write("a", "one\n")))
        homography = self.write("H.txt", "1 0 0\n0 1 0\n0 0 1\n")
        short = self.write("short.vsp", "\n".join(VSP.splitlines()[:4]) + "\n")
        self.assertIn("ends early", self.expect_refusal("vsp", short, "--homography", homography))
        self.assertIn("H.bad", self.expect_refusal("vsp", self.write("a.vsp", VSP), "--homography",
                                                   self.write("H.bad", "1 0 0\n")))


if __name__ == "__main__":
    unittest.main()
