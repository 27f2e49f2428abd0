// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/plain_row.hpp"

namespace triax::lab {
namespace {

/// No row that a sheet may have has more cells, and what has more is for who tells of it.
constexpr std::size_t kMostPlainCells = 16384;

bool is_letter_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ':' ||
         c == '_';
}

/// Walks over bytes; what does not fit leaves it where it is and says so.
class Walk {
 public:
  explicit Walk(std::string_view bytes) : bytes_(bytes) {}

  bool skip(std::string_view text) {
    if (!bytes_.substr(at_).starts_with(text)) return false;
    at_ += text.size();
    return true;
  }
  /// Up to the next `end`, over plain characters only.
  bool text(char end, std::string_view& into) {
    const std::size_t begin = at_;
    for (; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (c == end) {
        into = bytes_.substr(begin, at_ - begin);
        return true;
      }
      if (c < ' ' || c > '~' || c == '<' || c == '&') return false;
    }
    return false;
  }
  /// One of ` name="value"`.
  bool attribute(std::string_view& name, std::string_view& value) {
    if (!skip(" ")) return false;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && is_letter_of_name(bytes_[at_])) ++at_;
    name = bytes_.substr(begin, at_ - begin);
    return !name.empty() && skip("=\"") && text('"', value) && skip("\"");
  }
  std::size_t at() const { return at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// Attributes and the end of a tag; `open` where it has no / before its end.
template <class Take>
bool end_of_tag(Walk& walk, bool& open, const Take& take) {
  std::string_view name, value;
  for (;;) {
    if (walk.skip(">")) return open = true;
    if (walk.skip("/>")) {
      open = false;
      return true;
    }
    if (!walk.attribute(name, value)) return false;
    take(name, value);
  }
}

bool plain_cell(Walk& walk, PlainRow::Cell& cell) {
  bool open = false;
  const auto take = [&cell](std::string_view name, std::string_view value) {
    if (name == "r") cell.place = value;
    if (name == "s") cell.style = value;
    if (name == "t") cell.type = value;
  };
  if (!end_of_tag(walk, open, take)) return false;
  if (!open) return true;
  std::string_view formula;
  if (walk.skip("<f>")) {
    cell.formula = true;
    if (!walk.text('<', formula) || !walk.skip("</f>")) return false;
  }
  if (walk.skip("<v>") && !(walk.text('<', cell.value) && walk.skip("</v>"))) return false;
  return walk.skip("</c>");
}

}  // namespace

std::size_t PlainRow::read(std::string_view bytes) {
  number_ = {};
  cells_.clear();
  Walk walk(bytes);
  bool open = false;
  const auto take = [this](std::string_view name, std::string_view value) {
    if (name == "r") number_ = value;
  };
  if (!walk.skip("<row") || !end_of_tag(walk, open, take)) return 0;
  while (open && !walk.skip("</row>")) {
    if (!walk.skip("<c") || cells_.size() == kMostPlainCells) return 0;
    if (!plain_cell(walk, cells_.emplace_back())) return 0;
  }
  return walk.at();
}

}  // namespace triax::lab
