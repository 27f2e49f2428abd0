// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/test_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/collapse/stress_span.hpp"
#include "src/study/triaxial/read_again.hpp"
#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

// What soil mechanics calls a specimen; outside, a unit is wrong.
constexpr double kLeastPressure_Pa = 100, kMostPressure_Pa = 1e8;
constexpr double kMostStrain = 0.8, kMostVolumetricStrain = 0.5;
constexpr double kLeastVoidRatio = 0.1, kMostVoidRatio = 5;
constexpr std::size_t kNumbersOfATest = 4;

[[noreturn]] void refuse(const db::StoredTest& test, const std::string& why) {
  throw lab::BadInput(fmt::format("test {} {}", test.header.name, why));
}

struct Shear {
  std::vector<lab::State> states;
  bool constant_q = false;
};

Shear shear_of(const db::Store& store, const db::StoredTest& test) {
  Shear shear;
  store.for_each_scan(test.id, 1, [&](const lab::Reading&, const lab::State& state) {
    if (!is_shear(test.header, state.stage)) return;
    if (!std::isfinite(state.strain.axial + state.q + state.p_eff)) return;
    shear.states.push_back(state);
    const auto* stage = test.header.stage(state.stage);
    shear.constant_q |= stage != nullptr && stage->control == lab::AxialControl::constant_q;
  });
  return shear;
}

bool has_volume(const Shear& shear) {
  return std::ranges::all_of(
      shear.states, [](const lab::State& s) { return std::isfinite(s.volumetric_strain); });
}

Imposed imposed_on(const db::StoredTest& test, const Shear& shear) {
  if (shear.constant_q) return Imposed::stress_path;
  return drainage_of_shear(test.header, shear.states) == lab::Drainage::open ? Imposed::drained
                                                                             : Imposed::undrained;
}

void check_units(const db::StoredTest& test, const MeasuredPath& path, const Shear& shear) {
  const double p = path.start.p_eff;
  if (!(p >= kLeastPressure_Pa && p <= kMostPressure_Pa))
    refuse(test,
           fmt::format(
               "starts at p' {:g} kPa; expected 0.1 kPa to 100 MPa: check the unit of its stresses",
               p / 1e3));
  if (!(path.void_ratio >= kLeastVoidRatio && path.void_ratio <= kMostVoidRatio))
    refuse(test, fmt::format("has a void ratio of {:g}; expected {:g} to {:g}", path.void_ratio,
                             kLeastVoidRatio, kMostVoidRatio));
  for (const auto& s : shear.states) {
    if (std::abs(s.strain.axial) > kMostStrain)
      refuse(
          test,
          fmt::format(
              "reaches an axial strain of {:.0f} %; check the unit: expected a number without unit",
              100 * s.strain.axial));
    if (path.imposed != Imposed::undrained && std::abs(s.volumetric_strain) > kMostVolumetricStrain)
      refuse(test, fmt::format("reaches a volumetric strain of {:.0f} %; check the unit: expected "
                               "a number without unit",
                               100 * s.volumetric_strain));
    if (s.p_eff > kMostPressure_Pa)
      refuse(test,
             fmt::format("reaches p' {:g} kPa; check the unit of its stresses", s.p_eff / 1e3));
  }
}

/// σ₃′ is imposed: its noise would be answered by the law. A straight line through the readings
/// nearby, a twentieth of all to each side.
void smooth_radial_stress(std::vector<ShearReading>& readings) {
  const auto count = static_cast<std::ptrdiff_t>(readings.size());
  const std::ptrdiff_t half = std::max<std::ptrdiff_t>(count / 20, 2);
  const std::vector<ShearReading> raw = readings;
  const auto radial = [&](std::ptrdiff_t i) {
    const auto& r = raw[static_cast<std::size_t>(i)];
    return r.p_eff - r.q / 3;
  };
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(i - half, 0);
    const std::ptrdiff_t to = std::min(i + half, count - 1);
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::ptrdiff_t k = from; k <= to; ++k) {
      const auto x = static_cast<double>(k - i);
      ++n, sx += x, sy += radial(k), sxx += x * x, sxy += x * radial(k);
    }
    const double slope = (n * sxy - sx * sy) / std::max(n * sxx - sx * sx, 1e-300);
    auto& r = readings[static_cast<std::size_t>(i)];
    r.p_eff = (sy - slope * sx) / n + r.q / 3;
  }
}

std::vector<ShearReading> readings_of(const db::StoredTest& test, const MeasuredPath& path,
                                      const Shear& shear) {
  // A stress path is followed as far as it can be held.
  auto last = std::numeric_limits<std::int64_t>::max();
  if (const auto onset = collapse_onset(test); onset && path.imposed == Imposed::stress_path)
    last = onset->reading;
  std::vector<ShearReading> readings;
  for (const auto& s : shear.states)
    if (s.reading <= last)
      readings.push_back({s.strain.axial,
                          path.imposed == Imposed::undrained ? 0 : s.volumetric_strain, s.p_eff,
                          s.q});
  if (path.imposed == Imposed::drained && readings.size() > 4) smooth_radial_stress(readings);
  return readings;
}

void note_onset(const db::StoredTest& test, MeasuredPath& path) {
  const auto onset = collapse_onset(test);
  if (!onset) return;
  path.onset_eta = onset->eta();
  if (onset->interval)
    path.onset_eta_error =
        (onset->interval->eta.high - onset->interval->eta.low) / (2 * lab::StressSpan::kOf95);
}

}  // namespace

MeasuredPath path_of_test(const db::Store& store, std::int64_t id, const PathOptions& options) {
  const db::StoredTest test = store.load(id);
  if (test.summary.cyclic) refuse(test, "is cyclic; expected monotonic loading: leave it out");
  const auto e = void_ratio(test);
  if (!e)
    refuse(test, "has no void ratio: replay it with --set specimen.void_ratio=E, or leave it out");
  const Shear shear = shear_of(store, test);
  if (shear.states.size() < 8) refuse(test, "has fewer than 8 readings of shear; leave it out");
  MeasuredPath path{.test = id,
                    .name = test.header.name,
                    .material = test.header.specimen.material,
                    .simulated = test.header.origin == lab::Origin::simulated,
                    .imposed = imposed_on(test, shear),
                    .void_ratio = *e};
  if (path.imposed != Imposed::undrained && !has_volume(shear))
    refuse(test, "is drained but has no volume change; leave it out");
  const auto readings = readings_of(test, path, shear);
  path.start = {readings.front().axial_strain, readings.front().volumetric_strain,
                readings.front().p_eff, readings.front().q, 0};
  check_units(test, path, shear);
  note_onset(test, path);
  try {
    lay_knots(path, readings, options);
  } catch (const std::invalid_argument& error) {
    refuse(test, fmt::format("cannot be followed: {}; leave it out", error.what()));
  }
  return path;
}

std::vector<MeasuredPath> paths_of_tests(const db::Store& store,
                                         const std::vector<std::int64_t>& ids,
                                         const PathOptions& options) {
  std::vector<TestResult> tests;
  tests.reserve(ids.size());
  for (const std::int64_t id : ids) tests.push_back(load_test_result(store, id, WithCurves::no));
  const auto left_out = read_again(tests);
  std::vector<MeasuredPath> paths;
  for (const std::int64_t id : ids)
    if (!left_out.contains(id) && std::ranges::find(paths, id, &MeasuredPath::test) == paths.end())
      paths.push_back(path_of_test(store, id, options));
  for (const auto& path : paths)
    if (const auto& first = paths.front();
        !path.material.empty() && !first.material.empty() && path.material != first.material)
      throw lab::BadInput(
          fmt::format(R"(tests of two soils: {} is of "{}", {} of "{}"; calibrate on one soil)",
                      first.name, first.material, path.name, path.material));
  return paths;
}

void check_enough(std::size_t unknowns, const std::vector<MeasuredPath>& paths) {
  if (paths.empty()) throw lab::BadInput("no test to calibrate on; give tests of the database");
  if (unknowns == 0) throw lab::BadInput("no parameter is free; give some with --free");
  const std::size_t most = kNumbersOfATest * paths.size();
  if (unknowns <= most) return;
  throw lab::BadInput(fmt::format(
      "{} free parameters from {} test{}: at most {} can be determined from {}; give {} tests or "
      "more, or fix some with --fix",
      unknowns, paths.size(), paths.size() == 1 ? "" : "s", most, paths.size() == 1 ? "it" : "them",
      (unknowns + kNumbersOfATest - 1) / kNumbersOfATest));
}

}  // namespace triax::study
