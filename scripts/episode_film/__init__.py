# SPDX-License-Identifier: BSD-3-Clause
"""An episode as a film."""
