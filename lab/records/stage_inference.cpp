// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_inference.hpp"

#include "lab/records/stage_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace triax::lab {
namespace {

using enum Quantity;

constexpr double kClosedFlow = 1e-4;  ///< of the specimen's volume: the valve is shut
constexpr double kPlainFlow = 1e-3;   ///< and open beyond any doubt

// What counts as movement for this specimen, SI.
struct Thresholds {
  double displacement = 0.5e-3;
  double force = 10;
  double volume = 20e-9;
  double pressure = 5e3;

  explicit Thresholds(const SpecimenInfo& specimen) {
    if (specimen.height_m) displacement = 0.005 * *specimen.height_m;
    if (!specimen.diameter_m) return;
    const double area = std::numbers::pi * *specimen.diameter_m * *specimen.diameter_m / 4;
    force = pressure * area;
    if (specimen.height_m) volume = kClosedFlow * area * *specimen.height_m;
  }
};

bool pressures_move(const StageSummary& stage, const Thresholds& least) {
  return std::ranges::any_of(std::array{cell_pressure, pore_pressure, back_pressure},
                             [&](Quantity q) { return stage[q].range() > least.pressure; });
}

/// A deviator load that is there when the stage begins and stays to its end, to kHeld of it, while
/// the effective stress moves.
bool holds_its_load(const StageSummary& stage, const Thresholds& least) {
  constexpr double kHeld = 0.1;
  const double load = std::abs(stage[axial_force].first);
  return load > least.force && stage[axial_force].range() < kHeld * load &&
         pressures_move(stage, least);
}

StageRole role_without_shear(const StageSummary& stage, const Thresholds& least,
                             Drainage drainage) {
  const double cell = stage[cell_pressure].change();
  const double pore = std::isnan(stage[pore_pressure].change()) ? stage[back_pressure].change()
                                                                : stage[pore_pressure].change();
  const bool cell_moves = std::abs(cell) > least.pressure;
  if (cell_moves && drainage == Drainage::closed)
    return pore / cell >= 0.5 ? StageRole::b_check : StageRole::saturation;
  if (cell_moves && cell > 0 && pore > least.pressure && std::abs(cell - pore) < 0.5 * cell)
    return StageRole::saturation;
  if (drainage == Drainage::open) return StageRole::consolidation;
  return StageRole::unknown;
}

bool moves(const StageSummary& stage, const Thresholds& least) {
  return pressures_move(stage, least) || stage[back_volume].range() > least.volume;
}

/// Where the cap hardly moves in any stage: a deviator load put on under a constant cell pressure,
/// and one that stays while the effective stress is taken away (CSD).
void find_shear_at_small_strain(std::vector<StageInfo>& stages,
                                const std::vector<const StageSummary*>& moved,
                                const Thresholds& least) {
  // What was sheared in earnest was consolidated before, be it under a deviator load.
  if (std::ranges::any_of(stages, [](const auto& s) { return s.role == StageRole::shear; })) return;
  // Force on the cap before it was loaded: as consolidation left it, or, in a file that confines
  // nothing, as the file begins. Before consolidation the piston may be docking.
  const bool confines = std::ranges::any_of(moved, [&](const StageSummary* stage) {
    return (*stage)[cell_pressure].change() > least.pressure;
  });
  double unloaded = confines || moved.empty() ? kMissing : (*moved[0])[axial_force].first;
  bool loaded = false;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    StageInfo& stage = stages[i];
    const StageSummary& now = *moved[i];
    const bool open_question = stage.role != StageRole::b_check;
    const bool confined = std::abs(now[cell_pressure].change()) <= least.pressure;
    const bool on_the_cap = std::abs(now[axial_force].last - unloaded) > least.force;
    const bool loads = confined && now[axial_force].excursion() > least.force;
    if (open_question && on_the_cap && (loads || (loaded && moves(now, least)))) {
      stage.role = StageRole::shear;
      if (holds_its_load(now, least)) stage.control = AxialControl::constant_q;
      loaded = true;
    }
    if (stage.role == StageRole::consolidation && !loaded) unloaded = now[axial_force].last;
  }
}

/// What one stage alone does not tell: what came before it, and what comes after.
void look_around(std::vector<StageInfo>& stages, const std::vector<const StageSummary*>& moved,
                 const Thresholds& least) {
  const auto checked = std::find_if(stages.rbegin(), stages.rend(), [](const StageInfo& stage) {
    return stage.role == StageRole::b_check;
  });
  if (checked != stages.rend())
    for (auto stage = checked.base(); stage != stages.end(); ++stage)
      if (stage->role == StageRole::saturation && stage->drainage == Drainage::open)
        stage->role = StageRole::consolidation;
  find_shear_at_small_strain(stages, moved, least);
  // What rests before the specimen is made ready is no shear, and strains do not count from there.
  const auto first_shear = std::ranges::find(stages, StageRole::shear, &StageInfo::role);
  bool made_ready = false;
  for (auto stage = std::make_reverse_iterator(first_shear); stage != stages.rend(); ++stage) {
    if (made_ready && stage->role == StageRole::unknown) stage->role = StageRole::hold;
    made_ready = made_ready || stage->role != StageRole::unknown;
  }
  bool sheared_later = false;
  for (std::size_t i = stages.size(); i-- > 0;) {
    StageInfo& stage = stages[i];
    if (stage.role != StageRole::shear) continue;
    const bool confined_more = (*moved[i])[cell_pressure].change() > least.pressure;
    if (sheared_later && confined_more && stage.drainage == Drainage::open)
      stage.role = StageRole::consolidation;
    else
      sheared_later = true;
  }
}

double first_known(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isnan(value)) return value;
  return kMissing;
}

double deviator_of(const Row& row) {
  const auto value = [&](Quantity q) { return row.si[index(q)]; };
  const double total_radial = first_known({value(radial_stress), value(cell_pressure)});
  return first_known({value(effective_axial_stress) - value(effective_radial_stress),
                      value(deviator_stress), value(axial_stress) - total_radial,
                      value(stress_ratio) * value(mean_effective_stress)});
}

double effective_radial_of(const Row& row, double q) {
  const auto value = [&](Quantity quantity) { return row.si[index(quantity)]; };
  const double total_radial = first_known({value(radial_stress), value(cell_pressure)});
  return first_known({value(effective_radial_stress), value(effective_axial_stress) - q,
                      value(mean_effective_stress) - q / 3, total_radial - value(pore_pressure)});
}

}  // namespace

void LineFit::add(double x, double y) {
  if (std::isnan(x) || std::isnan(y)) return;
  n += 1;
  const double dx = x - mean_x;
  const double dy = y - mean_y;
  mean_x += dx / n;
  mean_y += dy / n;
  sxx += dx * (x - mean_x);
  sxy += dx * (y - mean_y);
  syy += dy * (y - mean_y);
}

double LineFit::residual() const {
  return std::sqrt(std::max(0.0, syy - sxy * sxy / sxx) / std::max(n, 1.0));
}

double LineFit::r_squared() const { return sxx > 0 && syy > 0 ? sxy * sxy / (sxx * syy) : 0.0; }

void StageSummary::Span::add(double value) {
  if (std::isnan(value)) return;
  if (std::isnan(first)) first = low = high = value;
  last = value;
  low = std::min(low, value);
  high = std::max(high, value);
}

double StageSummary::Span::excursion() const { return std::max(high - first, first - low); }

void StageSummary::add(const Row& row) {
  if (rows++ == 0) first_line = row.line;
  for (std::size_t i = 0; i < spans.size(); ++i) spans[i].add(row.si[i]);
  const double q = deviator_of(row), radial = effective_radial_of(row, q);
  deviator.add(q);
  effective_radial.add(radial);
  total_radial.add(radial + row.si[index(pore_pressure)]);
  const double time = std::isnan(row.stage_time_s) ? row.time_s : row.stage_time_s;
  displacement_in_time.add(time, row.si[index(axial_displacement)]);
  force_in_time.add(time, row.si[index(axial_force)]);
  displacement_in_strain.add(row.si[index(axial_strain)], row.si[index(axial_displacement)]);
}

std::vector<StageSummary> summarise_stages(
    TableReader& reader, const std::function<int(double value, std::int64_t line)>& number_of,
    const std::optional<double>& held_cell_pressure, std::span<const std::int64_t> stage_lines,
    const std::function<void(const Row&)>& each) {
  constexpr std::size_t kMostStages = 10'000;
  std::vector<StageSummary> stages;
  Row row;
  while (reader.next(row)) {
    if (held_cell_pressure) row.si[index(cell_pressure)] = *held_cell_pressure;
    int number = stages.empty() ? 1 : stages.back().number;
    if (!std::isnan(row.stage))
      number = number_of(row.stage, row.line);
    else if (!stage_lines.empty())
      number = stage_at_line(stage_lines, row.line);
    if (stages.empty() || stages.back().number != number) {
      if (stages.size() >= kMostStages) break;
      stages.emplace_back().number = number;
    }
    stages.back().add(row);
    if (each) each(row);
  }
  return stages;
}

int stage_at_line(std::span<const std::int64_t> stage_lines, std::int64_t line) {
  const auto next = std::ranges::upper_bound(stage_lines, line);
  return std::max(1, static_cast<int>(next - stage_lines.begin()));
}

std::vector<StageInfo> infer_stages(const std::vector<StageSummary>& summaries,
                                    const SpecimenInfo& specimen) {
  const Thresholds least(specimen);
  std::vector<StageInfo> stages;
  std::vector<const StageSummary*> moved;
  std::set<int> known;
  for (const StageSummary& summary : summaries) {
    if (!known.insert(summary.number).second) continue;
    StageInfo stage;
    stage.number = summary.number;
    const double volume = summary[back_volume].range();
    if (!std::isnan(volume))
      stage.drainage = volume <= least.volume ? Drainage::closed : Drainage::open;
    else if (!std::isnan(summary[volumetric_strain].range()))
      stage.drainage = find_drainage(summary, specimen).drainage;
    const bool sheared = summary[axial_displacement].range() > least.displacement &&
                         summary[axial_force].excursion() > least.force;
    if (sheared) {
      constexpr double kSteady = 0.999;
      stage.role = StageRole::shear;
      if (summary.displacement_in_time.r_squared() > kSteady)
        stage.control = AxialControl::displacement;
      else if (summary.force_in_time.r_squared() > kSteady)
        stage.control = AxialControl::load;
      else if (holds_its_load(summary, least))
        stage.control = AxialControl::constant_q;
    } else {
      stage.role = role_without_shear(summary, least, stage.drainage);
    }
    stages.push_back(stage);
    moved.push_back(&summary);
  }
  look_around(stages, moved, least);
  return stages;
}

std::vector<Guess::Said> other_answers(const StageSummary& moved, const StageInfo& inferred,
                                       const SpecimenInfo& specimen) {
  const Thresholds least(specimen);
  std::vector<Guess::Said> all;
  const auto say = [&](const char* key, const char* value) {
    all.push_back({"stages." + std::to_string(inferred.number) + "." + key, value});
  };
  const bool sheared = inferred.role == StageRole::shear;
  const bool loaded = moved[axial_force].excursion() > least.force;
  const bool loaded_at_all = loaded || std::abs(moved[axial_force].first) > least.force;
  if (sheared && inferred.drainage == Drainage::open &&
      moved[back_volume].range() <= kPlainFlow / kClosedFlow * least.volume)
    say("drainage", "closed");
  if (sheared && inferred.drainage == Drainage::closed &&
      moved[pore_pressure].range() <= least.pressure)
    say("drainage", "open");
  if (sheared && inferred.drainage == Drainage::open &&
      moved[axial_displacement].range() <= least.displacement)
    say("role", "consolidation");
  if (inferred.role == StageRole::consolidation && loaded) say("role", "shear");
  // Nobody says what moved the axis, and under it a pressure moved: the load may have been held.
  if (sheared && inferred.control == AxialControl::unknown && inferred.drainage == Drainage::open &&
      loaded_at_all && pressures_move(moved, least))
    say("control", "constant_q");
  return all;
}

std::optional<double> typed_height(const StageSummary& shear, double our_height_m) {
  constexpr double kLeastStrain = 0.01;
  constexpr double kFewestRows = 10;
  const LineFit& fit = shear.displacement_in_strain;
  if (fit.n < kFewestRows || !(shear[axial_strain].range() > kLeastStrain)) return std::nullopt;
  const double height = fit.slope();
  const double rounding = 2e-4 * shear[axial_displacement].range();
  if (!(height > 0) || !(fit.residual() <= rounding)) return std::nullopt;
  if (std::abs(height - our_height_m) <= 5e-4 * our_height_m) return std::nullopt;
  const double step = std::pow(10, std::floor(std::log10(height)) - 4);
  return std::round(height / step) * step;
}

}  // namespace triax::lab
