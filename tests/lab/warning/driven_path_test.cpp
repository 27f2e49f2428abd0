// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/driven_path.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::LoosePath;
using triax::lab::testing::shear_header;

namespace {

DrivenPath path_of(const RecordHeader& header) {
  DrivenPath path;
  path.start_stage(header.stage(1), true);
  return path;
}

}  // namespace

TEST_CASE("what drives a stage decides along what it is followed") {
  using enum DrivenPath::Control;
  const auto control = [](AxialControl by, Drainage drainage) {
    return DrivenPath::control_of(shear_header(by, drainage).stage(1));
  };
  CHECK(control(AxialControl::load, Drainage::closed) == strain_path);
  CHECK(control(AxialControl::displacement, Drainage::closed) == strain_path);
  CHECK(control(AxialControl::displacement, Drainage::open) == none);
  CHECK(control(AxialControl::constant_q, Drainage::open) == held_q_open);
  CHECK(control(AxialControl::constant_q, Drainage::closed) == held_q_shut);
}

TEST_CASE("the integrals over a path in closed form, and means of them, lie on its law") {
  // dq = (√p₀/k) √p′ (1 − η/η*) dε₁, so q = (√p₀/k)(∫√p′ dε₁ − ∫√p′ η dε₁/η*), reading by reading
  // and for their means alike.
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  for (const int readings : {50, 5000}) {
    DrivenPath path = path_of(header);
    for (int i = 0; i <= readings; ++i) path.add(loose.at(0.55 * i / readings, i));
    REQUIRE(path.means().size() <= DrivenPath::kMost);
    CHECK(path.readings() == readings + 1);
    double counted = 0;
    for (const PathMean& m : path.means()) {
      counted += m.readings;
      const double q = std::sqrt(loose.p0_pa) / loose.strain_per_eta *
                       (m.weighted[0] - m.weighted[1] / loose.eta_onset);
      CHECK(q == Approx(m.y).margin(readings < 100 ? 3 : 0.1));  // Pa, of 3e4
    }
    CHECK(counted == readings + 1);
  }
}

TEST_CASE("means of a long stage are spread over its η, and the latest readings stay single") {
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  DrivenPath path = path_of(header);
  constexpr int kReadings = 20000;
  for (int i = 1; i <= kReadings; ++i)
    path.add(loose.at(loose.eta_under_load(0.9999 * i / kReadings), i));
  const auto& means = path.means();
  CHECK(means.back().readings == 1);
  for (std::size_t i = 1; i < means.size(); ++i) {
    CHECK(means[i].eta > means[i - 1].eta);
    CHECK(means[i].eta - means[i - 1].eta < 0.6 / 30);
  }
}

TEST_CASE("a loop of unloading and the creep in it are left out of the path") {
  const RecordHeader header = shear_header(AxialControl::displacement);
  LoosePath loose;
  DrivenPath straight = path_of(header), looped = path_of(header);
  const auto later = [&](double eta, int i) {
    State state = loose.at(eta, i);
    state.strain.axial += 0.002;  // what the loop left behind
    return state;
  };
  for (int i = 1; i <= 100; ++i) straight.add(loose.at(0.004 * i, i));
  for (int i = 1; i <= 50; ++i) looped.add(loose.at(0.004 * i, i));
  for (int i = 1; i <= 20; ++i) looped.add(later(0.1, 50 + i));
  for (int i = 50; i <= 100; ++i) looped.add(later(0.004 * i, 20 + i));
  const auto &a = straight.means().back().weighted, &b = looped.means().back().weighted;
  for (std::size_t k = 0; k < a.size(); ++k) CHECK(b[k] == Approx(a[k]).epsilon(1e-9));
}

namespace {

/// A stiff loop from η = 0.4 down to 0.1 and back, 0.002 of strain and a fifth of p′ gone after it.
State in_loop(LoosePath& loose, int step, int reading) {
  constexpr int kHalf = 20;
  State s = loose.at(0.4, reading);
  const double back = 1 - std::fabs(step - kHalf) / kHalf;
  s.p_eff *= 1 - 0.2 * step / (2 * kHalf);
  s.q = (0.4 - 0.3 * back) * s.p_eff;
  s.strain.axial += 0.001 * step / kHalf - 0.0005 * back;
  return s;
}

State after_loop(LoosePath& loose, double eta, int reading) {
  State s = loose.at(eta, reading);
  s.q *= 0.8;
  s.p_eff *= 0.8;
  s.strain.axial += 0.002;
  return s;
}

}  // namespace

TEST_CASE("after a loop that took p′ from the specimen its path goes on without a step") {
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  DrivenPath path = path_of(header);
  for (int i = 1; i <= 100; ++i) path.add(loose.at(0.004 * i, i));
  const PathMean before = path.means().back();
  for (int step = 1; step < 40; ++step) path.add(in_loop(loose, step, 100 + step));
  // The way down and the way back are none of the path, however near to its end they run.
  CHECK(path.means().back().y == before.y);
  CHECK(path.readings() <= 103);
  for (int i = 0; i <= 20; ++i) path.add(after_loop(loose, 0.4 + 0.004 * i, 140 + i));
  const auto& means = path.means();
  double largest = 0;
  for (std::size_t i = 1; i < means.size(); ++i) {
    CHECK(means[i].y >= means[i - 1].y);
    CHECK(means[i].beside <= means[i - 1].beside);
    largest = std::max(largest, means[i].y - means[i - 1].y);
  }
  CHECK(largest < 0.05 * before.y);
  CHECK(means.back().y > before.y);
}

TEST_CASE("a path that turns to the other sense of shear after a loop is one that begins there") {
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  DrivenPath turned = path_of(header), begun = path_of(header);
  for (int i = 1; i <= 100; ++i) turned.add(loose.at(0.004 * i, i));
  for (int step = 1; step < 40; ++step) turned.add(in_loop(loose, step, 100 + step));
  for (int i = 0; i <= 20; ++i) turned.add(after_loop(loose, 0.4 + 0.004 * i, 140 + i));
  LoosePath other_way;
  for (int i = 1; i <= 40; ++i) {
    State state = other_way.at(0.01 * i, 200 + i);
    state.q = -state.q;
    state.strain.axial = -state.strain.axial;
    turned.add(state);
    begun.add(state);
  }
  REQUIRE(turned.means().size() == begun.means().size());
  CHECK(turned.readings() == begun.readings());
  for (std::size_t i = 0; i < begun.means().size(); ++i) {
    CHECK(turned.means()[i].y == begun.means()[i].y);
    CHECK(turned.means()[i].beside == begun.means()[i].beside);
    CHECK(turned.means()[i].weighted == begun.means()[i].weighted);
  }
}

TEST_CASE("two low readings in a row are outliers and no loop") {
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  DrivenPath path = path_of(header);
  for (int i = 1; i <= 100; ++i) {
    path.add(loose.at(0.004 * i, i));
    if (i % 10 == 0)
      for (int k = 0; k < 2; ++k) path.add(loose.at(0.3 * 0.004 * i, i));
  }
  CHECK(path.readings() >= 98);
  CHECK(path.means().back().q == Approx(loose.at(0.4, 100).q));
}

TEST_CASE("a stage that begins in a loop is the way back to the path, one at its end begins anew") {
  RecordHeader header = shear_header(AxialControl::load);
  header.stages.push_back(header.stages.front());
  header.stages.back().number = 2;
  LoosePath loose;
  DrivenPath path = path_of(header);
  CHECK_FALSE(path.goes_on_in(header.stage(2)));
  for (int i = 1; i <= 100; ++i) path.add(loose.at(0.004 * i, i));
  CHECK_FALSE(path.goes_on_in(header.stage(2)));
  for (int step = 1; step <= 20; ++step) path.add(in_loop(loose, step, 100 + step));
  CHECK(path.goes_on_in(header.stage(2)));
  StageInfo other = header.stages.back();
  other.drainage = Drainage::open, other.control = AxialControl::constant_q;
  CHECK_FALSE(path.goes_on_in(&other));
  other = header.stages.back();
  other.strain_path_R = 0.7;
  CHECK_FALSE(path.goes_on_in(&other));
  other = header.stages.back();
  other.role = StageRole::consolidation;
  CHECK_FALSE(path.goes_on_in(&other));
}

TEST_CASE(
    "a stage driven alike that begins anew below the largest η begins where that is regained") {
  RecordHeader header = shear_header(AxialControl::load);
  header.stages.push_back(header.stages.front());
  header.stages.back().number = 2;
  LoosePath loose;
  DrivenPath path = path_of(header);
  for (int i = 1; i <= 100; ++i) path.add(loose.at(0.004 * i, i));
  path.start_stage(header.stage(2), true);
  CHECK(path.means().empty());
  for (int i = 50; i < 99; ++i) path.add(loose.at(0.004 * i, 50 + i));
  CHECK(path.means().empty());
  for (int i = 100; i <= 120; ++i) path.add(loose.at(0.004 * i, 50 + i));
  REQUIRE(path.means().size() == 21);
  CHECK(path.means().front().eta == Approx(0.4));
}

TEST_CASE("in extension a path is what it is in compression, mirrored") {
  const RecordHeader header = shear_header(AxialControl::load);
  LoosePath loose;
  DrivenPath compression = path_of(header), extension = path_of(header);
  for (int i = 1; i <= 40; ++i) {
    State state = loose.at(0.01 * i, i);
    compression.add(state);
    state.q = -state.q;
    state.strain.axial = -state.strain.axial;
    extension.add(state);
  }
  CHECK(extension.in_extension());
  CHECK(extension.means().back().y == Approx(compression.means().back().y).epsilon(1e-12));
  CHECK(extension.means().back().weighted[1] ==
        Approx(compression.means().back().weighted[1]).epsilon(1e-12));
}

TEST_CASE("DrivenPath: the volume at constant q is that of the specimen") {
  SpecimenVolume volume;
  const StageInfo b_check{.number = 1, .name = {}, .role = StageRole::b_check};
  const StageInfo drained{
      .number = 2, .name = {}, .role = StageRole::consolidation, .drainage = Drainage::open};
  State s;
  s.q = 0;
  s.strain = {0, 0};
  s.volumetric_strain = 0;
  for (int i = 0; i <= 20; ++i) {
    s.stage = 1, s.p_eff = 2e4 + 2e3 * i, s.pore_pressure = 3e5 + 4e3 * i;
    volume.with_fluid(s, &b_check);
  }
  for (int i = 0; i <= 20; ++i) {
    s.stage = 2, s.p_eff = 2e4 + 4e3 * i, s.volumetric_strain = 3e-5 * std::sqrt(s.p_eff);
    volume.with_fluid(s, &drained);
  }
  const RecordHeader header = shear_header(AxialControl::constant_q, Drainage::open);
  DrivenPath path;
  s.q = 5e4;
  for (int i = 0; i <= 10; ++i) {
    s.stage = 1, s.p_eff = 2e5 - 1e4 * i, s.pore_pressure = 3e5 + 1e4 * i;
    s.volumetric_strain = 1e-3 - 1e-5 * i;
    s.time_s = i;
    const State with = volume.with_fluid(s, header.stage(1));
    if (i == 0) path.start_stage(header.stage(1), true, volume);
    path.add(with);
  }
  const auto& means = path.means();
  REQUIRE(means.size() == 11);
  REQUIRE(volume.compliance());
  const FluidCompliance& c = *volume.compliance();
  CHECK(c.at(4e5) > 0);
  CHECK(means.back().y - means.front().y ==
        Approx(1e-4 - (c.strain(4e5) - c.strain(3e5))).epsilon(1e-6));
  CHECK(path.compliance() == c.at(4e5));
}
