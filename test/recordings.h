// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

namespace pomdp_crowd_nav {

// Path of a recording of real people, in $UCY_DATA_DIR or where the authors keep it.
inline std::string recordingPath(const std::string& name) {
  const char* folder = std::getenv("UCY_DATA_DIR");
  return std::string(folder != nullptr ? folder : SOURCE_DIR "/../shared/data") + "/" + name;
}

inline bool isThere(const std::string& path) { return std::ifstream(path).good(); }

}  // namespace pomdp_crowd_nav
