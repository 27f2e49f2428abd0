// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/rig_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lab/base/statistics.hpp"
#include "lab/results/reading.hpp"
#include "lab/wire/device_modes.hpp"
#include "lab/wire/remote/wire_instruments.hpp"

namespace triax::lab {
namespace {

constexpr double kBetweenLooks_s = 0.5;

std::vector<std::string> states_to_check(const RigInstrument& one) {
  if (one.role == RigRole::reads) return {};
  return {one.role == RigRole::frame ? "state" : "piston"};
}

/// What an instrument said, look after look.
struct Said {
  std::vector<std::vector<CalibratedValue>> channels;  ///< a look each
  std::vector<double> answers_s;
  double state = kMissing;  ///< of a drive
};

ChannelCheck check_channel(const RigChannel& channel, std::size_t place, const Said& said) {
  ChannelCheck check{.name = channel.name,
                     .unit = channel.unit,
                     .value = kMissing,
                     .noise = kMissing,
                     .trouble = {}};
  std::vector<double> values;
  bool in_range = true;
  for (const auto& look : said.channels) {
    in_range = in_range && look[place].in_range;
    if (!std::isnan(look[place].value)) values.push_back(look[place].value);
  }
  if (!values.empty()) check.value = values.front();
  check.noise = standard_deviation(values);
  if (!in_range)
    check.trouble = "outside the calibrated range, or at the end of the instrument's range";
  else if (values.size() < said.channels.size())
    check.trouble = fmt::format("{} of {} responses without a value",
                                said.channels.size() - values.size(), said.channels.size());
  else if (channel.quantity && info(*channel.quantity).raw.absurd <
                                   std::fabs(check.value * channel.scale /
                                             sim::find_unit(info(*channel.quantity).unit)->scale))
    check.trouble = "impossible in a triaxial apparatus: unit, gain or offset is wrong";
  if (check.trouble.empty() && channel.calibration.date.empty() && channel.quantity)
    check.trouble = "no calibration date in the file";
  return check;
}

std::string trouble_of_drive(RigRole role, double state) {
  if (role == RigRole::reads || std::isnan(state) || state == 0) return {};
  if (role != RigRole::frame)
    return fmt::format("its cylinder is {}", state == 1 ? "full" : "empty");
  switch (static_cast<FrameState>(static_cast<int>(state))) {
    case FrameState::on_stop:
      return "the cap rests on the stop";
    case FrameState::end_of_travel:
      return "it is at the end of its travel";
    case FrameState::emergency_stop:
      return "its emergency stop is on";
    case FrameState::cannot_follow:
      return "the specimen does not follow it";
    case FrameState::ready:
    case FrameState::watchdog:
      return {};
  }
  return {};
}

/// A copy of which every value is read: one that no apparatus measures is reported, not rejected as
/// noise on the line.
RigFile without_quantities(RigFile rig) {
  for (RigInstrument& one : rig.instruments)
    for (RigChannel& channel : one.channels) channel.quantity.reset();
  return rig;
}

InstrumentCheck check_instrument(const WireInstrument& one, const std::vector<RigChannel>& channels,
                                 const Said& said) {
  InstrumentCheck check{
      .name = one.described().name,
      .link = to_text(one.described().link),
      .identity = one.identity(),
      .answer_s = median(said.answers_s),
      .trouble = one.ready() ? trouble_of_drive(one.described().role, said.state) : one.trouble(),
      .channels = {}};
  if (check.trouble.empty() && !one.ready()) check.trouble = "did not respond";
  for (std::size_t i = 0; i < channels.size(); ++i)
    check.channels.push_back(check_channel(channels[i], i, said));
  return check;
}

}  // namespace

std::vector<InstrumentCheck> check_rig(const RigFile& rig, double within_s,
                                       const std::function<bool()>& stop) {
  LineLoop loop;
  const RigFile read = without_quantities(rig);
  WireInstruments instruments(loop, read, states_to_check);
  instruments.connect(within_s, stop);
  std::map<const WireInstrument*, Said> all;
  for (int look = 0; look < kRigLooks && !(stop && stop()); ++look) {
    instruments.scan([&all](const WireInstrument& one, const WireInstrument::Scan& scan) {
      Said& said = all[&one];
      said.channels.push_back(scan.channels);
      if (scan.answered_s > 0) said.answers_s.push_back(scan.answered_s - scan.sent_s);
      if (!scan.also.empty() && !std::isnan(scan.also[0])) said.state = scan.also[0];
    });
    loop.run_for(kBetweenLooks_s);
  }
  std::vector<InstrumentCheck> checks;
  for (std::size_t i = 0; i < rig.instruments.size(); ++i) {
    const WireInstrument& one = *instruments.all()[i];
    checks.push_back(check_instrument(one, rig.instruments[i].channels, all[&one]));
  }
  return checks;
}

bool all_well(const std::vector<InstrumentCheck>& checks) {
  return std::ranges::all_of(checks, [](const InstrumentCheck& one) {
    return one.trouble.empty() &&
           std::ranges::all_of(one.channels, [](const auto& c) { return c.trouble.empty(); });
  });
}

}  // namespace triax::lab
