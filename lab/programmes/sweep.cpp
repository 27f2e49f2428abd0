// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/range.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr std::string_view kSeed = "seed", kSeedInFile = "test.seed";

/// Reads the values of one axis.
class ValueReader {
 public:
  explicit ValueReader(SweepAxis& axis) : axis_(axis) {}

  void read(std::string_view item) {
    if (item.empty()) fail("a value is empty; write KEY=1,2,3");
    if (item.find("..") != std::string_view::npos) return read_whole_range(item);
    if (looks_like_range(item)) return read_range_of(item);
    add(std::string(item));
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(fmt::format("--sweep {}: {}", axis_.key, message));
  }

  void add(std::string value) {
    if (static_cast<std::int64_t>(axis_.values.size()) >= kMaxSweepTests)
      fail(fmt::format("more than {} values", kMaxSweepTests));
    axis_.values.push_back(std::move(value));
  }

  /// FROM..TO, as ranges of seeds were written once; it takes numbers that no double holds.
  void read_whole_range(std::string_view item) {
    const auto dots = item.find("..");
    const auto from = whole_text_as<std::int64_t>(item.substr(0, dots));
    const auto to = whole_text_as<std::int64_t>(item.substr(dots + 2));
    if (!from || !to)
      fail(fmt::format("{} is not a range of integers; expected FROM:TO:STEP, as in 1:200:1",
                       excerpt(item)));
    if (*to < *from)
      fail(fmt::format("the range {} is descending; expected FROM <= TO", excerpt(item)));
    for (std::int64_t value = *from;; ++value) {
      add(std::to_string(value));
      if (value == *to) return;
    }
  }

  void read_range_of(std::string_view item) try {
    for (std::string& value : written_values(read_range(item, kMaxSweepTests)))
      add(std::move(value));
  } catch (const std::invalid_argument& error) {
    fail(error.what());
  }

  SweepAxis& axis_;
};

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::vector<std::string> short_keys(const std::vector<SweepAxis>& axes) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : axes) {
    const auto alike = std::ranges::count_if(
        axes, [&](const SweepAxis& other) { return last_part(other.key) == last_part(axis.key); });
    keys.push_back(alike > 1 ? axis.key : last_part(axis.key));
  }
  return keys;
}

}  // namespace

SweepAxis read_sweep_axis(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw BadInput(
        fmt::format("--sweep {}: expected KEY=VALUES, as in seed=1:200:1", excerpt(text)));
  SweepAxis axis{std::string(trimmed(text.substr(0, equals))), {}};
  if (axis.key == kSeedInFile) axis.key = kSeed;
  ValueReader reader(axis);
  for (std::string_view rest = text.substr(equals + 1);;) {
    const auto comma = rest.find(',');
    reader.read(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return axis;
    rest.remove_prefix(comma + 1);
  }
}

Sweep::Sweep(std::vector<SweepAxis> axes) : axes_(std::move(axes)), short_keys_(short_keys(axes_)) {
  if (axes_.empty()) throw BadInput("--sweep: no key is given; write KEY=VALUES");
  for (const SweepAxis& axis : axes_) {
    if (std::ranges::count(axes_, axis.key, &SweepAxis::key) > 1)
      throw BadInput(
          fmt::format("--sweep {}: the key is given twice; write its values in one "
                      "list",
                      axis.key));
    size_ *= static_cast<std::int64_t>(axis.values.size());
    if (size_ > kMaxSweepTests)
      throw BadInput(fmt::format(
          "--sweep: more than {} tests; give fewer values or run several sweeps", kMaxSweepTests));
  }
}

std::vector<std::pair<std::string, std::string>> Sweep::values(std::int64_t place) const {
  std::vector<std::pair<std::string, std::string>> result(axes_.size());
  std::int64_t rest = place - 1;
  for (std::size_t i = axes_.size(); i-- > 0;) {
    const auto count = static_cast<std::int64_t>(axes_[i].values.size());
    result[i] = {axes_[i].key, axes_[i].values[static_cast<std::size_t>(rest % count)]};
    rest /= count;
  }
  return result;
}

std::vector<TomlEdit> Sweep::edits(std::int64_t place) const {
  std::vector<TomlEdit> result;
  for (auto& [key, value] : values(place))
    result.push_back({key == kSeed ? std::string(kSeedInFile) : std::move(key), std::move(value)});
  return result;
}

std::string Sweep::label(std::int64_t place) const {
  std::string text;
  const auto held = values(place);
  for (std::size_t i = 0; i < held.size(); ++i)
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", short_keys_[i], held[i].second);
  return text;
}

}  // namespace triax::lab
