// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/wire_instruments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "lab/wire/device_modes.hpp"

namespace triax::lab {
namespace {

/// One scan of all instruments. Its handlers share its state: one that is called after the end of
/// this object finds it and does nothing.
class ScanOfAll {
 public:
  ScanOfAll(WireInstruments::Take take, std::size_t instruments)
      : state_(std::make_shared<State>(State{std::move(take), instruments})) {}
  ~ScanOfAll() { state_->take = nullptr; }
  ScanOfAll(const ScanOfAll&) = delete;
  ScanOfAll& operator=(const ScanOfAll&) = delete;

  std::function<void(const WireInstrument::Scan&)> handler_of(const WireInstrument& one) const {
    return [state = state_, &one](const WireInstrument::Scan& scan) {
      --state->open;
      if (state->take) state->take(one, scan);
    };
  }
  bool is_over() const { return state_->open == 0; }

 private:
  struct State {
    WireInstruments::Take take;
    std::size_t open;  ///< instruments that have not answered and are not late yet
  };
  std::shared_ptr<State> state_;
};

}  // namespace

WireInstruments::WireInstruments(
    LineLoop& loop, const RigFile& rig,
    const std::function<std::vector<std::string>(const RigInstrument&)>& also_of)
    : loop_(loop), rig_(rig) {
  for (const RigInstrument& one : rig.instruments)
    all_.push_back(std::make_unique<WireInstrument>(loop, one, also_of(one)));
}

std::string WireInstruments::connect(double within_s, const std::function<bool()>& stop) {
  for (const auto& one : all_) one->start();
  const auto ready = [](const auto& one) { return one->ready(); };
  loop_.run_until([&] { return std::ranges::all_of(all_, ready) || (stop && stop()); },
                  loop_.now_s() + within_s);
  std::string missing;
  for (const auto& one : all_)
    if (!one->ready())
      missing +=
          fmt::format("; {} at {}: {}", one->described().name, to_text(one->described().link),
                      one->trouble().empty() ? "did not respond" : one->trouble());
  return missing;
}

double WireInstruments::scan(const Take& take,
                             const std::function<double(const WireInstrument&)>& latest_s) const {
  constexpr double kNever_s = std::numeric_limits<double>::infinity();
  const ScanOfAll scan(take, all_.size());
  const double asked_s = loop_.now_s();
  for (const auto& one : all_)
    one->scan(scan.handler_of(*one), asked_s, latest_s ? latest_s(*one) : kNever_s);
  // Line::ask ends every question by its deadline.
  loop_.run_until([&scan] { return scan.is_over(); }, kNever_s);
  return asked_s;
}

WireInstrument* WireInstruments::with(RigRole role) const {
  const auto found =
      std::ranges::find_if(all_, [role](const auto& one) { return one->described().role == role; });
  return found == all_.end() ? nullptr : found->get();
}

bool WireInstruments::simulated() const {
  return rig_.plant || std::ranges::any_of(all_, [](const auto& one) {
           return one->identity().find(kSimulatedWord) != std::string::npos;
         });
}

std::vector<Note> WireInstruments::identities() const {
  std::vector<Note> notes;
  for (const auto& one : all_) {
    std::vector<std::pair<std::string, Calibration>> channels;
    for (const RigChannel& channel : one->described().channels)
      channels.emplace_back(channel.name, channel.calibration);
    std::string text =
        fmt::format("{} at {}", one->identity().empty() ? "gives no identity" : one->identity(),
                    to_text(one->described().link));
    for (const auto& [name, calibration] : channels)
      text += fmt::format("; {}: {}", name, calibration.text());
    text +=
        "; SHA-256 of identity and calibrations " + instrument_digest(one->identity(), channels);
    notes.push_back({.label = "instrument " + one->described().name, .text = std::move(text)});
  }
  return notes;
}

}  // namespace triax::lab
