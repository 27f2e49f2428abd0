// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_edit.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

class Editor {
 public:
  Editor(const TomlEdit& edit, const std::string& file) : edit_(edit), file_(file) {}

  void put_into(toml::table& document) {
    toml::node* at = &document;
    for (std::string_view rest = edit_.key;;) {
      const auto dot = rest.find('.');
      const std::string part(rest.substr(0, dot));
      if (part.empty()) fail("a part of the key is empty");
      if (dot == std::string_view::npos) return put(*at, part);
      at = &below(*at, part);
      rest.remove_prefix(dot + 1);
      way_ += (way_.empty() ? "" : ".") + part;
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(file_, 0, fmt::format("{} = {}: {}", edit_.key, edit_.value, message));
  }

  toml::node& item(toml::array& list, const std::string& part) const {
    const auto number = whole_text_as<std::uint64_t>(part);
    if (!number || *number < 1 || *number > list.size())
      fail(fmt::format("{0} is not an item of {2}; expected 1 to {1}", excerpt(part), list.size(),
                       way_));
    return list[*number - 1];
  }

  toml::node& below(toml::node& at, const std::string& part) const {
    if (auto* list = at.as_array()) return item(*list, part);
    auto* table = at.as_table();
    if (table == nullptr) fail(fmt::format("{} is a value, not a table", way_));
    if (!table->contains(part)) table->insert(part, toml::table{});
    return *table->get(part);
  }

  void put(toml::node& at, const std::string& part) const {
    if (auto* list = at.as_array()) {
      const auto& old = item(*list, part);
      if (old.is_table() || old.is_array()) fail("is a table; name one of its keys");
      const auto place = list->cbegin() + (whole_text_as<std::int64_t>(part).value_or(1) - 1);
      with_value(old.is_string(), [&](auto value) { list->replace(place, std::move(value)); });
      return;
    }
    auto* table = at.as_table();
    if (table == nullptr) fail(fmt::format("{} is a value, not a table", way_));
    const auto* old = table->get(part);
    if (old && (old->is_table() || old->is_array())) fail("is a table; name one of its keys");
    with_value(old && old->is_string(),
               [&](auto value) { table->insert_or_assign(part, std::move(value)); });
  }

  template <class Use>
  void with_value(bool as_text, const Use& use) const {
    const std::string& text = edit_.value;
    if (as_text) return use(text);
    if (const auto whole = whole_text_as<std::int64_t>(text)) return use(*whole);
    if (const auto real = whole_text_as<double>(text)) return use(*real);
    if (text == "true" || text == "false") return use(text == "true");
    use(text);
  }

  const TomlEdit& edit_;
  const std::string& file_;
  std::string way_;  ///< parts of the key that are behind
};

}  // namespace

void apply_edit(toml::table& document, const TomlEdit& edit, const std::string& file) {
  Editor(edit, file).put_into(document);
}

}  // namespace triax::lab
