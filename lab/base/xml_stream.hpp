// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A parser for XML in constant memory (expat).
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace triax::lab {

/// Attributes of an element.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// By its name without a namespace; empty where it is not there.
  std::string_view operator[](std::string_view name) const;
  const char** pairs() const { return pairs_; }

 private:
  const char** pairs_;
};

/// The element's name without its namespace ("x:row" is "row").
std::string_view local_name(const char* name);

struct XmlListener {
  std::function<void(std::string_view name, XmlAttributes)> start;
  std::function<void(std::string_view name)> end;
  std::function<void(std::string_view text)> text;  ///< in pieces
  /// Receives the bytes behind the end of an element called `row`. It may parse whole elements at
  /// their beginning itself and returns the number of those bytes, which the parser then skips.
  /// Empty: the parser takes all bytes.
  std::function<std::size_t(std::string_view bytes)> rows{};
};

/// The source of the bytes, and its name in messages.
struct XmlInput {
  std::string name;                                  ///< of the file
  std::function<std::size_t(std::span<char>)> read;  ///< fills the front; 0 at the end
  std::string kind;                                  ///< "workbook"
  std::string remedy;                                ///< for XML that is broken
  bool has_lines = false;  ///< the bytes are the file: messages name lines
};

/// Parses XML block by block and calls a listener.
class XmlStream {
 public:
  XmlStream(XmlInput input, XmlListener listener);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  /// The next block; false at the end of the input. Throws BadInput on XML that is broken, declares
  /// a document type, nests deeper than kMaxDepth or has a single piece of more than 8 MB. An
  /// exception of the listener ends the parsing and is passed on.
  bool advance();
  /// Line of the event that the listener receives, from 1; 0 if the input has no lines.
  std::int64_t line() const;
  void stop() { stopped_ = true; }  ///< nothing further is wanted
  static constexpr int kMaxDepth = 100;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  bool stopped_ = false;
};

}  // namespace triax::lab
