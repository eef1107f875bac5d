# SPDX-License-Identifier: BSD-3-Clause
"""Bags that `record:=true` of the launch files has written."""
