// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the bytes of a record come from: a file, or memory (tests, fuzzers).
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace triax::lab {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Name for messages: the path as the user gave it.
  virtual const std::string& name() const = 0;
  virtual std::uint64_t size() const = 0;
  /// Fills the front of `into`; gives the number of bytes, 0 at the end. Throws WorkFailed where
  /// the medium fails.
  virtual std::size_t read(std::span<char> into) = 0;
  /// Back to the first byte.
  virtual void rewind() = 0;
  /// The bytes as they lie on disk, where read() gives a sheet in them as text; else this one.
  virtual ByteSource& file() { return *this; }
  /// The same bytes from the first one on, for another thread; null if this source has no
  /// duplicate.
  virtual std::unique_ptr<ByteSource> duplicate() const { return nullptr; }
  /// Passes over `count` bytes, or the rest if there are fewer. Reads them unless the medium can do
  /// without.
  virtual void skip(std::uint64_t count);
  /// True if skip() takes no time.
  virtual bool is_seekable() const { return false; }
};

/// "file does not exist", or "cannot be opened: " and the system's reason for `error` (errno).
std::string describe_open_error(int error);
/// Throws BadInput for a file that is missing, cannot be read, is a directory or no regular file.
std::unique_ptr<ByteSource> open_file(const std::string& path);
std::unique_ptr<ByteSource> open_memory(std::string name, std::string bytes);

}  // namespace triax::lab
