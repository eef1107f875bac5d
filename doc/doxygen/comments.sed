# SPDX-License-Identifier: BSD-3-Clause
# Turns the comments of the headers into those that doxygen reads; no line is added or removed.
s@^// SPDX.*@@
s@^( *)// @\1/// @
s@^( *)//$@\1///@
s@([^ /:]) +// @\1 ///< @
