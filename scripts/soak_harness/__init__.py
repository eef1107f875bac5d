# SPDX-License-Identifier: BSD-3-Clause
"""What soak.py and measure_jitter.py are made of: nodes, relay, faults, measurements."""
