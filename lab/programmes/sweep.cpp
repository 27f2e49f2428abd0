#include "lab/programmes/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/base/bad_input.hpp"
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
    if (item.find(':') != std::string_view::npos) return read_linear_range(item);
    add(std::string(item));
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(fmt::format("--sweep {}: {}", axis_.key, message));
  }

  void add(std::string value) {
    if (static_cast<std::int64_t>(axis_.values.size()) >= kMostSweepTests)
      fail(fmt::format("more than {} values", kMostSweepTests));
    axis_.values.push_back(std::move(value));
  }

  void read_whole_range(std::string_view item) {
    const auto dots = item.find("..");
    const auto from = whole_text_as<std::int64_t>(item.substr(0, dots));
    const auto to = whole_text_as<std::int64_t>(item.substr(dots + 2));
    if (!from || !to)
      fail(fmt::format("{} is no range of whole numbers; write 1..200, or 1.0:1.2:0.02 for others",
                       excerpt(item)));
    if (*to < *from) fail(fmt::format("the range {} runs backwards", excerpt(item)));
    for (std::int64_t value = *from;; ++value) {
      add(std::to_string(value));
      if (value == *to) return;
    }
  }

  void read_linear_range(std::string_view item) {
    const auto first = item.find(':'), second = item.find(':', first + 1);
    if (second == std::string_view::npos || item.find(':', second + 1) != std::string_view::npos)
      fail(
          fmt::format("{} is no linear range; write FROM:TO:STEP, as 1.0:1.2:0.02", excerpt(item)));
    const auto from_text = item.substr(0, first), step_text = item.substr(second + 1);
    const double from = number(from_text), step = number(step_text);
    const double to = number(item.substr(first + 1, second - first - 1));
    const double steps = (to - from) / step;
    if (!(steps >= 0) || !std::isfinite(steps))
      fail(fmt::format("the step of {} never comes from {:g} to {:g}", excerpt(item), from, to));
    if (steps >= static_cast<double>(kMostSweepTests))
      fail(fmt::format("{} has more than {} values", excerpt(item), kMostSweepTests));
    const int digits = std::max(decimals(from_text), decimals(step_text));
    // What rounding leaves of the last step must not lose the end.
    const auto last = static_cast<std::int64_t>(std::floor(steps + 1e-9));
    for (std::int64_t i = 0; i <= last; ++i)
      add(written(from + static_cast<double>(i) * step, digits));
  }

  double number(std::string_view text) const {
    const auto value = whole_text_as<double>(text);
    if (!value || !std::isfinite(*value)) fail(fmt::format("{} is no number", excerpt(text)));
    return *value;
  }

  /// Digits behind the point; very many for a number with an exponent.
  static int decimals(std::string_view text) {
    if (text.find_first_of("eE") != std::string_view::npos) return 100;
    const auto point = text.find('.');
    return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
  }

  /// With the digits that the range was written with: 1.06, not 1.0600000000000001.
  static std::string written(double value, int digits) {
    constexpr int kMostDigits = 15;
    return digits > kMostDigits ? fmt::format("{}", value) : fmt::format("{:.{}f}", value, digits);
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
        fmt::format("--sweep {}: KEY=VALUES is wanted, as in seed=1..200", excerpt(text)));
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
    if (size_ > kMostSweepTests)
      throw BadInput(fmt::format("--sweep: more than {} tests; take fewer values or several sweeps",
                                 kMostSweepTests));
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
