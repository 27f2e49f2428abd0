// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings of a virtual test, drawn once, and the same readings with sensors broken.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/back_end.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::lab::testing {

struct DrawnTest {
  RecordHeader header;
  std::vector<Reading> readings;
  std::optional<Truth> truth;

  std::int64_t size() const { return static_cast<std::int64_t>(readings.size()); }
  /// First reading of the last stage.
  std::int64_t last_stage() const {
    std::int64_t i = size() - 1;
    while (i > 0 && readings[static_cast<std::size_t>(i - 1)].stage == readings.back().stage) --i;
    return i;
  }
};

/// `perfect`: transducers without any imperfection.
inline DrawnTest draw(const std::string& name, std::optional<std::uint64_t> seed = {},
                      bool perfect = false) {
  Programme programme = load_programme("samples/programmes/" + name + ".toml");
  if (perfect) {
    for (Transducer& t : programme.transducers) t = Transducer{.unit = t.unit};
    // Without noise a dip after a coarse step of the cell pressure looks like a spike.
    for (auto* controller : {&programme.cell_controller, &programme.back_controller})
      controller->pressure_resolution_pa = 0;
  }
  VirtualRig rig(programme, seed);
  DrawnTest test;
  for (Reading reading; rig.next(reading);) test.readings.push_back(reading);
  test.header = rig.header();
  test.truth = rig.truth();
  return test;
}

/// Changes the value of a channel as it is read.
using Break = std::function<void(Reading&)>;

class FaultyRig : public BackEnd {
 public:
  FaultyRig(const DrawnTest& test, std::vector<Break> breaks)
      : test_(test), breaks_(std::move(breaks)) {}
  const RecordHeader& header() const override { return test_.header; }
  bool next(Reading& reading) override {
    if (i_ == test_.readings.size()) return false;
    reading = test_.readings[i_++];
    for (const Break& b : breaks_) b(reading);
    return true;
  }
  double progress() const override { return 0; }
  std::optional<Truth> truth() const override { return test_.truth; }

 private:
  const DrawnTest& test_;
  std::vector<Break> breaks_;
  std::size_t i_ = 0;
};

inline TestSummary judge(const DrawnTest& test, std::vector<Break> breaks = {}) {
  FaultyRig rig(test, std::move(breaks));
  return run_session(rig, {});
}

/// The channel keeps the value it had at reading `from`.
inline Break stuck(Quantity q, std::int64_t from, std::int64_t until = INT64_MAX) {
  return [=, held = kMissing](Reading& r) mutable {
    if (r.number == from) held = r[q];
    if (r.number >= from && r.number < until) r[q] = held;
  };
}
/// The channel shows one value whatever happens.
inline Break constant(Quantity q, double value, std::int64_t from, std::int64_t until = INT64_MAX) {
  return [=](Reading& r) {
    if (r.number >= from && r.number < until) r[q] = value;
  };
}
inline Break missing(Quantity q, std::int64_t from, std::int64_t until = INT64_MAX) {
  return constant(q, kMissing, from, until);
}
inline Break spike(Quantity q, double height, std::int64_t at, int width = 1) {
  return [=](Reading& r) {
    if (r.number >= at && r.number < at + width) r[q] += height;
  };
}

/// Full scale of the samples' transducers, of the volume gauges some of their 200 cm³.
inline double open_circuit(Quantity q) {
  switch (q) {
    case Quantity::axial_displacement:
      return 0.025;
    case Quantity::axial_force:
      return 2000;
    case Quantity::pore_pressure:
      return 1e6;
    case Quantity::back_volume:
    case Quantity::cell_volume:
      return 1e-4;
    default:
      return 2e6;
  }
}

}  // namespace triax::lab::testing
