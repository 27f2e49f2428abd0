// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "lab/results/reading.hpp"
#include "src/probe/probe_json.hpp"
#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"
#include "src/python/documents.hpp"
#include "src/python/material.hpp"
#include "src/python/ranges.hpp"
#include "src/python/signals.hpp"
#include "src/study/probe/run_probe.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using File = std::optional<std::filesystem::path>;

struct ProbeRun {
  explicit ProbeRun(study::ProbeResult of) : result(std::move(of)) {}
  study::ProbeResult result;
};
/// A state of it.
struct Probed {
  std::shared_ptr<const ProbeRun> of;
  std::size_t place = 0;
  const study::ProbedState* operator->() const { return &of->result.states[place]; }
};

study::Probing probing_of(const std::string& plane, const std::string& kind,
                          std::optional<double> norm, int directions, bool finite) {
  if (plane != "axisymmetric" && plane != "plane-strain")
    throw lab::BadInput("plane '" + plane +
                        "' is not valid; must be one of: axisymmetric, plane-strain");
  if (kind != "stress" && kind != "strain")
    throw lab::BadInput("kind '" + kind + "' is not valid; must be one of: stress, strain");
  must_lie("directions", directions, 8, 36000);
  const bool stress = kind == "stress";
  const double given = norm.value_or(stress ? 1 : 1e-5);
  stress ? must_lie("norm", given, 1e-6, 1e4) : must_lie("norm", given, 1e-10, 0.1);
  study::Probing probing;
  probing.kind = stress ? sim::ProbeKind::stress : sim::ProbeKind::strain;
  probing.plane =
      plane == "plane-strain" ? sim::ProbePlane::plane_strain : sim::ProbePlane::axisymmetric;
  probing.norm = stress ? 1e3 * given : given;
  probing.directions = directions;
  probing.finite = finite;
  return probing;
}

std::vector<double> numbers(const Array& given) {
  return {given.data(), given.data() + given.size()};
}

study::GivenStates given_states(double p_kPa, const std::optional<Array>& q,
                                const std::optional<Array>& eta, std::optional<double> void_ratio) {
  must_lie("p_kPa", p_kPa, 1e-3, 1e5);
  if (q.has_value() == eta.has_value())
    throw lab::BadInput("p_kPa needs either q_kPa or eta; eta=0 is the isotropic state");
  if (!void_ratio) throw lab::BadInput("missing void_ratio of the states");
  study::GivenStates states{.stress_kPa = {}, .void_ratio = checked_void_ratio(*void_ratio)};
  for (const double one : numbers(q ? *q : *eta)) {
    q ? must_lie("q_kPa", one, -1e5, 1e5) : must_lie("eta", one, -3, 3);
    states.stress_kPa.push_back(study::triaxial_stress(p_kPa, q ? one : one * p_kPa));
  }
  return states;
}

std::shared_ptr<ProbeRun> probe(const py::object& material, std::optional<double> p_kPa,
                                const std::optional<Array>& q_kPa, const std::optional<Array>& eta,
                                std::optional<double> void_ratio,
                                const std::vector<std::string>& tests,
                                const std::filesystem::path& db, const std::string& at,
                                const File& path, std::optional<int> every,
                                const std::string& plane, const std::string& kind,
                                std::optional<double> norm, int directions, bool finite) {
  if (p_kPa.has_value() + !tests.empty() + path.has_value() != 1)
    throw lab::BadInput("give one of p_kPa (with q_kPa or eta), tests and path");
  if (void_ratio) checked_void_ratio(*void_ratio);
  if (every && *every < 1)
    throw lab::BadInput(
        fmt::format("every {}: out of range; expected a number of rows, 1 or more", *every));
  study::ProbeRequest request{.probing = probing_of(plane, kind, norm, directions, finite)};
  if (path) {
    lab::PathDescription described = lab::load_path(path->string());
    if (!material.is_none()) described.material = material_of(material);
    if (void_ratio) lab::change_setting(described, "void_ratio", fmt::format("{}", *void_ratio));
    request.material = described.material;
    request.states = study::StatesOfPath{std::move(described), every};
  } else {
    if (material.is_none())
      throw lab::BadInput(
          "missing material, as in 'inl2/S28-general'; triax.materials() lists the sets");
    request.material = material_of(material);
    if (p_kPa)
      request.states = given_states(*p_kPa, q_kPa, eta, void_ratio);
    else
      request.states = study::MeasuredStates{
          .db = db.string(), .tests = tests, .at = at, .void_ratio = void_ratio};
  }
  request.material.material = lab::made_anew(request.material);
  const py::gil_scoped_release free;
  Signals signals;
  return std::make_shared<ProbeRun>(
      study::run_probe(request, [&](const std::string&, double) { signals.look(); }));
}

std::vector<Probed> states_of(const std::shared_ptr<ProbeRun>& run) {
  std::vector<Probed> states;
  for (std::size_t i = 0; i < run->result.states.size(); ++i) states.push_back({run, i});
  return states;
}

/// The probes of a circle, a row each.
std::shared_ptr<Columns> probes_of(const Probed& state) {
  auto table = std::make_shared<Columns>();
  const auto add = [&](const char* name, auto of) {
    auto& values = table->add(name);
    for (const sim::Probe& p : state->circle.probes) values.push_back(of(p));
  };
  const double root = state.of->result.probing.axisymmetric() ? std::numbers::sqrt2 : 1;
  const auto known = [](const sim::Probe& p, double value) {
    return p.answered ? value : lab::kMissing;
  };
  add("alpha_deg", [](const sim::Probe& p) { return sim::degrees(p.angle); });
  add("w2_normalised", [&](const sim::Probe& p) { return known(p, p.normalised); });
  add("w2_Pa", [&](const sim::Probe& p) { return known(p, p.second_order_work); });
  add("axial_stress_kPa", [&](const sim::Probe& p) { return known(p, p.stress.y() / 1e3); });
  add("radial_stress_kPa",
      [&](const sim::Probe& p) { return known(p, p.stress.x() / root / 1e3); });
  add("axial_strain", [&](const sim::Probe& p) { return known(p, p.strain.y()); });
  add("radial_strain", [&](const sim::Probe& p) { return known(p, p.strain.x() / root); });
  return table;
}

py::list cones_of(const Probed& state) {
  py::list cones;
  for (const sim::Cone& cone : state->circle.cones)
    cones.append(py::make_tuple(sim::degrees(cone.from), sim::degrees(cone.to)));
  return cones;
}

void bind_probed(py::module_& module) {
  py::class_<Probed>(module, "ProbedState",
                     "State of a law with probes in every direction of a plane.")
      .def_property_readonly(
          "p_kPa", [](const Probed& s) { return s->p / 1e3; }, "Mean effective stress, kPa.")
      .def_property_readonly(
          "q_kPa", [](const Probed& s) { return s->q / 1e3; }, "Deviator stress, kPa.")
      .def_property_readonly(
          "eta", [](const Probed& s) { return s->eta(); }, "Stress ratio q/p'.")
      .def_property_readonly(
          "void_ratio", [](const Probed& s) { return s->void_ratio; }, "Void ratio of the state.")
      .def_property_readonly(
          "unstable", [](const Probed& s) { return s->circle.unstable(); },
          "True if the second-order work is negative in at least one direction.")
      .def_property_readonly("cones_deg", &cones_of,
                             "Cones of unstable directions, (from, to) in degrees from the axis of "
                             "sqrt2 dsigma3 towards the axis of dsigma1.")
      .def_property_readonly(
          "least", [](const Probed& s) { return s->circle.least.normalised; },
          "Least normalised second-order work of all directions.")
      .def_property_readonly(
          "least_deg", [](const Probed& s) { return sim::degrees(s->circle.least.angle); },
          "Direction of the least normalised second-order work, degrees.")
      .def_property_readonly(
          "warnings", [](const Probed& s) { return s->all_warnings(); },
          "Warnings that a reader of the result must know.")
      .def_property_readonly("probes", &probes_of, "All probes, one row per direction.");
}

}  // namespace

void bind_probe(py::module_& module) {
  bind_probed(module);
  py::class_<ProbeRun, std::shared_ptr<ProbeRun>>(module, "ProbeRun",
                                                  "Directional probes of states of a law.")
      .def_property_readonly("states", &states_of, "States that were probed.")
      .def_property_readonly(
          "report", [](const ProbeRun& r) { return document(src::probe_json(r.result)); },
          "Document of triax probe --json, with controllability.")
      .def("__repr__", [](const ProbeRun& r) {
        return fmt::format("<triax.ProbeRun: {} states of {}>", r.result.states.size(),
                           r.result.material.name);
      });
  module.def(
      "probe", &probe, py::arg("material") = py::none(), py::kw_only(),
      py::arg("p_kPa") = py::none(), py::arg("q_kPa") = py::none(), py::arg("eta") = py::none(),
      py::arg("void_ratio") = py::none(), py::arg("tests") = std::vector<std::string>(),
      py::arg("db") = "triax.db", py::arg("at") = "collapse", py::arg("path") = py::none(),
      py::arg("every") = py::none(), py::arg("plane") = "axisymmetric", py::arg("kind") = "stress",
      py::arg("norm") = py::none(), py::arg("directions") = 36, py::arg("finite") = false,
      "Compute the second-order work of states in every direction of a plane (as triax probe).\n"
      "Give the states by p_kPa with q_kPa or eta (one or many), by `tests` of a database, or by "
      "`path`.\n"
      "`path` is a path file. Its states have the memory that the path produces.\n"
      "`norm` of the increments is in kPa for stress probes, a strain for strain probes.");
}

}  // namespace triax::python
