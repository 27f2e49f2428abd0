// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/points.hpp"

#include <pybind11/stl.h>

#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using sim::Axisymmetric;
using sim::Tensor;

/// One value for all points or one a point.
std::vector<double> values_of(const char* name, const Array& given, std::size_t count) {
  if (given.ndim() == 0) return std::vector<double>(count, *given.data());
  if (given.ndim() != 1 || static_cast<std::size_t>(given.shape(0)) != count)
    throw lab::BadInput(fmt::format(
        "{} has another shape than the points; expected one number or {}", name, count));
  return {given.data(), given.data() + count};
}

template <class Space>
std::shared_ptr<Points> started(const std::shared_ptr<Material>& material,
                                std::vector<double> stress_kPa, std::vector<double> void_ratio) {
  const auto& law = law_of<Space>(*material);
  auto points = std::make_shared<Points>(material, study::PointArrays{}, law.memory_names());
  const py::gil_scoped_release free;
  points->arrays = study::start_points(law, std::move(stress_kPa), std::move(void_ratio));
  return points;
}

std::shared_ptr<Points> points_at(const std::shared_ptr<Material>& material, const Array& stress,
                                  const Array& void_ratio) {
  const auto count = static_cast<std::size_t>(stress.ndim() > 0 ? stress.shape(0) : 0);
  const auto components = static_cast<std::size_t>(stress.ndim() == 2 ? stress.shape(1) : 0);
  if (count == 0 || (components != 2 && components != 6))
    throw lab::BadInput(
        "stress_kPa: not valid; expected a row a point, of axial and radial or of 11, 22, 33, 12, "
        "13, 23");
  auto rows = rows_of("stress_kPa", stress, count, components);
  auto e = values_of("void_ratio", void_ratio, count);
  return components == 2 ? started<Axisymmetric>(material, std::move(rows), std::move(e))
                         : started<Tensor>(material, std::move(rows), std::move(e));
}

/// What is read of points that another thread may be advancing. The GIL is released while it waits,
/// so that the other can end.
template <class Read>
auto alone(Points& points, const Read& read) {
  const py::gil_scoped_release free;
  const std::lock_guard lock(points.one_at_a_time);
  return read(points.arrays);
}

std::shared_ptr<Points> copy(Points& points) {
  return alone(points, [&](const study::PointArrays& arrays) {
    return std::make_shared<Points>(points.material, arrays, points.memory_names);
  });
}

template <class Space>
std::vector<double> invariant(const study::PointArrays& points,
                              double (*of)(const sim::Vector<Space>&)) {
  std::vector<double> values(points.count);
  for (std::size_t i = 0; i < points.count; ++i) {
    sim::Vector<Space> stress =
        Eigen::Map<const sim::Vector<Space>>(&points.stress_kPa[i * Space::kSize]);
    stress.template tail<(Space::kSize == 2 ? 1 : 3)>() *= std::numbers::sqrt2;
    values[i] = of(stress);
  }
  return values;
}

Array invariant_of(Points& points, double (*of)(const sim::Vector<Axisymmetric>&),
                   double (*of_tensor)(const sim::Vector<Tensor>&)) {
  const auto values = alone(points, [&](const study::PointArrays& arrays) {
    return points.tensor() ? invariant<Tensor>(arrays, of_tensor)
                           : invariant<Axisymmetric>(arrays, of);
  });
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace

void bind_points(py::module_& module) {
  py::class_<Points, std::shared_ptr<Points>>(
      module, "Points",
      "Points of one law.\n"
      "stress_kPa, void_ratio and memory are numpy arrays that refer to the states, without a "
      "copy.\n"
      "The next increment starts from the values that you write into them.\n"
      "The components are axial, radial or 11, 22, 33, 12, 13, 23.")
      .def(py::init(&points_at), py::arg("material"), py::arg("stress_kPa"), py::arg("void_ratio"),
           "Create a point for each row of stress_kPa (effective, compression positive), without "
           "memory of shear.")
      .def_property_readonly(
          "material", [](const Points& p) { return p.material; }, "Material of the points.")
      .def_property_readonly(
          "stress_kPa",
          [](const py::object& self) {
            const auto& a = self.cast<const Points&>().arrays;
            return view(a.stress_kPa, self, shape(a.count, a.components));
          },
          "Effective stress, kPa, one row per point.")
      .def_property_readonly(
          "void_ratio",
          [](const py::object& self) {
            return view(self.cast<const Points&>().arrays.void_ratio, self);
          },
          "Void ratio of each point.")
      .def_property_readonly(
          "memory",
          [](const py::object& self) {
            const auto& a = self.cast<const Points&>().arrays;
            return view(a.memory, self, shape(a.count, a.memories));
          },
          "Memory of the law, one row per point, in the order of memory_names.")
      .def_property_readonly(
          "memory_names", [](const Points& p) { return p.memory_names; },
          "Names of the columns of memory. Columns in _root2 contain sqrt(2) times the component.")
      .def_property_readonly(
          "p_kPa",
          [](Points& p) {
            return invariant_of(p, &sim::mean_stress<Axisymmetric>, &sim::mean_stress<Tensor>);
          },
          "Mean effective stress of each point, kPa.")
      .def_property_readonly(
          "q_kPa",
          [](Points& p) {
            return invariant_of(p, &sim::deviator_stress<Axisymmetric>,
                                &sim::deviator_stress<Tensor>);
          },
          "Deviator stress of each point, kPa: sigma1 - sigma3, or sqrt(3/2)|s| for a tensor.")
      .def("advance", &advance, py::arg("strain") = py::none(), py::kw_only(),
           py::arg("stress_kPa") = py::none(), py::arg("control") = py::none(),
           py::arg("increment") = py::none(), py::arg("tolerance") = 1e-10,
           "Apply one increment to every point, in place: of strain, of effective stress, or of "
           "conditions\n"
           "S dsigma' + E depsilon = increment with control=(S, E).\n"
           "An increment is one row for all points, or one row per point.\n"
           "If an increment cannot be completed, the point stays at the state that it reached.\n"
           "Its outcome reports this.")
      .def("copy", &copy, "Copy the states to separate memory.")
      .def("__len__", [](const Points& p) { return p.arrays.count; })
      .def("__repr__", [](const Points& p) {
        return fmt::format("<triax.Points: {} of {}>", p.arrays.count, p.material->set.name);
      });
}

}  // namespace triax::python
