// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/paths/path_reader.hpp"
#include "src/python/bindings.hpp"
#include "src/python/documents.hpp"
#include "src/python/material.hpp"

namespace triax::python {

namespace py = pybind11;

Material::Material(lab::MaterialSet found) : set(std::move(found)) {
  set.material = lab::made_anew(set);
}

lab::MaterialSet material_of(const py::object& name_or_material) {
  if (py::isinstance<py::str>(name_or_material))
    return lab::find_material(name_or_material.cast<std::string>());
  return name_or_material.cast<const Material&>().set;
}

double checked_void_ratio(double e) {
  if (!(e >= lab::kSmallestVoidRatio && e <= lab::kLargestVoidRatio))
    throw lab::BadInput(
        fmt::format("void_ratio {:g}: out of range; expected a number from {:g} to {:g}", e,
                    lab::kSmallestVoidRatio, lab::kLargestVoidRatio));
  return e;
}

namespace {

using File = std::optional<std::filesystem::path>;

std::vector<lab::MaterialSet> sets_of(const File& file) {
  if (!file) return lab::shipped_materials();
  return lab::read_materials(lab::read_text_file(file->string()), file->string());
}

std::shared_ptr<Material> material(const std::string& name, const File& file,
                                   const py::dict& sets) {
  lab::MaterialSet set = file ? lab::find_material(name, sets_of(file)) : lab::find_material(name);
  for (const auto& [key, value] : key_values(sets)) set = lab::with_parameter(set, key, value);
  return std::make_shared<Material>(std::move(set));
}

py::dict parameters_of(const Material& m) {
  py::dict all;
  for (const auto& [key, value] : m.set.parameters.numbers) all[py::str(key)] = value;
  for (const auto& [key, value] : m.set.parameters.texts) all[py::str(key)] = value;
  for (const auto& [key, value] : m.set.parameters.lists) all[py::str(key)] = value;
  return all;
}

py::object ends(const std::optional<lab::ValidRange>& range) {
  return range ? py::object(py::make_tuple(range->low, range->high)) : py::none();
}

std::optional<double> limit_of(const Material& m) {
  const auto& [axisymmetric, tensor, why, based_on] = m.set.material;
  if (axisymmetric) return axisymmetric->limit_stress_ratio();
  return tensor ? tensor->limit_stress_ratio() : std::nullopt;
}

}  // namespace

void bind_materials(py::module_& module) {
  py::class_<Material, std::shared_ptr<Material>>(
      module, "Material",
      "Law with a set of parameters, for example 'sanisand/S28-general'. triax.materials() lists "
      "the sets.")
      .def(py::init(&material), py::arg("name"), py::kw_only(), py::arg("file") = py::none(),
           py::arg("sets") = py::dict(),
           "Create a material from a parameter set.\n"
           "`file` contains your own sets (also of a UMAT). `sets` changes parameters by key.")
      .def_property_readonly(
          "name", [](const Material& m) { return m.set.name; },
          "Name of the set, LAW/SET, with the changed parameters.")
      .def_property_readonly(
          "law", [](const Material& m) { return m.set.law->name; }, "Name of the law.")
      .def_property_readonly(
          "description", [](const Material& m) { return m.set.description; },
          "Description of the set.")
      .def_property_readonly(
          "source", [](const Material& m) { return m.set.source; }, "Source of the numbers.")
      .def_property_readonly(
          "range", [](const Material& m) { return m.set.range; },
          "Range for which the numbers are valid, as text.")
      .def_property_readonly(
          "void_ratio_range", [](const Material& m) { return ends(m.set.void_ratio_range); },
          "Void ratios for which the set is valid; None if not stated.")
      .def_property_readonly(
          "p_eff_range_kPa", [](const Material& m) { return ends(m.set.p_eff_range_kPa); },
          "Mean effective stresses for which the set is valid, kPa; None if not stated.")
      .def_property_readonly("parameters", &parameters_of,
                             "Values of the parameters by key. The key ends with the unit.")
      .def_property_readonly("limit_stress_ratio", &limit_of,
                             "M in triaxial compression; None if the law has none.")
      .def("__repr__", [](const Material& m) { return "<triax.Material '" + m.set.name + "'>"; });
  module.def(
      "materials",
      [](const File& file) {
        std::vector<std::string> names;
        for (const auto& set : sets_of(file)) names.push_back(set.name);
        return names;
      },
      py::arg("file") = py::none(),
      "List the names of the parameter sets that ship with the program, or of the sets in a file.");
}

}  // namespace triax::python
