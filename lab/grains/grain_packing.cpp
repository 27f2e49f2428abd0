// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_packing.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "lab/base/bad_input.hpp"
#include "lab/base/byte_source.hpp"
#include "lab/base/text.hpp"
#include "lab/grains/grain_programme_reader.hpp"

namespace triax::lab {
namespace {

constexpr std::uintmax_t kLargestPacking = 1U << 30U;

/// Lines of numbers, one after the other.
class NumberLines {
 public:
  NumberLines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// The next line that is not blank as exactly `Count` finite numbers; empty at the end.
  template <std::size_t Count>
  std::optional<std::array<double, Count>> next(const char* wanted) {
    std::string_view line;
    do {
      if (rest_.empty()) return std::nullopt;
      const std::size_t end = rest_.find('\n');
      line = trimmed(rest_.substr(0, end));
      if (line.ends_with('\r')) line.remove_suffix(1);
      rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
      ++line_;
    } while (line.empty());
    std::array<double, Count> numbers{};
    std::string_view left = line;
    for (double& number : numbers) number = take(left, line, wanted);
    if (!trimmed(left).empty()) refuse(line, wanted);
    return numbers;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(file_, line_, message);
  }

 private:
  double take(std::string_view& left, std::string_view line, const char* wanted) const {
    left = trimmed(left);
    const std::size_t end = left.find_first_of(" \t");
    const auto number = whole_text_as<double>(left.substr(0, end));
    if (!number || !std::isfinite(*number)) refuse(line, wanted);
    left = end == std::string_view::npos ? std::string_view{} : left.substr(end);
    return *number;
  }
  [[noreturn]] void refuse(std::string_view line, const char* wanted) const {
    fail(fmt::format("{} is not '{}'", excerpt(line), wanted));
  }

  std::string_view rest_;
  const std::string& file_;
  std::int64_t line_ = 0;
};

}  // namespace

GrainPacking read_packing(std::string_view text, const std::string& file, int axis) {
  NumberLines lines(text, file);
  const auto head = lines.next<7>("N x0 x1 y0 y1 z0 z1");
  if (!head)
    throw BadInput(file, 0, "is empty; expected 'N x0 x1 y0 y1 z0 z1' and a line for each grain");
  const double count = (*head)[0];
  if (count < 1 || count > kMostGrains || count != std::floor(count))
    lines.fail(fmt::format("{:g} is not a number of grains from 1 to {}", count, kMostGrains));
  const auto from = [axis](int to) { return (axis + 1 + to) % 3; };
  GrainPacking packing;
  for (int to = 0; to < 3; ++to) {
    packing.box.low_m[to] = (*head)[1 + 2 * from(to)];
    packing.box.high_m[to] = (*head)[2 + 2 * from(to)];
    if (!(packing.box.length_m(to) > 0)) lines.fail("an edge of the box must be above 0");
  }
  while (const auto row = lines.next<4>("x y z radius")) {
    sim::Sphere sphere;
    sphere.radius_m = (*row)[3];
    if (!(sphere.radius_m > 0)) lines.fail("the radius must be above 0");
    for (int to = 0; to < 3; ++to) {
      const double x = sphere.centre_m[to] = (*row)[from(to)];
      if (x < packing.box.low_m[to] || x > packing.box.high_m[to])
        lines.fail("the centre of the grain is outside the box");
    }
    packing.spheres.push_back(sphere);
    if (static_cast<double>(packing.spheres.size()) > count)
      lines.fail(fmt::format("more grains than the {:g} of the first line", count));
  }
  if (static_cast<double>(packing.spheres.size()) != count)
    lines.fail(fmt::format("ends after {} of {:g} grains", packing.spheres.size(), count));
  return packing;
}

GrainPacking load_packing(const std::string& path, int axis) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error) throw BadInput(path, 0, describe_open_error(error.value()));
  if (!in) throw BadInput(path, 0, describe_open_error(errno));
  if (size > kLargestPacking) throw BadInput(path, 0, "is larger than 1 GB");
  std::ostringstream text;
  text << in.rdbuf();
  return read_packing(text.str(), path, axis);
}

}  // namespace triax::lab
