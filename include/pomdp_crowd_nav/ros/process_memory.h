// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// Lets every block of more than 128 kB go back to the system when it is freed. By default glibc
// keeps ever larger ones for the thread that asked for them, and a node with many threads that
// take up maps and crowds grows for hours. To be called once, before there is any other thread;
// does nothing with another C library.
void returnLargeBlocks();

}  // namespace pomdp_crowd_nav
