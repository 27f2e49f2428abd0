// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/correction/correct_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "db/corrections/correction.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/stated/set_value.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/session.hpp"
#include "src/study/correction/stored_rig.hpp"

namespace triax::study {
namespace {

constexpr std::string_view kName = "test.name";

lab::SetValue stated(const std::string& key, const std::string& value) {
  return {key, value, key + "=" + value};
}

/// "stages.N.role" for "stages.2.role", "sensors.CHANNEL" for any sensor.
std::string general_key(const std::string& key) {
  const std::string canonical = lab::canonical_key(key);
  if (lab::stage_of_key(canonical))
    return "stages.N" + canonical.substr(canonical.find('.', canonical.find('.') + 1));
  return canonical.starts_with("sensors.") ? "sensors.CHANNEL" : canonical;
}

/// Throws what set_value() does for a key or value that no test can have.
void check_values(const std::vector<std::pair<std::string, std::string>>& values) {
  const auto known = lab::metadata_keys();
  for (const auto& [key, value] : values) {
    lab::RecordHeader trial;
    if (!value.empty() || key == kName || key == "test.origin" || key == "test.seed")
      lab::set_value(trial, stated(key, value));
    else if (std::ranges::find(known, general_key(key)) == known.end())
      throw lab::BadInput(
          fmt::format("unknown key {}; {}", lab::excerpt(key), lab::suggestion(key, known)));
  }
}

void check_stages(const db::Correction& correction,
                  const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [key, value] : values) {
    const auto stage = lab::stage_of_key(key);
    if (stage && std::ranges::find(correction.stages(), *stage) == correction.stages().end())
      throw lab::BadInput(fmt::format("{}={}: test {} has no stage {}; it has {}", key, value,
                                      correction.test().id, *stage,
                                      fmt::join(correction.stages(), ", ")));
  }
}

/// True if two texts of a value are the same value: what was printed with 15 digits is.
bool is_same_value(const std::string& a, const std::string& b) {
  const auto x = lab::whole_text_as<double>(a), y = lab::whole_text_as<double>(b);
  constexpr double kRounding = 1e-13;
  if (x && y) return std::abs(*x - *y) <= kRounding * std::abs(*x);
  return a == b;
}

/// The values that replace those of revision 1, by key, in the order in which they came.
using Replaced = std::vector<std::pair<std::string, std::string>>;

void replace(Replaced& replaced, const lab::RecordHeader& first, const std::string& key,
             const std::string& value) {
  std::erase_if(replaced, [&](const auto& one) { return one.first == key; });
  if (!value.empty() && !is_same_value(lab::metadata_text(first, key), value))
    replaced.emplace_back(key, value);
}

lab::RecordHeader with(lab::RecordHeader header, const Replaced& replaced) {
  for (const auto& [key, value] : replaced) lab::set_value(header, stated(key, value));
  return header;
}

/// In the unit of the canonical key, as typed where it has that.
std::string canonical_value(const std::string& key, const std::string& value) {
  const std::string canonical = lab::canonical_key(key);
  if (canonical == key || value.empty()) return value;
  lab::RecordHeader trial;
  lab::set_value(trial, stated(key, value));
  return lab::metadata_text(trial, canonical);
}

/// One correction on its way.
class CorrectionRun {
 public:
  CorrectionRun(const std::string& db, std::int64_t id)
      : correction_(db, id), first_(header_to_replay(correction_.test(), correction_.first())) {
    for (const db::Revision& revision : correction_.test().revisions)
      for (const db::RevisedValue& value : revision.values)
        if (value.key != kName) replace(replaced_, first_, value.key, value.after);
  }

  Corrected run(const std::vector<std::pair<std::string, std::string>>& values,
                const std::function<void(double)>& on_part) {
    check_stages(correction_, values);
    const lab::RecordHeader former = with(first_, replaced_);
    lab::RecordHeader header = first_;
    for (const auto& [key, value] : values) {
      const std::string canonical = lab::canonical_key(key);
      if (canonical == kName)
        header.name = lab::trimmed(value);
      else
        replace(replaced_, first_, canonical, canonical_value(key, value));
    }
    header = with(std::move(header), replaced_);
    Corrected corrected{.revision = 0, .values = changes(values, former, header)};
    if (corrected.values.empty()) return corrected;
    check_can_be_reproduced();
    auto summary = assess(header, {correction_.listener(), {.progressed = on_part}});
    corrected.revision = correction_.commit(std::move(summary), corrected.values);
    return corrected;
  }

 private:
  std::vector<db::RevisedValue> changes(
      const std::vector<std::pair<std::string, std::string>>& values,
      const lab::RecordHeader& former, const lab::RecordHeader& header) const;
  lab::TestSummary assess(const lab::RecordHeader& header, const lab::SessionListeners& listeners);
  void check_can_be_reproduced();

  db::Correction correction_;
  lab::RecordHeader first_;
  Replaced replaced_;
};

std::vector<db::RevisedValue> CorrectionRun::changes(
    const std::vector<std::pair<std::string, std::string>>& values, const lab::RecordHeader& former,
    const lab::RecordHeader& header) const {
  std::vector<db::RevisedValue> all;
  for (const auto& [typed, value] : values) {
    db::RevisedValue one{.key = lab::canonical_key(typed), .before = {}, .after = {}};
    one.before = lab::metadata_text(former, one.key);
    one.after = lab::metadata_text(header, one.key);
    // A later correction starts from what was typed, with all of its digits.
    const auto kept = std::ranges::find(replaced_, one.key, &Replaced::value_type::first);
    if (kept != replaced_.end() && is_same_value(kept->second, one.after)) one.after = kept->second;
    const bool is_listed = std::ranges::find(all, one.key, &db::RevisedValue::key) != all.end();
    if (!is_listed && !is_same_value(one.before, one.after)) all.push_back(std::move(one));
  }
  return all;
}

lab::MembraneCorrection membrane_of(const std::string& text) {
  if (text == "astm") return lab::MembraneCorrection::astm;
  if (text == "iso") return lab::MembraneCorrection::iso;
  return lab::MembraneCorrection::none;
}

lab::TestSummary CorrectionRun::assess(const lab::RecordHeader& header,
                                       const lab::SessionListeners& listeners) {
  const db::StoredTest& test = correction_.test();
  const auto rig_of = [&](const lab::RecordHeader& of) {
    return std::make_unique<StoredRig>(correction_.readings(), test, of,
                                       correction_.first().ending.value_or(lab::RecordEnding{}));
  };
  lab::SessionOptions options;
  options.reduction.membrane = membrane_of(test.summary.membrane_correction);
  options.earlier = correction_.first().earlier;
  options.otherwise = [&] {
    return lab::judge_otherwise(header, options.reduction, [&](const lab::Guess::Said& said) {
      lab::RecordHeader other = header;
      lab::set_value(other, stated(said.key, said.value));
      return rig_of(other);
    });
  };
  const auto rig = rig_of(header);
  return lab::run_session(*rig, options, listeners);
}

/// Throws if the replay of a test that an older triax stored gives another onset: the database may
/// lack something that a replay needs.
void CorrectionRun::check_can_be_reproduced() {
  if (correction_.is_exact()) return;
  const lab::Collapse &stored = correction_.test().summary.collapse,
                      again = assess(first_, {}).collapse;
  const auto onset = [](const lab::Collapse& collapse) {
    return collapse.onset ? std::optional(collapse.onset->reading) : std::nullopt;
  };
  if (stored.judged != again.judged || stored.kind != again.kind || onset(stored) != onset(again))
    throw lab::BadInput(
        fmt::format("test {} was stored by an older triax, and its stored readings do not give its "
                    "stored result; replay its file with --set; nothing was changed",
                    correction_.test().id));
}

}  // namespace

Corrected correct_test(const std::string& db, std::int64_t id,
                       const std::vector<std::pair<std::string, std::string>>& values,
                       const std::function<void(double)>& on_part) {
  check_values(values);
  return CorrectionRun(db, id).run(values, on_part);
}

}  // namespace triax::study
