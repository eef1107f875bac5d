# SPDX-License-Identifier: BSD-3-Clause
"""Bad input and its one line: a module for each program or group of them."""
