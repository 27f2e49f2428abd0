// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/faulty_spans.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::raw_header;

namespace {

template <class Spoil>
std::vector<FaultySpan> spans_after(const Spoil& spoil, const RecordHeader& header = raw_header()) {
  FaultySpans found(header);
  for (std::int64_t i = 0; i < 600; ++i) {
    Reading r = triax::lab::testing::reading({3, 0.001 * double(i), 0.4, 400, 300, 0}, i);
    for (std::size_t k = 0; k < 5; ++k)
      r.si[k] += 1e-4 * std::abs(r.si[k] + 1e-3) * standard_normal(1, k, std::uint64_t(i));
    spoil(r);
    found.add(r);
  }
  return found.spans();
}

void stick(Reading& r) {
  if (r.number >= 300) r[Quantity::axial_force] = 412.5;
}

/// What is left of a state without this channel.
State left_of(Quantity channel, const RecordHeader& header) {
  Reading reading;
  State s;
  s.strain = {1, 1};
  s.volumetric_strain = s.void_ratio = s.area_m2 = s.pore_pressure = s.p_eff = s.q = 1;
  s.effective_stress = {1, 1};
  reading[channel] = 1;
  remove_channel(channel, header, reading, s);
  CHECK_FALSE(reading.has(channel));
  return s;
}

}  // namespace

TEST_CASE("FaultySpans: a sound record has none") {
  CHECK(spans_after([](Reading&) {}).empty());
}

TEST_CASE("FaultySpans: a stuck channel is faulty from its first repeated value on") {
  const auto spans = spans_after(stick);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].channel == Quantity::axial_force);
  CHECK(spans[0].from <= 301);
  CHECK(spans[0].from >= 300);
  CHECK(spans[0].until == 599);
  CHECK(spans[0].lasts);
}

TEST_CASE("FaultySpans: a channel that comes back is faulty until then") {
  const auto spans = spans_after([](Reading& r) {
    if (r.number >= 300 && r.number < 400) r[Quantity::pore_pressure] = kMissing;
  });
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].from == 300);
  CHECK(spans[0].until == 399);
  CHECK_FALSE(spans[0].lasts);
}

TEST_CASE("FaultySpans: a spike is faulty, a few missing readings are not") {
  const auto spike = spans_after([](Reading& r) {
    if (r.number == 300) r[Quantity::axial_force] *= 3;
  });
  REQUIRE(spike.size() == 1);
  CHECK(spike[0].from == 300);
  CHECK(spike[0].until == 300);
  CHECK(spans_after([](Reading& r) {
          if (r.number >= 300 && r.number < 304) r[Quantity::axial_force] = kMissing;
        }).empty());
}

TEST_CASE("FaultySpans: a channel that is said to be sound has none") {
  auto header = raw_header();
  header.vouched = {Quantity::axial_force};
  CHECK(spans_after(stick, header).empty());
}

TEST_CASE("remove_channel: what is reduced from a raw channel goes with it") {
  const auto header = raw_header();
  const State force = left_of(Quantity::axial_force, header);
  CHECK(std::isnan(force.q));
  CHECK(std::isnan(force.p_eff));
  CHECK(force.pore_pressure == 1);
  CHECK(force.strain.axial == 1);
  const State pore = left_of(Quantity::pore_pressure, header);
  CHECK(pore.q == 1);
  CHECK(std::isnan(pore.p_eff));
  CHECK(std::isnan(pore.pore_pressure));
  const State displacement = left_of(Quantity::axial_displacement, header);
  CHECK(std::isnan(displacement.strain.axial));
  CHECK(std::isnan(displacement.q));
  CHECK(displacement.volumetric_strain == 1);
  const State volume = left_of(Quantity::back_volume, header);
  CHECK(std::isnan(volume.volumetric_strain));
  CHECK(volume.strain.axial == 1);
  CHECK(left_of(Quantity::cell_volume, header).q == 1);
}

TEST_CASE("remove_channel: of a reduced record its own columns go") {
  RecordHeader header;
  header.columns = {Quantity::axial_strain, Quantity::deviator_stress,
                    Quantity::mean_effective_stress};
  const State q = left_of(Quantity::deviator_stress, header);
  CHECK(std::isnan(q.q));
  CHECK(q.p_eff == 1);
  const State strain = left_of(Quantity::axial_strain, header);
  CHECK(std::isnan(strain.strain.axial));
  CHECK(strain.q == 1);
}
