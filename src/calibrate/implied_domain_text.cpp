// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/implied_domain_text.hpp"

#include <fmt/format.h>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

using study::Implied;
using study::ImpliedBoundary;

/// "0.868 (0.861 to 0.874)"; "–" where neither the best set nor the draws have it.
std::string with_interval(const Implied& of, double unit, int decimals) {
  const auto text = [&](const std::optional<double>& value) {
    return value ? number(*value / unit, decimals) : std::string(kUnknown);
  };
  if (!of.low) return text(of.best);
  return fmt::format("{} ({} to {})", text(of.best), text(of.low), text(of.high));
}

std::string ratio(const Implied& of) { return with_interval(of, 1, 3); }
std::string angle(const Implied& of) { return with_interval(of, sim::radians(1), 1); }
std::string share(const Implied& of) { return fmt::format("{:.0f} %", 100 * of.share); }

std::string boundaries(const std::vector<ImpliedBoundary>& side, const char* name) {
  if (side.empty()) return "";
  Table table{{{"p′ (kPa)", Align::right},
               {"η first unstable", Align::right},
               {"its α (°)", Align::right},
               {"η isotropic unloading", Align::right},
               {"η plastic limit", Align::right},
               {"sets", Align::right}},
              {}};
  for (const ImpliedBoundary& at : side)
    table.rows.push_back({in_kPa(at.p), ratio(at.first_unstable), angle(at.first_angle),
                          ratio(at.isotropic_unloading), ratio(at.limit),
                          share(at.first_unstable)});
  return fmt::format("  {}\n", name) + indented(to_text(table));
}

std::string cones(const study::ImpliedDomain& domain) {
  if (domain.cones.empty()) return "";
  Table table{{{"p′ (kPa)", Align::right},
               {"q (kPa)", Align::right},
               {"η", Align::right},
               {"first α (°)", Align::right},
               {"last α (°)", Align::right},
               {"opening (°)", Align::right},
               {"sets", Align::right}},
              {}};
  for (const study::ImpliedCone& cone : domain.cones)
    table.rows.push_back({in_kPa(cone.p), in_kPa(cone.q), number(cone.q / cone.p, 2),
                          angle(cone.from), angle(cone.to), angle(cone.opening), share(cone.from)});
  return "\n  cones of directions with negative second-order work\n" + indented(to_text(table));
}

/// What a reader must know of the draws.
std::string remarks(const study::ImpliedDomain& d) {
  std::string out;
  if (d.draws < d.asked)
    out += fmt::format(
        "  only {} of {} sets could be drawn: most sets compatible with the tests are outside the "
        "ranges or invalid for the law\n",
        d.draws, d.asked);
  if (d.refused > d.draws)
    out += fmt::format("  {} drawn sets are invalid for the law: intervals end at its bounds\n",
                       d.refused);
  return out;
}

}  // namespace

std::string void_ratio_in_words(const study::ImpliedDomain& domain) {
  return fmt::format("e = {:g}, the median of {}", domain.void_ratio,
                     domain.of_collapsed ? "the tests that collapsed" : "the tests");
}

std::string implied_domain_text(const study::ImpliedDomain& d) {
  std::string out =
      fmt::format("\nCones and domain that the set implies, at {}\n", void_ratio_in_words(d));
  if (!d.none.empty()) return out + "  " + d.none + "\n" + (d.draws > 0 ? remarks(d) : "");
  out += fmt::format(
      "  in brackets: the middle {:.0f} % of {} sets drawn from the estimate; sets: percentage "
      "with a value\n",
      100 * d.confidence, d.draws);
  return out + boundaries(d.compression, "compression") +
         (d.extension.empty() ? "" : "\n" + boundaries(d.extension, "extension")) + cones(d) +
         remarks(d);
}

}  // namespace triax::src
