// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/reduction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/reduction/b_value.hpp"
#include "lab/reduction/closure.hpp"
#include "lab/reduction/raw_reduction.hpp"
#include "lab/reduction/reduced_columns.hpp"

namespace triax::lab {

struct Reduction::Impl {
  Impl(const RecordHeader& h, const ReductionOptions& options)
      : header(h),
        membrane(options.membrane),
        raw(h.is_raw()),
        from_raw(h, options),
        from_columns(h) {
    if (!raw && options.membrane != MembraneCorrection::none)
      throw BadInput(h.source, 0,
                     "the record has reduced stresses and no raw channels: its membrane correction "
                     "cannot be changed; leave --membrane out");
  }

  void note_impossible(const State& state, std::int64_t line);

  const RecordHeader header;
  const MembraneCorrection membrane;
  const bool raw;
  RawReduction from_raw;
  ReducedColumns from_columns;
  BValue b_value;
  Closure closure;
  std::int64_t impossible = 0, impossible_in_a_row = 0;
  Warning first_impossible;    ///< of those in a row
  Warning impossible_warning;  ///< of the first at all
};

namespace {

bool is_impossible(const State& s) {
  return std::fabs(s.strain.axial) >= 1 || std::fabs(s.volumetric_strain) >= 1;
}

State unknown(const State& at) {
  State s;
  s.reading = at.reading;
  s.time_s = at.time_s;
  s.stage = at.stage;
  s.pore_pressure = at.pore_pressure;
  return s;
}

}  // namespace

/// A few are readings of a sensor that dropped out; more are a record in wrong units.
void Reduction::Impl::note_impossible(const State& state, std::int64_t line) {
  Warning warning{line, fmt::format("axial strain {:.3g}, volumetric strain {:.3g}: impossible, a "
                                    "strain cannot reach 1 or -1",
                                    state.strain.axial, state.volumetric_strain)};
  if (impossible_in_a_row++ == 0) first_impossible = warning;
  if (impossible_in_a_row > kMostImpossible)
    throw BadInput(header.source, first_impossible.line,
                   first_impossible.text + "; check the units and the height of the specimen");
  if (++impossible == 1) impossible_warning = std::move(warning);
}

Reduction::Reduction(const RecordHeader& header, const ReductionOptions& options)
    : impl_(std::make_unique<Impl>(header, options)) {}

Reduction::~Reduction() = default;

State Reduction::reduce(const Reading& reading) {
  Impl& r = *impl_;
  State state = r.raw ? r.from_raw.reduce(reading) : r.from_columns.reduce(reading);
  if (is_impossible(state)) {
    // A simulation has no wrong units: there it is a broken sensor.
    if (r.header.origin != Origin::simulated) r.note_impossible(state, reading.line);
    return unknown(state);
  }
  r.impossible_in_a_row = 0;
  if (r.raw) {
    const StageInfo* stage = r.header.stage(reading.stage);
    r.b_value.add(reading, stage && stage->role == StageRole::b_check);
    r.closure.add(reading, state, !stage || stage->role == StageRole::shear);
  }
  return state;
}

std::string Reduction::membrane_correction() const {
  if (!impl_->raw) return {};
  switch (impl_->membrane) {
    case MembraneCorrection::none:
      return "none";
    case MembraneCorrection::astm:
      return "astm";
    case MembraneCorrection::iso:
      return "iso";
  }
  return {};
}

Consolidation Reduction::consolidation() const {
  Consolidation c =
      impl_->raw ? impl_->from_raw.consolidation() : impl_->from_columns.consolidation();
  c.b_value = impl_->b_value.value();
  return c;
}

std::vector<Check> Reduction::checks(bool back_volume_joined) const {
  std::vector<Check> checks;
  if (impl_->b_value.value()) checks.push_back(impl_->b_value.check());
  for (auto& check : impl_->closure.checks(impl_->from_raw.start_area(), back_volume_joined))
    checks.push_back(std::move(check));
  return checks;
}

std::vector<Warning> Reduction::warnings() const {
  const Impl& r = *impl_;
  auto all = r.raw ? r.from_raw.warnings() : r.from_columns.warnings();
  if (r.impossible == 0) return all;
  Warning warning = r.impossible_warning;
  warning.text += "; the state is unknown";
  if (r.impossible > 1) warning.text += fmt::format(" (and {} more)", r.impossible - 1);
  all.push_back(std::move(warning));
  return all;
}

}  // namespace triax::lab
