// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/trial.hpp"

#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"

using namespace triax;

namespace {

bench::Subject icu() { return {lab::load_programme("samples/programmes/icu_6.toml"), true}; }

}  // namespace

TEST_CASE("what a seed varies stays within what the header promises, and is the same each time") {
  const bench::Subject subject = icu();
  const auto& own = subject.programme;
  bool differs = false;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const lab::Programme p = bench::varied(subject, seed);
    CHECK(std::abs(p.void_ratio - own.void_ratio) <= 0.01);
    const double noise = p.transducers[0].noise_rms / own.transducers[0].noise_rms;
    CHECK((noise == 0.5 || noise == 1 || noise == 2 || noise == 4));
    const double rate = p.stages.back().axial_rate_m_per_s / own.stages.back().axial_rate_m_per_s;
    CHECK(rate >= 0.5);
    CHECK(rate <= 2);
    const double stress = (*p.stages[2].cell.target_pa - own.initial_back_pressure_pa) /
                          (*own.stages[2].cell.target_pa - own.initial_back_pressure_pa);
    CHECK(stress == Approx(1).margin(0.1));
    // The stage ends where its ramp does.
    CHECK(*p.stages[2].end[0].above == Approx(*p.stages[2].cell.target_pa).epsilon(1e-12));
    differs = differs || noise != 1;
    CHECK(bench::varied(subject, seed).void_ratio == p.void_ratio);
  }
  CHECK(differs);
}

TEST_CASE("a trial of a loose specimen: truth, the monitor and the naive methods beside it") {
  const bench::TrialResult r = bench::run_trial(icu(), 1);
  REQUIRE(r.truth_lost);
  CHECK(r.programme == icu().programme.name);
  CHECK(r.type == icu().programme.type);
  CHECK(r.material == icu().programme.material.name);
  CHECK(r.seed == 1);
  CHECK(r.collapses);
  CHECK(r.comparable());
  const double reading = r.truth_time_s / icu().programme.logging.interval_s;
  CHECK(double(r.truth_reading) >= reading);
  CHECK(double(r.truth_reading) < reading + 1);
  CHECK(r.outcomes[0].detected);
  REQUIRE(r.outcomes[1].delay);
  // The sign of neighbouring increments is noise: it is negative before anything happens.
  REQUIRE(r.outcomes[2].detected);
  CHECK(*r.outcomes[2].delay < 0);
  CHECK(*r.outcomes[0].eta_error < *r.outcomes[2].eta_error);
}
