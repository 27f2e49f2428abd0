// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/states_to_probe.hpp"

#include <fmt/format.h>

#include <utility>

#include "lab/base/bad_input.hpp"
#include "sim/point/path_runner.hpp"
#include "src/study/number_text.hpp"

namespace triax::study {
namespace {

template <class Space>
sim::Vector<Space> stress_of(double s1, double s2, double s3) {
  if constexpr (Space::kSize == 2)
    return sim::components(sim::AxisymmetricStress{s1, s3});
  else
    return (sim::Vector<Space>() << s1, s2, s3, 0, 0, 0).finished();
}

template <class Space>
StatesToProbe<Space> of(const lab::MaterialSet& material, const GivenStates& wanted,
                        const Progress&) {
  const sim::Law<Space>& law = *material.material.law<Space>();
  StatesToProbe<Space> found{.states = {}, .many = wanted.stress_kPa.size() > 1};
  for (const auto& s : wanted.stress_kPa)
    found.states.push_back(
        {.state = law.start(1e3 * stress_of<Space>(s(0), s(1), s(2)), wanted.void_ratio),
         .name = {},
         .from_path = false,
         .axial_strain = {},
         .test = {}});
  return found;
}

template <class Space>
StateToProbe<Space> measured_state(const sim::Law<Space>& law, TestedState test) {
  const auto& [axial, radial] = test.state.effective_stress;
  return {.state = law.start(stress_of<Space>(axial, radial, radial), test.state.void_ratio),
          .name = fmt::format("test {}, reading {}", test.id, test.state.reading),
          .from_path = false,
          .axial_strain = {},
          .test = std::move(test)};
}

template <class Space>
StatesToProbe<Space> of(const lab::MaterialSet& material, const MeasuredStates& wanted,
                        const Progress&) {
  StatesToProbe<Space> found{.states = {}, .many = wanted.tests.size() > 1};
  for (auto& test : tested_states(wanted.db, wanted.tests, wanted.at, wanted.void_ratio))
    found.states.push_back(measured_state(*material.material.law<Space>(), std::move(test)));
  return found;
}

/// The path in the space of the probes; axes 2 and 3 of a triaxial one stay equal as a tensor.
template <class Space>
sim::Path<Space> path_in(const lab::PathDescription& description) {
  if (const auto* path = std::get_if<sim::Path<Space>>(&description.path)) return *path;
  if constexpr (Space::kSize == 6) {
    const auto& triaxial = std::get<lab::TriaxialPath>(description.path);
    if (!triaxial.memory.empty())
      throw lab::BadInput(description.source, 0,
                          "its start has a memory in triaxial components, which is not possible in "
                          "plane strain; leave memory out");
    sim::Path<sim::Tensor> path{.stress = sim::as_tensor(triaxial.stress),
                                .void_ratio = triaxial.void_ratio,
                                .pore_pressure = triaxial.pore_pressure,
                                .memory = {},
                                .segments = {}};
    for (const auto& segment : triaxial.segments)
      path.segments.push_back(sim::as_tensor_segment(segment));
    return path;
  } else {
    throw lab::BadInput(
        description.source, 0,
        "the path uses the full tensor and is not axisymmetric; probe it in plane strain");
  }
}

template <class Space>
StateToProbe<Space> state_at(const sim::PathPoint<Space>& row) {
  StateToProbe<Space> what{.state = {row.stress, row.void_ratio, {}},
                           .name = {},
                           .from_path = true,
                           .axial_strain = row.strain(0),
                           .test = {}};
  what.state.memory.resize(static_cast<Eigen::Index>(row.memory.size()));
  for (std::size_t i = 0; i < row.memory.size(); ++i)
    what.state.memory(static_cast<Eigen::Index>(i)) = row.memory[i];
  what.name = fmt::format("ε₁ {} %", number_text(*what.axial_strain * 100, 3));
  return what;
}

/// Every so many rows and the last; rows at which the law has no meaning are left out.
template <class Space>
void put_rows(const sim::Law<Space>& law, const std::vector<sim::PathPoint<Space>>& rows,
              std::size_t every, StatesToProbe<Space>& found) {
  std::size_t refused = 0;
  std::vector<PassedRow<Space>> passed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto state = state_at(rows[i]);
    const bool wanted = i % every == 0 || i + 1 == rows.size();
    if (law.objection(state.state)) {
      if (wanted) ++refused;
      continue;
    }
    passed.push_back({state.state, rows[i].strain});
    if (!wanted) continue;
    state.passed = std::exchange(passed, {passed.back()});
    found.states.push_back(std::move(state));
  }
  if (refused > 0)
    found.warnings.push_back(
        fmt::format("{} rows of the path are ignored: the law is not defined there", refused));
}

template <class Space>
StatesToProbe<Space> of(const lab::MaterialSet&, const StatesOfPath& wanted,
                        const Progress& progress) {
  lab::PathDescription description = wanted.path;
  const sim::Path<Space> path = path_in<Space>(description);
  description.path = path;
  lab::check_start(description);
  const sim::Law<Space>& law = *description.material.material.law<Space>();
  const auto run = sim::run_path(
      law, path, {.tolerance = {.relative = description.tolerance}, .progress = [&](double share) {
                    show(progress, description.name, share);
                    return true;
                  }});
  StatesToProbe<Space> found{.states = {},
                             .many = wanted.every.has_value(),
                             .path = description.name,
                             .warnings = run.warnings};
  if (!run.message.empty())
    found.warnings.push_back(fmt::format("{} stopped early: {}", description.name, run.message));
  if (wanted.every)
    put_rows(law, run.rows, static_cast<std::size_t>(*wanted.every), found);
  else
    found.states.push_back(state_at(run.last));
  return found;
}

}  // namespace

Eigen::Vector3d triaxial_stress(double p, double q) {
  return {p + 2 * q / 3, p - q / 3, p - q / 3};
}

template <class Space>
StatesToProbe<Space> states_to_probe(const lab::MaterialSet& material, const StatesWanted& wanted,
                                     const Progress& progress) {
  const sim::Material& laws = material.material;
  if (laws.law<Space>() == nullptr)
    throw lab::BadInput(
        fmt::format("{} cannot be probed in this plane: {}", material.name,
                    laws.no_tensor.empty() ? "the law is not formulated for it" : laws.no_tensor));
  return std::visit([&](const auto& states) { return of<Space>(material, states, progress); },
                    wanted);
}

template StatesToProbe<sim::Axisymmetric> states_to_probe(const lab::MaterialSet&,
                                                          const StatesWanted&, const Progress&);
template StatesToProbe<sim::Tensor> states_to_probe(const lab::MaterialSet&, const StatesWanted&,
                                                    const Progress&);

}  // namespace triax::study
