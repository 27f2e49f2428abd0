// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a browser sends as a record: bytes in a file without a name beside the database, never in
// memory, gone with this object.
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lab/base/byte_source.hpp"

namespace triax::src {

class Upload {
 public:
  /// `folder` takes the file. Throws lab::WorkFailed.
  explicit Upload(const std::string& folder);
  /// The file that another process opened under this descriptor, which it then owns.
  explicit Upload(int descriptor);
  ~Upload();
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  void write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  int descriptor() const { return descriptor_; }
  /// The bytes from the first on, as of a file of that name; as often as wanted, one after the
  /// other. Does not outlive this object.
  std::unique_ptr<lab::ByteSource> source(const std::string& name) const;

 private:
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace triax::src
