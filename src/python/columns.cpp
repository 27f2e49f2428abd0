// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/columns.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "src/python/bindings.hpp"

namespace triax::python {

namespace py = pybind11;

std::size_t Columns::rows() const {
  if (columns.empty()) return 0;
  return std::visit([](const auto& values) { return values.size(); }, columns.front().second);
}

const Columns::Values* Columns::find(const std::string& name) const {
  const auto at = std::ranges::find(columns, name, [](const auto& column) { return column.first; });
  return at == columns.end() ? nullptr : &at->second;
}

namespace {

std::vector<std::string> names_of(const Columns& table) {
  std::vector<std::string> names;
  for (const auto& [name, values] : table.columns) names.push_back(name);
  return names;
}

std::string listed(const Columns& table) {
  std::string list;
  for (const auto& [name, values] : table.columns) list += (list.empty() ? "" : ", ") + name;
  return list;
}

py::array column(const py::object& self, const std::string& name, PyObject* error) {
  const auto& table = self.cast<const Columns&>();
  const Columns::Values* values = table.find(name);
  if (values == nullptr) {
    const std::string text = "unknown column '" + name + "'; must be one of: " + listed(table);
    PyErr_SetString(error, text.c_str());
    throw py::error_already_set();
  }
  return std::visit([&](const auto& numbers) { return read_only_view(numbers, self); }, *values);
}

}  // namespace

void bind_columns(py::module_& module) {
  py::class_<Columns, std::shared_ptr<Columns>>(
      module, "Columns",
      "Table of columns.\n"
      "table.q_kPa and table['q_kPa'] are read-only numpy arrays.\n"
      "They refer to the program's own memory, without a copy. An unknown value is NaN.\n"
      "For pandas, use pandas.DataFrame(dict(table)).")
      .def(
          "__getattr__",
          [](const py::object& self, const std::string& name) {
            return column(self, name, PyExc_AttributeError);
          },
          py::arg("name"))
      .def(
          "__getitem__",
          [](const py::object& self, const std::string& name) {
            return column(self, name, PyExc_KeyError);
          },
          py::arg("name"))
      .def(
          "__contains__",
          [](const Columns& table, const std::string& name) { return table.find(name) != nullptr; },
          py::arg("name"))
      .def("__iter__", [](const Columns& table) { return py::iter(py::cast(names_of(table))); })
      .def("__len__", [](const Columns& table) { return table.columns.size(); })
      .def("__dir__", &names_of)
      .def("keys", &names_of, "List the names of the columns, with their units.")
      .def_property_readonly("rows", &Columns::rows, "Number of rows, the length of every column.")
      .def("__repr__", [](const Columns& table) {
        return "<triax.Columns of " + std::to_string(table.rows()) + " rows: " + listed(table) +
               ">";
      });
}

}  // namespace triax::python
