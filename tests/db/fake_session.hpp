// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a session would tell, told by the test itself.
#include "db/recording/recorder.hpp"
#include "lab/rig/session_listener.hpp"
#include "tests/db/scans.hpp"

namespace triax::testing {

/// A header as of a recorded undrained test with raw channels.
inline lab::RecordHeader raw_header(const std::string& name) {
  using enum lab::Quantity;
  lab::RecordHeader header;
  header.name = name;
  header.programme = "ICU";
  header.source = name + ".csv";
  header.columns = {axial_displacement, axial_force,   cell_pressure,
                    back_pressure,      pore_pressure, back_volume};
  header.specimen.height_m = 0.14;
  header.specimen.diameter_m = 0.07;
  header.stages = {
      {1, "shear", lab::StageRole::shear, lab::Drainage::closed, lab::AxialControl::displacement}};
  return header;
}

/// Sends `count` plausible scans from number `first` on.
inline void send_scans(const lab::SessionListener& listener, std::int64_t first,
                       std::int64_t count) {
  std::mt19937_64 random(static_cast<std::uint64_t>(first));
  for (std::int64_t number = first; number < first + count; ++number) {
    const auto [reading, state] = raw_scan(random, number);
    listener.scanned(reading, state);
  }
}

/// Starts a test with raw_header(name) and ten readings. Returns the listener of the recorder.
inline lab::SessionListener start_test(db::Recorder& recorder, const std::string& name = "a") {
  const lab::SessionListener listener = recorder.listener();
  listener.started(raw_header(name));
  send_scans(listener, 0, 10);
  return listener;
}

}  // namespace triax::testing
