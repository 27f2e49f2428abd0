// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of a zip archive as streams, in constant memory.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "lab/base/xml_stream.hpp"

namespace triax::lab {

/// One part, unpacked as it is read.
class ZipPart {
 public:
  ~ZipPart();
  ZipPart(ZipPart&&) noexcept;
  ZipPart& operator=(ZipPart&&) = delete;

  /// Fills the front of `into`; 0 at the end. Throws BadInput where the part is broken, or packed
  /// so much (kMostPacked) that it is a trap.
  std::size_t read(std::span<char> into);
  std::uint64_t packed_size() const { return packed_; }

 private:
  friend class ZipArchive;
  struct Impl;
  ZipPart(std::unique_ptr<Impl> impl, std::uint64_t packed);
  std::unique_ptr<Impl> impl_;
  std::uint64_t packed_ = 0, unpacked_ = 0;
};

class ZipArchive {
 public:
  /// A file. Throws BadInput for what is no zip archive, or has more parts than any workbook.
  static ZipArchive open(const std::string& path);
  /// Bytes in memory, called `name` in messages.
  static ZipArchive in_memory(const std::string& name, std::string bytes);
  ~ZipArchive();
  ZipArchive(ZipArchive&&) noexcept;
  ZipArchive& operator=(ZipArchive&&) = delete;

  const std::string& name() const;
  bool has(const std::string& part) const;
  /// True where some part ends so ("vbaProject.bin").
  bool has_part_ending(const std::string& ending) const;
  /// Throws BadInput where there is no such part or it is encrypted. The archive has to outlive it.
  ZipPart part(const std::string& part) const;

  /// A part that unpacks to more than so many times its size, beyond the first 16 MB, is no sheet
  /// that anyone recorded.
  static constexpr std::uint64_t kMostPacked = 300;

 private:
  struct Impl;
  explicit ZipArchive(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A part of a workbook as XML. The archive has to outlive it.
XmlInput xml_of(const ZipArchive& archive, const std::string& part);

}  // namespace triax::lab
