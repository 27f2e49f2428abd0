// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// XML as text, element by element, in constant memory.
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace triax::lab {

class XmlWriter {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

  /// Begins the document; `write` gets its text in pieces.
  explicit XmlWriter(std::function<void(std::string_view)> write);

  void open(std::string_view name, Attributes attributes = {});
  void close();
  /// An element with text, which is escaped. Characters that XML cannot hold become "?".
  void leaf(std::string_view name, std::string_view text, Attributes attributes = {});
  /// An element without content.
  void empty(std::string_view name, Attributes attributes = {});
  /// Text inside the open element as it is: numbers and separators.
  void plain(std::string_view text);
  /// Closes all that is open.
  void finish();

 private:
  void begin(std::string_view name, Attributes attributes);
  void indent();
  void append_escaped(std::string_view text);
  void flush(std::size_t keep);

  std::function<void(std::string_view)> write_;
  std::vector<std::string> open_;
  std::string text_;
};

}  // namespace triax::lab
