# SPDX-License-Identifier: BSD-3-Clause
"""Shows a recorded episode again, and moves nothing."""
