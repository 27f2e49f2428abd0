// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// XML as it comes, in constant memory (expat).
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
  /// Shown the bytes behind the end of an element called `row`, may take whole elements from their
  /// beginning by itself, and says how many bytes those were; of them nothing else is told. Empty:
  /// nobody does.
  std::function<std::size_t(std::string_view bytes)> rows{};
};

/// Where the bytes come from, and how messages speak of them.
struct XmlInput {
  std::string name;                                  ///< of the file
  std::function<std::size_t(std::span<char>)> read;  ///< fills the front; 0 at the end
  std::string kind;                                  ///< "workbook"
  std::string remedy;                                ///< for XML that is broken
  bool has_lines = false;  ///< the bytes are the file: messages name lines
};

/// Tells XML to a listener, a block at a time.
class XmlStream {
 public:
  XmlStream(XmlInput input, XmlListener listener);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  /// The next block; false at the end of the input. Throws BadInput on XML that is broken, declares
  /// a document type, nests deeper than kDeepest or has a single piece of more than 8 MB; what the
  /// listener throws passes through.
  bool advance();
  /// Line of the event that the listener receives, from 1; 0 if the input has no lines.
  std::int64_t line() const;
  void stop() { stopped_ = true; }  ///< nothing further is wanted
  static constexpr int kDeepest = 100;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  bool stopped_ = false;
};

}  // namespace triax::lab
