// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/states_sheet.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/mechanics/units.hpp"
#include "src/study/handover/state_columns.hpp"

namespace triax::src {
namespace {

std::variant<RawTrail, ReducedTrail> trail_of(const db::StoredTest& test,
                                              const SpecimenTerms& specimen,
                                              std::size_t first_reference_row,
                                              std::size_t first_reading_row) {
  using Trail = std::variant<RawTrail, ReducedTrail>;
  const ReadingTerms readings(test.header, first_reading_row - kFirstRow);
  if (!test.header.is_raw())
    return Trail(std::in_place_type<ReducedTrail>, test.header, specimen, readings);
  return Trail(std::in_place_type<RawTrail>, test.header, test.summary.membrane_correction,
               specimen, first_reference_row, study::columns_handed_over().size(), readings);
}

/// In the order of StateCell; "_per" stands for the unit of progress.
constexpr std::array<const char*, kStateCells> kHeadings = {"second_order_work_normalised",
                                                            "second_order_work_error",
                                                            "window_readings",
                                                            "shortening_m",
                                                            "outflow_m3",
                                                            "current_area_m2",
                                                            "deviator_stress_as_measured_Pa",
                                                            "membrane_axial_Pa",
                                                            "membrane_radial_Pa",
                                                            "pore_pressure_Pa",
                                                            "effective_axial_stress_Pa",
                                                            "effective_radial_stress_Pa",
                                                            "deviator_stress_Pa",
                                                            "mean_effective_stress_Pa",
                                                            "volumetric_strain_of_specimen",
                                                            "axial_strain_path",
                                                            "progress_of_a_block",
                                                            "d_deviator_stress_Pa_per",
                                                            "d_mean_effective_stress_Pa_per",
                                                            "d_axial_strain_per",
                                                            "d_volumetric_strain_per",
                                                            "d_effective_axial_stress_Pa_per",
                                                            "d_effective_radial_stress_Pa_per",
                                                            "d_radial_strain_per",
                                                            "second_order_work_Pa_per"};

Term in_kilopascals(const Term& pa) { return over(pa, constant(1000)); }

Term friction_angle(const Term& eta) {
  const Term part = over(times(constant(eta.value >= 0 ? 3 : -3), eta), sum(constant(6), eta));
  // Where σ₃′ vanishes it is 1, and must not become more by a last bit of another computation.
  const Term sine{part.value, "MIN(1," + part.text + ')', false};
  const Term angle = function("ASIN", sine, [](double x) { return std::asin(x); });
  return over(times(angle, constant(180)), {std::numbers::pi, "PI()", false});
}

}  // namespace

std::size_t StatesSheet::column(StateCell place) {
  return study::columns_handed_over().size() + static_cast<std::size_t>(place);
}

StatesSheet::StatesSheet(Sheet& sheet, const db::StoredTest& test, const SpecimenTerms& specimen,
                         std::size_t first_reference_row, std::size_t first_reading_row,
                         const WorkWindows& windows, std::vector<lab::SecondOrderWorkPoint> points)
    : sheet_(sheet),
      header_(test.header),
      first_reading_row_(first_reading_row),
      windows_(windows),
      points_(std::move(points)),
      trail_(trail_of(test, specimen, first_reference_row, first_reading_row)),
      work_(windows, test.header, study::columns_handed_over().size()),
      volume_(test.header.specimen) {
  const auto& columns = study::columns_handed_over();
  for (std::size_t i = 0; i < columns.size(); ++i)
    sheet.text(kHeadingRow, i, columns[i].heading, Look::heading);
  for (std::size_t i = 0; i < kStateCells; ++i) {
    const auto place = static_cast<StateCell>(i);
    if (place == StateCell::axial_strain_path && header_.has_time) continue;
    std::string heading = kHeadings[i];
    if (place == StateCell::work)
      heading += header_.has_time ? "_s2" : "_path2";
    else if (heading.ends_with("_per"))
      heading += header_.has_time ? "_s" : "_path";
    sheet.text(kHeadingRow, column(place), heading, Look::heading);
  }
  sheet.widths(0, column(StateCell::work), 16);
  sheet.freeze_above(kFirstRow);
}

const std::vector<ReferenceRow>& StatesSheet::references() const {
  static const std::vector<ReferenceRow> none;
  const auto* const raw = std::get_if<RawTrail>(&trail_);
  return raw != nullptr ? raw->references() : none;
}

void StatesSheet::keep_states(const ReducedTerms& s, const lab::Reading& reading,
                              const lab::State& state, StateTerms& row) const {
  const std::size_t reading_row = row.row() - kFirstRow + first_reading_row_;
  row.keep_in(0, {static_cast<double>(state.reading), "", false});
  std::size_t column = 0;
  if (header_.has_time)
    row.keep_in(1, cell(on_sheet(kReadingsSheet, column++, reading_row), reading.time_s));
  row.keep_in(2, cell(on_sheet(kReadingsSheet, column, reading_row), reading.stage));
  row.keep_in(5, s.void_ratio);
  row.keep_in(6, times(s.area_m2, constant(1e6)));
  row.keep_in(7, in_kilopascals(s.axial_pa));
  row.keep_in(8, in_kilopascals(s.radial_pa));
  row.keep_in(9, in_kilopascals(s.pore_pressure_pa));
  row.keep_in(10, in_kilopascals(s.q_pa));
  row.keep_in(11, in_kilopascals(s.p_eff_pa));
  const Term eta = row.keep_in(12, over(s.q_pa, s.p_eff_pa));
  row.keep_in(13, friction_angle(eta));
}

/// The way along ε₁, as lab/measured/path_sampler adds it up.
void StatesSheet::keep_path(const lab::State& state, StateTerms& row) {
  if (header_.has_time || !lab::complete(state) || !lab::is_watched(header_.stage(state.stage)))
    return;
  const Term strain = cell(address(kAxialStrainColumn, row.row() + 1), state.strain.axial);
  if (!last_strain_.known())
    path_ = constant(0);
  else
    path_ = sum(path_, function("ABS", difference(strain, last_strain_),
                                [](double x) { return std::fabs(x); }));
  path_ = row.keep(StateCell::axial_strain_path, path_);
  last_strain_ = strain;
}

/// With what the pore fluid is compressed by, as lab/measured/specimen_volume adds it.
void StatesSheet::keep_volume(const lab::State& state, StateTerms& row) {
  if (!lab::complete(state)) return;
  const lab::StageInfo* stage = header_.stage(state.stage);
  volume_.with_fluid(state, stage);
  if (!lab::is_watched(stage)) return;
  Term strain = cell(address(kVolumetricStrainColumn, row.row() + 1), state.volumetric_strain);
  if (const auto& c = volume_.compliance(); c && std::isfinite(state.pore_pressure)) {
    const Term u =
        cell(address(column(StateCell::pore_pressure_pa), row.row() + 1), state.pore_pressure);
    const Term air = over(constant(c->air), sum(u, constant(lab::FluidCompliance::kAtmosphere_pa)));
    const Term fluid = difference(times(constant(c->rigid), u), air);
    strain = sum(strain, difference(fluid, constant(volume_.strain_at_start())));
  }
  row.keep(StateCell::specimen_volumetric_strain, strain);
}

double StatesSheet::stored_value(std::size_t at, const lab::State& state) const {
  const auto& columns = study::columns_handed_over();
  if (at < columns.size()) return columns[at].value(state);
  switch (static_cast<StateCell>(at - columns.size())) {
    case StateCell::work_normalised:
      return point_ != nullptr ? point_->work.normalised : lab::kMissing;
    case StateCell::work:
      return point_ != nullptr ? point_->work.small_strain : lab::kMissing;
    case StateCell::area_m2:
      return state.area_m2;
    case StateCell::pore_pressure_pa:
      return state.pore_pressure;
    case StateCell::axial_pa:
      return state.effective_stress.axial;
    case StateCell::radial_pa:
      return state.effective_stress.radial;
    case StateCell::q_pa:
      return state.q;
    case StateCell::p_eff_pa:
      return state.p_eff;
    default:
      return lab::kMissing;
  }
}

void StatesSheet::write(std::size_t row, const lab::Reading& reading, const lab::State& state) {
  StateTerms terms(study::columns_handed_over().size(), row);
  keep_states(std::visit([&](auto& trail) { return trail.reduce(reading, terms); }, trail_),
              reading, state, terms);
  keep_path(state, terms);
  keep_volume(state, terms);
  while (next_point_ < points_.size() && points_[next_point_].reading < state.reading)
    ++next_point_;
  const bool here = next_point_ < points_.size() && points_[next_point_].reading == state.reading;
  point_ = here ? &points_[next_point_] : nullptr;
  const auto& windows = windows_.windows();
  while (next_window_ < windows.size() && windows[next_window_].reading < state.reading)
    ++next_window_;
  if (here && next_window_ < windows.size() && windows[next_window_].reading == state.reading)
    work_.keep(windows[next_window_], terms);
  bool told = false;
  for (const auto& [at, term] : terms.cells()) {
    const double stored = stored_value(at, state);
    told = told || at == column(StateCell::work_normalised);
    if (at >= column(StateCell::shortening_m) && std::isnan(stored))
      sheet_.formula(row, at, term);
    else if (term.text.empty() && at == 0)
      sheet_.number(row, at, stored);
    else
      sheet_.formula(row, at, term, stored);
  }
  if (!here) return;
  if (!told)
    sheet_.formula(row, column(StateCell::work_normalised), Term{}, point_->work.normalised);
  sheet_.number(row, column(StateCell::work_error), point_->normalised_error);
  sheet_.number(row, column(StateCell::window_readings),
                static_cast<double>(point_->window_readings));
}

}  // namespace triax::src
