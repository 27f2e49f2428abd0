// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the character encoding of a text file, and gives the file as UTF-8.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// Bytes at each end of a file that the encoding is found from.
inline constexpr std::size_t kEncodingSample = std::size_t{1} << 16;

struct Encoding {
  std::string name = "UTF-8";     ///< one of encoding_names()
  bool has_mark = false;          ///< the file begins with a byte-order mark
  bool has_lone_returns = false;  ///< lines end with CR alone
  bool is_utf8() const { return name == "UTF-8"; }
};

/// The encoding that fits a text best. `first` and `last` are the bytes at its begin and end,
/// `last` is empty if `first` is the whole file. Bytes that are UTF-8 are never anything else.
Encoding find_encoding(std::string_view first, std::string_view last);

/// "UTF-8", "UTF-16LE", "GB18030", "Windows-1252", ...
const std::vector<std::string>& encoding_names();

/// A text file as UTF-8 in constant memory, with LF for line ends that are CR alone. Bytes that are
/// no character of the encoding become U+FFFD.
class Utf8Source : public ByteSource {
 public:
  /// `encoding.name` must be one of encoding_names().
  Utf8Source(std::unique_ptr<ByteSource> original, const Encoding& encoding);
  ~Utf8Source() override;

  const std::string& name() const override { return original_->name(); }
  /// Estimate of the size as UTF-8.
  std::uint64_t size() const override;
  std::size_t read(std::span<char> into) override;
  void rewind() override;
  ByteSource& file() override { return original_->file(); }
  const Encoding& encoding() const { return encoding_; }

 private:
  class Converter;
  bool fill();
  void begin();

  std::unique_ptr<ByteSource> original_;
  Encoding encoding_;
  std::unique_ptr<Converter> converter_;
  std::string bytes_;  ///< of the file, not converted yet
  std::string text_;   ///< UTF-8 that is not read yet, from at_ on
  std::size_t at_ = 0;
  bool at_end_ = false;
};

/// The source as UTF-8: itself if its text is UTF-8 already. `encoding` overrides what the bytes
/// say; upper or lower case, "cp1252" and "latin-1" are accepted. Throws BadInput, which lists the
/// names, for another one.
std::unique_ptr<ByteSource> open_utf8(std::unique_ptr<ByteSource> source,
                                      const std::optional<std::string>& encoding = {});

}  // namespace triax::lab
