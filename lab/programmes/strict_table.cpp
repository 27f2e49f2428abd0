#include "lab/programmes/strict_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/records/bad_input.hpp"

namespace triax::lab {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

std::string wanted(const Bounds& bounds) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
  if (std::isfinite(bounds.above)) add(fmt::format("above {:g}", bounds.above));
  if (std::isfinite(bounds.at_least)) add(fmt::format("at least {:g}", bounds.at_least));
  if (std::isfinite(bounds.at_most)) add(fmt::format("at most {:g}", bounds.at_most));
  return text.empty() ? "finite" : text;
}

}  // namespace

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
  // Words longer than any key are no misspelling, and would cost time to compare.
  if (word.size() > 64) return {};
  std::string best;
  std::size_t least = 1 + word.size() / 3;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    const bool contained = word.size() >= 4 && candidate.find(word) != std::string::npos;
    if (distance < least || (distance == least && best.empty()) || (contained && best.empty())) {
      least = std::min(least, distance);
      best = candidate;
    }
  }
  return best;
}

const toml::node* StrictTable::ask(std::string_view key) {
  asked_.emplace(key);
  return table_->get(key);
}

std::int64_t StrictTable::line() const { return table_->source().begin.line; }

void StrictTable::fail(std::string_view key, const std::string& message) const {
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  const std::int64_t at = node != nullptr ? node->source().begin.line : line();
  throw BadInput(file_, at, key.empty() ? message : fmt::format("{} {}: {}", where_, key, message));
}

void StrictTable::missing(std::string_view key) const {
  const std::vector<std::string> present = keys();
  const std::string near = nearest_word(key, present);
  const bool misspelt = !near.empty() && !asked_.contains(near);
  fail("", fmt::format("{} needs the key {}{}", where_, key,
                       misspelt ? fmt::format(" (is it meant by {}?)", near) : ""));
}

std::optional<double> StrictTable::maybe_number(std::string_view key, const Bounds& bounds) {
  const toml::node* node = ask(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) fail(key, "must be a number without quotes");
  const double value = node->value<double>().value_or(NAN);
  const bool ok = std::isfinite(value) && value > bounds.above && value >= bounds.at_least &&
                  value <= bounds.at_most;
  if (!ok) fail(key, fmt::format("is {:g}, must be {}", value, wanted(bounds)));
  return value;
}

double StrictTable::number(std::string_view key, const Bounds& bounds) {
  const auto value = maybe_number(key, bounds);
  if (!value) missing(key);
  return *value;
}

std::optional<std::string> StrictTable::maybe_text(std::string_view key) {
  const toml::node* node = ask(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value<std::string>();
  if (!node->is_string() || !value) fail(key, "must be text in quotes");
  return value;
}

std::string StrictTable::text(std::string_view key) {
  const auto value = maybe_text(key);
  if (!value) missing(key);
  if (value->empty()) fail(key, "must not be empty");
  return *value;
}

std::optional<std::int64_t> StrictTable::maybe_integer(std::string_view key, std::int64_t lowest,
                                                       std::int64_t highest) {
  const toml::node* node = ask(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_integer()) fail(key, "must be a whole number");
  const std::int64_t value = node->value<std::int64_t>().value_or(lowest - 1);
  if (value < lowest || value > highest)
    fail(key, fmt::format("is {}, must be {} to {}", value, lowest, highest));
  return value;
}

std::optional<StrictTable> StrictTable::maybe_table(std::string_view key) {
  const toml::node* node = ask(key);
  if (node == nullptr) return std::nullopt;
  const toml::table* table = node->as_table();
  if (table == nullptr) fail(key, "must be a table");
  std::string name = where_.empty() ? std::string(key)
                                    : where_.substr(1, where_.size() - 2) + "." + std::string(key);
  return StrictTable(*table, file_, "[" + name + "]");
}

StrictTable StrictTable::table(std::string_view key) {
  auto found = maybe_table(key);
  if (!found) fail("", fmt::format("the table [{}] is missing", key));
  return *found;
}

const toml::array* StrictTable::maybe_array(std::string_view key) {
  const toml::node* node = ask(key);
  if (node == nullptr) return nullptr;
  if (node->as_array() == nullptr) fail(key, "must be a list in [ ]");
  return node->as_array();
}

std::vector<std::string> StrictTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : *table_) names.emplace_back(key.str());
  return names;
}

void StrictTable::done() const {
  for (const auto& [key, node] : *table_) {
    if (asked_.contains(key.str())) continue;
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    const std::string near = nearest_word(key.str(), known);
    throw BadInput(file_, node.source().begin.line,
                   fmt::format("{} does not know the key {}; {}",
                               where_.empty() ? "the file" : where_, key.str(),
                               near.empty() ? fmt::format("it knows {}", fmt::join(known, ", "))
                                            : fmt::format("did you mean {}?", near)));
  }
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    std::ranges::replace(message, '\n', ' ');
    throw BadInput(file, error.source().begin.line, message);
  }
}

}  // namespace triax::lab
