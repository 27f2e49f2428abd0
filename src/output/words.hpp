// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values as people read them. Input SI, output units of the field; what is unknown reads "–".
#include <optional>
#include <string>

#include "db/store.hpp"
#include "lab/results/summary.hpp"

namespace triax::src {

inline constexpr const char* kUnknown = "–";
inline std::string or_unknown(const std::string& text) { return text.empty() ? kUnknown : text; }

/// A plain number with so many decimals.
std::string number(std::optional<double> value, int decimals);
/// Without unit, for table cells: the heading has the unit.
std::string in_kPa(std::optional<double> pa, int decimals = 1);
std::string in_degrees(std::optional<double> rad, int decimals = 2);
std::string in_percent(std::optional<double> plain, int decimals = 2);
std::string in_mm(std::optional<double> metres, int decimals = 2);
std::string in_joule(double joule);
/// With its unit: "12.5 s".
std::string with_unit(const std::string& number, const std::string& unit);
/// "41.0 s", "12.3 min" or "1.70 h", whichever is short.
std::string duration(std::optional<double> seconds);

/// A name of the JSON document as people read it: "second_order_work" is "second-order work".
std::string spaced(std::string name);

/// ", last sign of life 3 s ago"; ", no sign of life since 2026-11-23T06:39:12Z"; "" where there is
/// none, or none is needed.
std::string sign_in_words(db::TestStatus status, const std::optional<db::SignOfLife>& sign);
/// "complete"; "running, last sign of life 3 s ago".
std::string status_in_words(db::TestStatus status, const std::optional<db::SignOfLife>& sign);

/// "inside", "on it" or "unknown": where the onset is relative to the limit surface; a dash without
/// an onset.
std::string inside_limit_surface(const lab::Collapse& collapse);
/// The same; for a limit that is not known with the reason.
std::string inside_limit_surface_or_reason(const lab::Collapse& collapse);
/// "reading 812, 41.0 s, ε₁ 0.51 %, q 56.5 kPa, p′ 96.1 kPa, η 0.59, φ_mob 15.4°"; unknown parts
/// are left out.
std::string instant(const lab::Instant& at);
/// The same without reading and time.
std::string stress_and_strain(const lab::Instant& at);

}  // namespace triax::src
