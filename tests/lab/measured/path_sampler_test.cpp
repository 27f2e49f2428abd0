// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_sampler.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;
using Signal = PathSample::Signal;

TEST_CASE("progress is time where there is time, else the way along the axial strain") {
  SyntheticPath path;
  PathSampler timed(true), timeless(false);
  double way = 0;
  for (const std::int64_t i : {0, 10, 4, 20}) {  // forth, back and forth
    State s = path.state(i);
    s.time_s = 7.0 + static_cast<double>(i);
    CHECK(timed.sample(s)->signal[Signal::progress] == s.time_s);
    if (i == 10) way = 10 * path.strain_step;
    if (i == 4) way = 16 * path.strain_step;
    if (i == 20) way = 32 * path.strain_step;
    const auto sample = timeless.sample(s);
    CHECK(sample->signal[Signal::progress] == Approx(way).margin(1e-15));
    CHECK(sample->signal[Signal::q] == s.q);
    CHECK(sample->signal[Signal::p_eff] == s.p_eff);
    CHECK(sample->signal[Signal::reading] == static_cast<double>(i));
  }
}

TEST_CASE("a gap of the pore pressure is no sample; a record without any has all of them") {
  SyntheticPath path;
  PathSampler with(true), without(true);
  CHECK(with.sample(path.state(0)));
  State gap = path.state(1);
  gap.pore_pressure = kMissing;
  CHECK_FALSE(with.sample(gap));
  CHECK(with.sample(path.state(2)));
  CHECK(without.sample(gap));
}

TEST_CASE("what is complete, and which stages are watched") {
  State s = SyntheticPath().state(5);
  CHECK(complete(s));
  for (double State::*value : {&State::q, &State::p_eff, &State::volumetric_strain}) {
    State hole = s;
    hole.*value = kMissing;
    CHECK_FALSE(complete(hole));
  }
  CHECK(is_watched(nullptr));
  StageInfo stage;
  CHECK(is_watched(&stage));
  stage.role = StageRole::shear;
  CHECK(is_watched(&stage));
  stage.role = StageRole::consolidation;
  CHECK_FALSE(is_watched(&stage));
}
