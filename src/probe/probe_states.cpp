#include "src/probe/probe_states.hpp"

#include <fmt/format.h>

#include <utility>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "sim/point/path_runner.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/progress_bar.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

template <class Space>
sim::Vector<Space> stress_of(double s1, double s2, double s3) {
  if constexpr (Space::kSize == 2)
    return sim::components(sim::AxisymmetricStress{s1, s3});
  else
    return (sim::Vector<Space>() << s1, s2, s3, 0, 0, 0).finished();
}

template <class Space>
sim::Vector<Space> triaxial_stress(double p, double q) {
  return stress_of<Space>(p + 2 * q / 3, p - q / 3, p - q / 3);
}

template <class Space>
std::vector<study::StateToProbe<Space>> given_states(const ProbeOptions& o,
                                                     const ProbeReport& report) {
  const sim::Law<Space>& law = *report.material.material.law<Space>();
  const double e = chosen_void_ratio(o.material, report.material);
  std::vector<study::StateToProbe<Space>> states;
  const auto add = [&](const sim::Vector<Space>& stress) {
    states.push_back({.state = law.start(stress, e),
                      .name = {},
                      .from_path = false,
                      .axial_strain = {},
                      .test = {}});
  };
  if (!o.stress_kPa.empty())
    add(1e3 * stress_of<Space>(o.stress_kPa.front(), o.stress_kPa[1], o.stress_kPa.back()));
  const double p = o.p_kPa.value_or(0);
  for (const double eta : o.eta) add(1e3 * triaxial_stress<Space>(p, eta * p));
  for (const double q : o.q_kPa) add(1e3 * triaxial_stress<Space>(p, q));
  return states;
}

template <class Space>
study::StateToProbe<Space> measured_state(const ProbeOptions& o, const ProbeReport& report,
                                          const db::Store& store, const std::string& name) {
  study::TestedState test =
      study::tested_state(store, name, o.at.empty() ? "collapse" : o.at, o.material.void_ratio);
  const auto& [axial, radial] = test.state.effective_stress;
  const sim::Law<Space>& law = *report.material.material.law<Space>();
  return {.state = law.start(stress_of<Space>(axial, radial, radial), test.state.void_ratio),
          .name = fmt::format("test {}, reading {}", test.id, test.state.reading),
          .from_path = false,
          .axial_strain = {},
          .test = std::move(test)};
}

template <class Space>
std::vector<study::StateToProbe<Space>> measured_states(const ProbeOptions& o,
                                                        const ProbeReport& report) {
  if (o.material.void_ratio) chosen_void_ratio(o.material, report.material);
  const db::Store store(o.db);
  std::vector<study::StateToProbe<Space>> states;
  for (const auto& name : o.tests) states.push_back(measured_state<Space>(o, report, store, name));
  return states;
}

/// The path in the space of the probes; axes 2 and 3 of a triaxial one stay equal as a tensor.
template <class Space>
sim::Path<Space> path_in(const lab::PathDescription& description) {
  if (const auto* path = std::get_if<sim::Path<Space>>(&description.path)) return *path;
  if constexpr (Space::kSize == 6) {
    const auto& triaxial = std::get<lab::TriaxialPath>(description.path);
    if (!triaxial.memory.empty())
      throw lab::BadInput(description.source, 0,
                          "its start has a memory in triaxial components, which a path in plane "
                          "strain cannot take: leave memory out");
    sim::Path<sim::Tensor> path{.stress = sim::as_tensor(triaxial.stress),
                                .void_ratio = triaxial.void_ratio,
                                .pore_pressure = triaxial.pore_pressure,
                                .memory = {},
                                .segments = {}};
    for (const auto& segment : triaxial.segments)
      path.segments.push_back(sim::as_tensor_segment(segment));
    return path;
  } else {
    throw lab::BadInput(description.source, 0,
                        "a path of the full tensor is no axisymmetric one: --plane plane-strain");
  }
}

template <class Space>
study::StateToProbe<Space> state_at(const sim::PathPoint<Space>& row) {
  study::StateToProbe<Space> what{.state = {row.stress, row.void_ratio, {}},
                                  .name = {},
                                  .from_path = true,
                                  .axial_strain = row.strain(0),
                                  .test = {}};
  what.state.memory.resize(static_cast<Eigen::Index>(row.memory.size()));
  for (std::size_t i = 0; i < row.memory.size(); ++i)
    what.state.memory(static_cast<Eigen::Index>(i)) = row.memory[i];
  what.name = fmt::format("ε₁ {} %", in_percent(what.axial_strain, 3));
  return what;
}

lab::PathDescription described(const ProbeOptions& o) {
  lab::PathDescription description = lab::load_path(o.path);
  if (!o.material.name.empty())
    description.material = chosen_material(o.material);
  else
    for (const auto& [key, value] : key_values(o.material.sets, "hardening_factor=2"))
      description.material = lab::with_parameter(description.material, key, value);
  if (o.material.void_ratio)
    lab::change_setting(description, "void_ratio", fmt::format("{}", *o.material.void_ratio));
  return description;
}

template <class Space>
std::vector<study::StateToProbe<Space>> driven_states(const ProbeOptions& o, ProbeReport& report) {
  lab::PathDescription description = described(o);
  const sim::Path<Space> path = path_in<Space>(description);
  description.path = path;
  lab::check_start(description);
  const sim::Law<Space>& law = *description.material.material.law<Space>();
  ProgressBar bar(description.name);
  const auto run = sim::run_path(
      law, path,
      {.tolerance = {.relative = description.tolerance}, .progress = [&bar](double share) {
         bar.show(share);
         return true;
       }});
  report.path = description.name;
  report.warnings.insert(report.warnings.end(), run.warnings.begin(), run.warnings.end());
  if (!run.message.empty())
    report.warnings.push_back(
        fmt::format("{} stopped early: {}", description.name, run.message));
  std::vector<study::StateToProbe<Space>> states;
  if (!o.every) {
    states.push_back(state_at(run.last));
    return states;
  }
  std::size_t refused = 0;
  const std::size_t every = static_cast<std::size_t>(*o.every), rows = run.rows.size();
  std::vector<study::PassedRow<Space>> passed;
  for (std::size_t i = 0; i < rows; ++i) {
    auto state = state_at(run.rows[i]);
    const bool wanted = i % every == 0 || i + 1 == rows;
    if (law.objection(state.state)) {
      if (wanted) ++refused;
      continue;
    }
    passed.push_back({state.state, run.rows[i].strain});
    if (!wanted) continue;
    state.passed = std::exchange(passed, {passed.back()});
    states.push_back(std::move(state));
  }
  if (refused > 0)
    report.warnings.push_back(
        fmt::format("{} rows of the path are left out: the law has no meaning at them", refused));
  return states;
}

}  // namespace

lab::MaterialSet material_of(const ProbeOptions& o) {
  return o.path.empty() ? chosen_material(o.material) : described(o).material;
}

std::vector<std::string> files_read(const ProbeOptions& o) {
  std::vector<std::string> files;
  if (!o.path.empty()) files = lab::load_path(o.path).files;
  if (!o.tests.empty()) files = database_files(o.db);
  if (!o.material.file.empty()) files.push_back(o.material.file);
  return files;
}

template <class Space>
std::vector<study::StateToProbe<Space>> states_to_probe(const ProbeOptions& o,
                                                        ProbeReport& report) {
  const sim::Material& material = report.material.material;
  if (material.law<Space>() == nullptr)
    throw lab::BadInput(
        fmt::format("{} cannot be probed in this plane: {}", report.material.name,
                    material.no_tensor.empty() ? "it has no form for it" : material.no_tensor));
  report.many = o.eta.size() > 1 || o.q_kPa.size() > 1 || o.tests.size() > 1 || o.every.has_value();
  if (!o.tests.empty()) return measured_states<Space>(o, report);
  return o.path.empty() ? given_states<Space>(o, report) : driven_states<Space>(o, report);
}

template std::vector<study::StateToProbe<sim::Axisymmetric>> states_to_probe(const ProbeOptions&,
                                                                             ProbeReport&);
template std::vector<study::StateToProbe<sim::Tensor>> states_to_probe(const ProbeOptions&,
                                                                       ProbeReport&);

}  // namespace triax::src
