// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace pomdp_crowd_nav {

// A text file that one program writes, at its end only. What has been appended is on the disk.
// Everything throws std::runtime_error with one line that names the file.
class DurableFile {
 public:
  // Locks the file against another program that does the same; `create` refuses one that exists,
  // `open` makes one where there is none.
  static DurableFile create(const std::string& path);
  static DurableFile open(const std::string& path);
  static DurableFile standardOutput();

  DurableFile(DurableFile&& other) noexcept;
  DurableFile& operator=(DurableFile&&) = delete;
  ~DurableFile();

  std::string read() const;              // from its beginning
  void append(const std::string& text);  // all of it, or nothing where that fails
  void cutTo(std::uint64_t bytes);

 private:
  DurableFile(const std::string& path, int descriptor) : path_(path), descriptor_(descriptor) {}
  static DurableFile openWith(const std::string& path, int flags);
  void write(const std::string& text);

  std::string path_;
  int descriptor_;
};

// Puts a whole file in the place of what was there, or leaves that as it is.
void replaceFile(const std::string& path, const std::string& text);

}  // namespace pomdp_crowd_nav
