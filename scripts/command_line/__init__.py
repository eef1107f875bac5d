# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that a user starts have in common: options, refusals, progress."""
