// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/study/number_text.hpp"

namespace triax::src {
namespace {

std::optional<double> scaled(std::optional<double> value, double factor) {
  return value ? std::optional(*value * factor) : std::nullopt;
}

}  // namespace

std::string number(std::optional<double> value, int decimals) {
  return study::number_text(value, decimals);
}

std::string in_kPa(std::optional<double> pa, int decimals) {
  return number(scaled(pa, 1e-3), decimals);
}

std::string in_degrees(std::optional<double> rad, int decimals) {
  return number(rad ? std::optional(sim::degrees(*rad)) : std::nullopt, decimals);
}

std::string in_percent(std::optional<double> plain, int decimals) {
  return number(scaled(plain, 100), decimals);
}

std::string in_mm(std::optional<double> metres, int decimals) {
  return number(scaled(metres, 1e3), decimals);
}

std::string in_joule(double joule) { return fmt::format("{:.2e}", joule); }

std::string with_unit(const std::string& number, const std::string& unit) {
  return number == kUnknown ? number : number + ' ' + unit;
}

std::string duration(std::optional<double> seconds) {
  if (!seconds || !std::isfinite(*seconds)) return kUnknown;
  if (std::abs(*seconds) < 1000) return number(seconds, 1) + " s";
  if (std::abs(*seconds) < 36000) return number(*seconds / 60, 1) + " min";
  return number(*seconds / 3600, 2) + " h";
}

std::string sign_in_words(db::TestStatus status, const std::optional<db::SignOfLife>& sign) {
  if (!sign || status == db::TestStatus::complete) return {};
  return status == db::TestStatus::running
             ? fmt::format(", last heartbeat {} s ago", sign->silent_s)
             : fmt::format(", no heartbeat since {}", sign->at);
}

std::string status_in_words(db::TestStatus status, const std::optional<db::SignOfLife>& sign) {
  return std::string(db::to_string(status)) + sign_in_words(status, sign);
}

std::string inside_limit_surface(const lab::Collapse& collapse) {
  if (!collapse.inside_limit_surface) return collapse.onset ? "unknown" : kUnknown;
  return *collapse.inside_limit_surface ? "inside" : "on it";
}

std::string inside_limit_surface_or_reason(const lab::Collapse& collapse) {
  const bool has_reason = !collapse.limit_stress_ratio && !collapse.limit_source.empty();
  return has_reason ? collapse.limit_source : inside_limit_surface(collapse);
}

std::string instant(const lab::Instant& at) {
  std::string when = fmt::format("reading {}", at.reading);
  if (at.time_s) when += ", " + duration(at.time_s);
  const std::string values = stress_and_strain(at);
  return values.empty() ? when : when + ", " + values;
}

std::string stress_and_strain(const lab::Instant& at) {
  std::vector<std::string> parts;
  if (at.axial_strain) parts.push_back(fmt::format("ε₁ {} %", in_percent(at.axial_strain)));
  if (at.q_pa) parts.push_back(fmt::format("q {} kPa", in_kPa(at.q_pa)));
  if (at.p_eff_pa) parts.push_back(fmt::format("p′ {} kPa", in_kPa(at.p_eff_pa)));
  if (at.pore_pressure_pa) parts.push_back(fmt::format("u {} kPa", in_kPa(at.pore_pressure_pa)));
  if (at.eta()) parts.push_back(fmt::format("η {}", number(at.eta(), 2)));
  if (at.phi_mob_rad()) parts.push_back(fmt::format("φ_mob {}°", in_degrees(at.phi_mob_rad())));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string spaced(std::string name) {
  constexpr std::string_view kCompound = "second_order";
  if (const auto at = name.find(kCompound); at != std::string::npos)
    name.replace(at, kCompound.size(), "second-order");
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace triax::src
