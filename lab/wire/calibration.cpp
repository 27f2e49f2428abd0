// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/calibration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "lab/base/byte_source.hpp"
#include "lab/base/digest.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

/// "2026-03-17", a day that there is.
bool is_date(std::string_view text) {
  constexpr std::size_t kLength = 10, kMonthAt = 5, kDayAt = 8;
  if (text.size() != kLength || text[kMonthAt - 1] != '-' || text[kDayAt - 1] != '-') return false;
  const auto year = whole_text_as<int>(text.substr(0, 4));
  const auto month = whole_text_as<int>(text.substr(kMonthAt, 2));
  const auto day = whole_text_as<int>(text.substr(kDayAt, 2));
  if (!year || !month || !day || *month < 0 || *day < 0) return false;
  return std::chrono::year_month_day(std::chrono::year(*year),
                                     std::chrono::month(static_cast<unsigned>(*month)),
                                     std::chrono::day(static_cast<unsigned>(*day)))
      .ok();
}

}  // namespace

CalibratedValue Calibration::value_of(double raw) const {
  if (std::isinf(raw)) return {std::numeric_limits<double>::quiet_NaN(), false};
  const double value = gain * raw + offset;
  const bool outside = range && (value < range->first || value > range->second);
  return {value, !outside};
}

double Calibration::raw_of(double value) const { return (value - offset) / gain; }

std::string Calibration::text() const {
  std::string text = fmt::format("gain = {}, offset = {}", gain, offset);
  if (range) text += fmt::format(", range = [{}, {}]", range->first, range->second);
  if (!date.empty()) text += fmt::format(", date = {}", toml_quoted(date));
  if (!certificate.empty()) text += fmt::format(", certificate = {}", toml_quoted(certificate));
  return text;
}

Calibration read_calibration(const TomlTable& table) {
  Calibration calibration;
  calibration.gain = table.number("gain").value_or(1);
  if (calibration.gain == 0) table.fail("gain", "must not be 0: all readings would be equal");
  calibration.offset = table.number("offset").value_or(0);
  const auto range = table.numbers("range");
  if (table.has("range")) {
    if (range.size() != 2 || !(range[0] < range[1]))
      table.fail("range", "expected [MIN, MAX] in the unit of the channel");
    calibration.range = {range[0], range[1]};
  }
  calibration.date = table.text("date").value_or("");
  if (!calibration.date.empty() && !is_date(calibration.date))
    table.fail("date", fmt::format("{} is not a date; expected for example \"2026-03-17\"",
                                   excerpt(calibration.date)));
  calibration.certificate = table.text("certificate").value_or("");
  table.finish();
  return calibration;
}

std::string instrument_digest(const std::string& identity,
                              std::vector<std::pair<std::string, Calibration>> channels) {
  std::ranges::sort(channels, {}, [](const auto& one) { return one.first; });
  std::string text = toml_quoted(identity) + "\n";
  for (const auto& [name, calibration] : channels)
    text += fmt::format("{}: {}\n", toml_quoted(name), calibration.text());
  const auto source = open_memory("calibration", text);
  return sha256(*source);
}

}  // namespace triax::lab
