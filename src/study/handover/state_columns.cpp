// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/state_columns.hpp"

#include "sim/mechanics/axisymmetric.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::study {
namespace {

double in_kilopascal(double pa) { return pa / 1e3; }

}  // namespace

const std::vector<StateColumn>& state_columns() {
  using S = const lab::State&;
  static const std::vector<StateColumn> columns{
      {"reading", "reading", [](S s) { return static_cast<double>(s.reading); }},
      {"time_s", "time_s", [](S s) { return s.time_s; }},
      {"stage", "stage", [](S s) { return static_cast<double>(s.stage); }},
      {"axial_strain", "axial_strain", [](S s) { return s.strain.axial; }},
      {"radial_strain", "", [](S s) { return s.strain.radial; }},
      {"volumetric_strain", "volumetric_strain", [](S s) { return s.volumetric_strain; }},
      {"shear_strain", "", [](S s) { return sim::shear_strain(s.strain); }},
      {"void_ratio", "void_ratio", [](S s) { return s.void_ratio; }},
      {"current_area_mm2", "current_area_mm2", [](S s) { return s.area_m2 * 1e6; }},
      {"effective_axial_stress_kPa", "effective_axial_stress_kPa",
       [](S s) { return in_kilopascal(s.effective_stress.axial); }},
      {"effective_radial_stress_kPa", "effective_radial_stress_kPa",
       [](S s) { return in_kilopascal(s.effective_stress.radial); }},
      {"pore_pressure_kPa", "pore_pressure_kPa",
       [](S s) { return in_kilopascal(s.pore_pressure); }},
      {"q_kPa", "deviator_stress_kPa", [](S s) { return in_kilopascal(s.q); }},
      {"p_eff_kPa", "mean_effective_stress_kPa", [](S s) { return in_kilopascal(s.p_eff); }},
      {"eta", "stress_ratio", [](S s) { return s.eta(); }},
      {"phi_mob_deg", "mobilised_friction_angle_deg",
       [](S s) { return sim::degrees(s.phi_mob_rad()); }}};
  return columns;
}

const std::vector<StateColumn>& columns_handed_over() {
  static const auto columns = [] {
    auto all = state_columns();
    std::erase_if(all, [](const StateColumn& column) { return column.heading.empty(); });
    return all;
  }();
  return columns;
}

std::vector<std::string> state_headings() {
  std::vector<std::string> out;
  for (const StateColumn& column : columns_handed_over()) out.push_back(column.heading);
  out.insert(out.end(), {"second_order_work_normalised", "second_order_work_error"});
  return out;
}

void for_each_state_row(const db::Store& store, std::int64_t id,
                        const std::function<void(const std::vector<double>&)>& use) {
  const auto points = store.second_order_work(id);
  auto point = points.begin();
  const auto& columns = columns_handed_over();
  std::vector<double> row(columns.size() + 2);
  store.for_each_scan(id, 1, [&](const lab::Reading&, const lab::State& state) {
    for (std::size_t i = 0; i < columns.size(); ++i) row[i] = columns[i].value(state);
    while (point != points.end() && point->reading < state.reading) ++point;
    const bool here = point != points.end() && point->reading == state.reading;
    row[columns.size()] = here ? point->work.normalised : lab::kMissing;
    row[columns.size() + 1] = here ? point->normalised_error : lab::kMissing;
    use(row);
  });
}

std::vector<std::string> reading_headings(const lab::RecordHeader& header) {
  std::vector<std::string> out;
  if (header.has_time) out.emplace_back("time_s");
  out.emplace_back("stage");
  for (const lab::Quantity quantity : header.columns) out.push_back(lab::heading(quantity));
  return out;
}

void for_each_reading_row(const db::Store& store, const db::StoredTest& test,
                          const std::function<void(const std::vector<double>&)>& use) {
  std::vector<sim::Unit> units;
  for (const lab::Quantity quantity : test.header.columns)
    units.push_back(*sim::find_unit(lab::info(quantity).unit));
  std::vector<double> row;
  store.for_each_scan(test.id, 1, [&](const lab::Reading& reading, const lab::State&) {
    row.clear();
    if (test.header.has_time) row.push_back(reading.time_s);
    row.push_back(reading.stage);
    for (std::size_t i = 0; i < units.size(); ++i)
      row.push_back(sim::to_field(reading[test.header.columns[i]], units[i]));
    use(row);
  });
}

}  // namespace triax::study
