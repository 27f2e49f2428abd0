// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All instruments of a rig, on the controller's side.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/wire/remote/wire_instrument.hpp"

namespace triax::lab {

class WireInstruments {
 public:
  /// `also_of`: the points that are read of an instrument beside its channels. Loop and rig outlive
  /// it. Throws BadInput where an instrument does not have what it is to be asked.
  WireInstruments(LineLoop& loop, const RigFile& rig,
                  const std::function<std::vector<std::string>(const RigInstrument&)>& also_of);

  /// Opens all links and waits until every instrument is ready, or `stop` says so. Gives a line for
  /// each that is not, with the cause; empty: all are.
  std::string connect(double within_s, const std::function<bool()>& stop);
  using Take = std::function<void(const WireInstrument&, const WireInstrument::Scan&)>;
  /// Asks all at one instant and waits for all answers, which come or are late: by the deadline of
  /// each from that instant on, or by `latest_s` of it, on the loop's clock. Gives that instant.
  /// `take` is called once for each instrument, and not after this has returned or thrown.
  double scan(const Take& take,
              const std::function<double(const WireInstrument&)>& latest_s = {}) const;

  const std::vector<std::unique_ptr<WireInstrument>>& all() const { return all_; }
  WireInstrument* with(RigRole role) const;
  /// Whether any says that what it measures is simulated, or the rig is one that is served: an
  /// instrument need not say who it is.
  bool simulated() const;
  /// Who they are, as of now, with calibrations and their digest: a note each for the record.
  std::vector<Note> identities() const;

 private:
  LineLoop& loop_;
  const RigFile& rig_;
  std::vector<std::unique_ptr<WireInstrument>> all_;
};

}  // namespace triax::lab
