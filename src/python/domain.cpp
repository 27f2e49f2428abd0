// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/results/reading.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"
#include "src/python/documents.hpp"
#include "src/python/material.hpp"
#include "src/python/signals.hpp"
#include "src/study/domain/domain_run.hpp"
#include "src/study/domain/usual_grid.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

/// The arrays of a domain: columns × rows.
struct Domain {
  explicit Domain(study::ReportedDomain of) : domain(std::move(of)) {
    for (const auto& column : domain.columns) {
      p_kPa.push_back(column.p_eff_kPa);
      for (const auto& state : column.states) {
        if (p_kPa.size() == 1) q_kPa.push_back(state.q_kPa);
        const auto at = std::ranges::find(sim::kDomainStateKinds, state.kind);
        kind.push_back(static_cast<std::uint8_t>(at - sim::kDomainStateKinds.begin()));
        least_work.push_back(state.least_work.value_or(lab::kMissing));
      }
    }
  }
  study::ReportedDomain domain;
  std::vector<double> p_kPa, q_kPa, least_work;
  std::vector<std::uint8_t> kind;
};

using Line = std::optional<std::tuple<double, double, int>>;

study::GridLine line_of(const Line& given, const study::GridLine& usual) {
  if (!given) return usual;
  study::GridLine line = usual;
  std::tie(line.from, line.to, line.count) = *given;
  return line;
}

std::vector<std::string> criterion_names() {
  std::vector<std::string> names;
  for (const auto& kind : sim::domain_criterion_kinds()) names.emplace_back(kind.name);
  return names;
}

void check_names(const std::string& plane, const std::vector<std::string>& criteria) {
  if (plane != "axisymmetric" && plane != "plane-strain")
    throw lab::BadInput("plane '" + plane +
                        "' is not valid; must be one of: axisymmetric, plane-strain");
  for (const std::string& asked : criteria)
    if (std::ranges::find(sim::domain_criterion_kinds(), asked, &sim::DomainCriterionKind::name) ==
        sim::domain_criterion_kinds().end())
      throw lab::BadInput("criterion " + lab::invalid_value(asked, criterion_names()));
}

std::shared_ptr<Domain> domain(const py::object& material, double void_ratio, const Line& p_kPa,
                               const Line& q_kPa, const std::string& plane, int directions,
                               const std::vector<std::string>& criteria, int threads) {
  const lab::MaterialSet set = material_of(material);
  check_names(plane, criteria);
  const auto p = line_of(p_kPa, study::usual_p(set));
  const auto grid = study::asked_grid(set,
                                      {.p = p,
                                       .q = line_of(q_kPa, study::usual_q(set, p)),
                                       .void_ratio = checked_void_ratio(void_ratio),
                                       .plane = plane,
                                       .directions = directions,
                                       .criteria = criteria},
                                      {.plane = "plane ", .criterion = "criterion "});
  if (threads < 0)
    throw lab::BadInput(
        fmt::format("threads {}: out of range; expected 0 (all cores) or more", threads));
  const py::gil_scoped_release free;
  Signals signals;
  return std::make_shared<Domain>(
      study::run_domain({.material = set, .grid = grid, .threads = threads},
                        [&](const std::string&, double) { signals.look(); }));
}

/// q, η and direction where a criterion is first met, a row a p′; NaN where it is not.
std::shared_ptr<Columns> boundary(const Domain& d, const std::string& criterion, bool extension) {
  const auto& keys = study::boundary_keys();
  if (std::ranges::find(keys, criterion) == keys.end())
    throw lab::BadInput(fmt::format("criterion '{}' is not valid; must be one of: {}", criterion,
                                    fmt::join(keys, ", ")));
  auto table = std::make_shared<Columns>();
  const auto add = [&](const char* name, auto of) {
    auto& values = table->add(name);
    for (const auto& column : d.domain.columns) {
      const auto mark = (extension ? column.extension : column.compression).mark(criterion);
      values.push_back(mark ? of(*mark) : lab::kMissing);
    }
  };
  table->add("p_eff_kPa") = d.p_kPa;
  add("q_kPa", [](const study::DomainMark& m) { return m.q_kPa; });
  add("eta", [](const study::DomainMark& m) { return m.eta; });
  add("alpha_deg", [](const study::DomainMark& m) { return m.alpha_deg.value_or(lab::kMissing); });
  return table;
}

py::tuple kinds() {
  py::tuple words(sim::kDomainStateKinds.size());
  for (std::size_t i = 0; i < sim::kDomainStateKinds.size(); ++i)
    words[i] = study::word_of(sim::kDomainStateKinds[i]);
  return words;
}

template <class Number>
py::array grid_view(const py::object& self, const std::vector<Number>& values) {
  const auto& d = self.cast<const Domain&>();
  return read_only_view(
      values, self,
      {static_cast<py::ssize_t>(d.p_kPa.size()), static_cast<py::ssize_t>(d.q_kPa.size())});
}

}  // namespace

void bind_domain(py::module_& module) {
  module.attr("DOMAIN_KINDS") = kinds();
  py::class_<Domain, std::shared_ptr<Domain>>(module, "Domain",
                                              "Bifurcation domain of a material at one void ratio.")
      .def_property_readonly(
          "p_kPa",
          [](const py::object& self) {
            return read_only_view(self.cast<const Domain&>().p_kPa, self);
          },
          "Mean effective stress of the columns of the grid, kPa.")
      .def_property_readonly(
          "q_kPa",
          [](const py::object& self) {
            return read_only_view(self.cast<const Domain&>().q_kPa, self);
          },
          "Deviator stress of the rows of the grid, kPa.")
      .def_property_readonly(
          "kind",
          [](const py::object& self) { return grid_view(self, self.cast<const Domain&>().kind); },
          "Index into triax.DOMAIN_KINDS for each state, [p, q].")
      .def_property_readonly(
          "least_work",
          [](const py::object& self) {
            return grid_view(self, self.cast<const Domain&>().least_work);
          },
          "Least normalised second-order work of each state, [p, q]; NaN if there is none.")
      .def("boundary", &boundary, py::arg("criterion") = "first_unstable", py::kw_only(),
           py::arg("extension") = false,
           "Find the state at which a criterion is first met, for each p'.\n"
           "Returns q_kPa, eta and alpha_deg of the direction; NaN if the criterion is not met.")
      .def_property_readonly(
          "warnings", [](const Domain& d) { return d.domain.settings.warnings; },
          "Warnings that a reader of the result must know.")
      .def_property_readonly(
          "report", [](const Domain& d) { return document(study::domain_json(d.domain)); },
          "Document of triax domain --json.")
      .def("__repr__", [](const Domain& d) {
        return fmt::format("<triax.Domain of {}: {} x {} states>", d.domain.settings.material.name,
                           d.p_kPa.size(), d.q_kPa.size());
      });
  module.def("domain", &domain, py::arg("material"), py::arg("void_ratio"), py::kw_only(),
             py::arg("p_kPa") = py::none(), py::arg("q_kPa") = py::none(),
             py::arg("plane") = "axisymmetric", py::arg("directions") = 360,
             py::arg("criteria") = std::vector<std::string>(), py::arg("threads") = 0,
             "Probe every state of a grid of p' and q at one void ratio (as triax domain).\n"
             "p_kPa and q_kPa are (from, to, count).");
}

}  // namespace triax::python
