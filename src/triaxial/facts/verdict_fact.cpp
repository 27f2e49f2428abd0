// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/verdict_fact.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/output/words.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {
namespace {

std::string collapse_word(lab::CollapseKind kind) {
  switch (kind) {
    case lab::CollapseKind::none:
      return "none";
    case lab::CollapseKind::limited:
      return "limited: strength is lost and recovered";
    case lab::CollapseKind::partial:
      return "partial: part of the strength is lost permanently";
    case lab::CollapseKind::flow:
      return "flow: strength is lost and not recovered";
    case lab::CollapseKind::cyclic_mobility:
      return "cyclic mobility: the specimen liquefied, but carried every cycle";
  }
  return kUnknown;
}

/// "5 % of q lost": of a collapse or a failure.
std::string loss_words(const lab::Collapse& collapse) {
  return collapse.strength_lost
             ? fmt::format("{:.0f} % of q was lost", *collapse.strength_lost * 100)
             : std::string("strength was lost");
}

std::string judged_words(const db::StoredTest& test) {
  const lab::Collapse& c = test.summary.collapse;
  std::string words = "shear was assessed to its end";
  if (c.judged_from) words += fmt::format(", from reading {}", *c.judged_from);
  if (c.nearest)
    words += fmt::format("; second-order work was smallest at reading {} ({:.3f} ± {:.3f})",
                         c.nearest->reading, c.nearest->normalised, c.nearest->error);
  return words;
}

std::string not_judged_line(const lab::Collapse& c) {
  if (c.judged_until)
    return fmt::format("not assessed after reading {}: {}; no collapse until then", *c.judged_until,
                       c.judged_until_reason);
  return "not assessed: " + (c.judged_until_reason.empty()
                                 ? std::string("too few readings in shear")
                                 : c.judged_until_reason);
}

std::string failure_line(const lab::Collapse& c) {
  return fmt::format("none: {} {}, which is failure, not collapse", loss_words(c),
                     c.inside_limit_surface == false ? "on the limit surface"
                                                     : "past the peak with the drainage open");
}

/// What leapt under a load that was carried on is told, and did not stay controllable.
std::string none_line(const db::StoredTest& test) {
  const auto& criteria = test.summary.collapse.criteria;
  const auto leap = std::ranges::find_if(criteria, [](const lab::Criterion& one) {
    return one.name == "loss_of_control" && one.reading;
  });
  const std::string found =
      leap == criteria.end()
          ? "none found: the specimen stayed controllable"
          : fmt::format(
                "none lasting: a runaway at reading {}, and the load was carried afterwards",
                *leap->reading);
  return found + "; " + judged_words(test);
}

}  // namespace

std::string verdict_line(const db::StoredTest& test) {
  if (test.status != db::TestStatus::complete) return "not assessed: the test is not complete";
  const auto& collapse = test.summary.collapse;
  if (!study::has_verdict(test)) return not_judged_line(collapse);
  if (study::failure_onset(test)) return failure_line(collapse);
  if (!collapse.detected()) return none_line(test);
  std::string line = collapse_word(collapse.kind);
  if (!collapse.inside_limit_surface)
    line += "; limit surface unknown";
  else
    line += *collapse.inside_limit_surface ? "; inside the Mohr-Coulomb limit surface"
                                           : "; on the Mohr-Coulomb limit surface";
  return line;
}

std::string verdict_word(db::TestStatus status, std::optional<lab::CollapseKind> kind) {
  if (status != db::TestStatus::complete) return std::string(db::to_string(status));
  return kind ? std::string(lab::to_string(*kind)) : "not assessed";
}

}  // namespace triax::src
