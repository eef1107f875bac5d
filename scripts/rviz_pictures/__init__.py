# SPDX-License-Identifier: BSD-3-Clause
"""What screenshots.py is made of: a moment of a drive, RViz that shows it, a sheet of layers."""
