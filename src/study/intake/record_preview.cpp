// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/record_preview.hpp"

#include <algorithm>
#include <array>

#include "lab/base/bad_input.hpp"
#include "lab/records/metadata.hpp"
#include "lab/reduction/reduction.hpp"

namespace triax::study {
namespace {

constexpr std::int64_t kMaxReadings = 200'000;

struct PathPoint {
  double p_eff_pa = 0, q_pa = 0, axial_strain = 0;
};

std::vector<PathPoint> reduce_all(lab::RecordedRig& rig) {
  lab::Reduction reduction(rig.header(), {});
  std::vector<PathPoint> points;
  lab::Reading reading;
  while (static_cast<std::int64_t>(points.size()) < kMaxReadings && rig.next(reading)) {
    const lab::State state = reduction.reduce(reading);
    points.push_back({state.p_eff, state.q, state.strain.axial});
  }
  return points;
}

/// Evenly over the readings, with the first and the last.
Json path_json(const std::vector<PathPoint>& points) {
  constexpr std::size_t kMaxPoints = 800;
  const std::size_t count = std::min(kMaxPoints, points.size());
  Json p_eff = Json::array(), q = Json::array(), strain = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const PathPoint& point = points[count < 2 ? 0 : i * (points.size() - 1) / (count - 1)];
    p_eff.push_back(json_kPa(point.p_eff_pa));
    q.push_back(json_kPa(point.q_pa));
    strain.push_back(json_number(point.axial_strain));
  }
  return {{"p_eff_kPa", std::move(p_eff)},
          {"q_kPa", std::move(q)},
          {"axial_strain", std::move(strain)}};
}

}  // namespace

Json missing_keys(const lab::RecordHeader& header) {
  constexpr int kMaxKeys = 8;
  Json missing = Json::array();
  lab::RecordHeader with_keys = header;
  for (int tries = 0; tries < kMaxKeys; ++tries) try {
      const lab::Reduction can_be_reduced(with_keys, {});
      break;
    } catch (const lab::MissingKey& error) {
      missing.push_back({{"key", error.key()},
                         {"label", error.label()},
                         {"unit", json_text(error.unit())},
                         {"why", error.what()}});
      lab::set_metadata(with_keys, "asked for", error.key(), "100");
    }
  return missing;
}

Json guesses_json(const std::vector<lab::Guess>& guesses) {
  Json list = Json::array();
  for (const lab::Guess& guess : guesses) {
    Json otherwise = Json::array();
    for (const auto& said : guess.otherwise) otherwise.push_back(said.key + '=' + said.value);
    list.push_back({{"what", guess.what},
                    {"taken", guess.taken},
                    {"evidence", guess.evidence},
                    {"remedy", guess.remedy},
                    {"otherwise", std::move(otherwise)}});
  }
  return list;
}

Json warnings_json(const std::vector<lab::Warning>& warnings) {
  constexpr std::size_t kMaxWarnings = 50;
  Json texts = Json::array();
  for (const lab::Warning& warning : warnings)
    if (texts.size() < kMaxWarnings) texts.push_back(warning.text);
  return texts;
}

Json preview_json(lab::RecordedRig& rig) {
  Json out = {{"missing", missing_keys(rig.header())},
              {"guessed", guesses_json(rig.header().guesses)},
              {"warnings", Json::array()},
              {"readings", 0},
              {"path", nullptr}};
  if (out["missing"].empty()) {
    const std::vector<PathPoint> points = reduce_all(rig);
    out["readings"] = points.size();
    out["path"] = path_json(points);
  }
  out["warnings"] = warnings_json(rig.header().warnings);
  return out;
}

}  // namespace triax::study
