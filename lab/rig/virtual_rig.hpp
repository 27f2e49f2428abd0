#pragma once
// The rig with a specimen from sim/ instead of instruments on a bench.
//
// Between scans the specimen is advanced in ticks, and a wanted force is set anew at each. Stages
// end at scans, on the specimen's true values; the reading at which an end is met is the last of
// its stage. Transducers then make a reading of the true values; noise depends only on seed,
// channel and number of the reading. Time is number × interval. Everything is held in a few values:
// memory does not grow with the test.
//
// Channels: axial displacement and back volume count from the start of the test; axial force is
// that of an internal load cell, F = q A; cell volume is the water that follows the specimen's
// change of volume (the piston displaces none).
//
// Not modelled yet: membrane, inertia, stiffness of frame and load cell, cavitation (warned of when
// the pore pressure turns negative), incomplete saturation.
#include <cstdint>
#include <memory>
#include <optional>

#include "lab/programmes/programme.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::lab {

class VirtualRig : public BackEnd {
 public:
  /// `seed` replaces the programme's own. Throws BadInput if the programme was built by hand with
  /// values that its reader would refuse.
  explicit VirtualRig(const Programme& programme, std::optional<std::uint64_t> seed = {});
  ~VirtualRig() override;

  const RecordHeader& header() const override;
  /// A stage that does not reach its end, the end of the frame's travel and a control that the
  /// specimen does not allow end the test with a warning in the header; a state that the law cannot
  /// describe throws WorkFailed.
  bool next(Reading& reading) override;
  double progress() const override;
  /// See TruthWatch.
  std::optional<Truth> truth() const override;

  /// True state of the specimen at the last reading, which no instrument sees.
  const sim::SpecimenState& specimen_state() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
