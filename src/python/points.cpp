// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a law in arrays, one increment at a time (src/study/element/point_arrays.hpp).
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "lab/base/bad_input.hpp"
#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"
#include "src/python/material.hpp"
#include "src/python/signals.hpp"
#include "src/study/element/point_arrays.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using sim::Axisymmetric;
using sim::Tensor;

struct Points {
  Points(std::shared_ptr<Material> of, study::PointArrays states, std::vector<std::string> names)
      : material(std::move(of)), arrays(std::move(states)), memory_names(std::move(names)) {}
  std::shared_ptr<Material> material;
  study::PointArrays arrays;
  std::vector<std::string> memory_names;
  std::mutex one_at_a_time;
  [[nodiscard]] bool tensor() const { return arrays.components == Tensor::kSize; }
};

struct Steps {
  Steps(study::StepArrays made, std::size_t of) : arrays(std::move(made)), components(of) {}
  study::StepArrays arrays;
  std::size_t components;
};

/// What a law is called by messages, and it in this space.
template <class Space>
const sim::Law<Space>& law_of(const Material& material) {
  const sim::Law<Space>* law = material.set.material.law<Space>();
  if (law == nullptr)
    throw lab::BadInput(
        fmt::format("{} is not formulated for {}{}", material.set.name,
                    Space::kSize == 2 ? "axisymmetry" : "the full tensor",
                    Space::kSize == 2 ? "" : ": " + material.set.material.no_tensor));
  if (law->self_driven() != nullptr)
    throw lab::BadInput(material.set.name +
                        " drives its points itself and has no place in arrays; use triax.simulate");
  return *law;
}

/// One value for all points or one a point.
std::vector<double> values_of(const char* name, const Array& given, std::size_t count) {
  if (given.ndim() == 0) return std::vector<double>(count, *given.data());
  if (given.ndim() != 1 || static_cast<std::size_t>(given.shape(0)) != count)
    throw lab::BadInput(fmt::format(
        "{} has another shape than the points; expected one number or {}", name, count));
  return {given.data(), given.data() + count};
}

/// One row for all points or one a point.
std::vector<double> rows_of(const char* name, const Array& given, std::size_t count,
                            std::size_t components) {
  const bool one = given.ndim() == 1 && static_cast<std::size_t>(given.shape(0)) == components;
  const bool each = given.ndim() == 2 && static_cast<std::size_t>(given.shape(0)) == count &&
                    static_cast<std::size_t>(given.shape(1)) == components;
  if (!one && !each)
    throw lab::BadInput(
        fmt::format("{} has another shape than the points; expected {} numbers or {} rows of them",
                    name, components, count));
  return {given.data(), given.data() + given.size()};
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

using Given = std::optional<Array>;
using Matrices = std::optional<std::pair<Array, Array>>;

template <class Space>
sim::Matrix<Space> matrix_of(const char* name, const Array& given) {
  constexpr int kSize = Space::kSize;
  if (given.ndim() != 2 || given.shape(0) != kSize || given.shape(1) != kSize)
    throw lab::BadInput(
        fmt::format("{} of control: not valid; expected a matrix of {} x {}", name, kSize, kSize));
  return Eigen::Map<const Eigen::Matrix<double, kSize, kSize, Eigen::RowMajor>>(given.data());
}

template <class Space>
study::PointConditions<Space> conditions_of(const Points& points, const Given& strain,
                                            const Given& stress, const Matrices& control,
                                            const Given& increment) {
  if (strain.has_value() + stress.has_value() + control.has_value() != 1)
    throw lab::BadInput("give one of strain, stress_kPa and control (with increment)");
  if (control.has_value() != increment.has_value())
    throw lab::BadInput(
        "control needs increment, and increment control: S dsigma' + E depsilon = increment");
  study::PointConditions<Space> conditions;
  const auto rows = [&](const char* name, const Array& given) {
    conditions.rows = rows_of(name, given, points.arrays.count, points.arrays.components);
  };
  if (strain) {
    conditions.strain.setIdentity();
    rows("strain", *strain);
  } else if (stress) {
    conditions.stress.setIdentity();
    rows("stress_kPa", *stress);
  } else {
    conditions.stress = matrix_of<Space>("S", control->first);
    conditions.strain = matrix_of<Space>("E", control->second);
    rows("increment", *increment);
  }
  return conditions;
}

template <class Space>
std::shared_ptr<Steps> advanced(Points& points, const Given& strain, const Given& stress,
                                const Matrices& control, const Given& increment, double tolerance) {
  if (!(tolerance > 0 && tolerance <= 0.01))
    throw lab::BadInput(fmt::format(
        "tolerance {:g}: out of range; expected a number above 0 and at most 0.01", tolerance));
  const auto conditions = conditions_of<Space>(points, strain, stress, control, increment);
  const auto& law = law_of<Space>(*points.material);
  Signals signals;
  const py::gil_scoped_release free;
  std::unique_lock law_alone(points.material->one_at_a_time, std::defer_lock);
  if (law.finite()) law_alone.lock();
  const std::lock_guard points_alone(points.one_at_a_time);
  return std::make_shared<Steps>(
      study::advance_points(law, conditions, {.relative = tolerance}, points.arrays,
                            [&] { return signals.look(); }),
      points.arrays.components);
}

std::shared_ptr<Steps> advance(Points& points, const Given& strain, const Given& stress,
                               const Matrices& control, const Given& increment, double tolerance) {
  return points.tensor()
             ? advanced<Tensor>(points, strain, stress, control, increment, tolerance)
             : advanced<Axisymmetric>(points, strain, stress, control, increment, tolerance);
}

std::shared_ptr<Points> copy(const Points& points) {
  return std::make_shared<Points>(points.material, points.arrays, points.memory_names);
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

Array owned(const std::vector<double>& values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

std::vector<py::ssize_t> shape(std::size_t rows, std::size_t columns) {
  return {static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)};
}

using Member = std::vector<double> study::StepArrays::*;

/// A property of Steps: an array of a number a point, or of a row a point.
auto of_steps(Member member, bool row) {
  return [member, row](const py::object& self) {
    const auto& steps = self.cast<const Steps&>();
    return read_only_view(
        steps.arrays.*member, self,
        row ? shape(steps.arrays.done.size(), steps.components) : std::vector<py::ssize_t>());
  };
}

void bind_steps(py::module_& module) {
  py::class_<Steps, std::shared_ptr<Steps>>(
      module, "Steps", "What became of points that were taken an increment further.")
      .def_property_readonly(
          "outcome",
          [](const py::object& self) {
            return read_only_view(self.cast<const Steps&>().arrays.outcome, self);
          },
          "A place in triax.OUTCOMES for each point.")
      .def_property_readonly(
          "accepted",
          [](const Steps& s) {
            return std::ranges::all_of(s.arrays.outcome,
                                       [](std::uint8_t outcome) { return outcome == 0; });
          },
          "Whether every point went to the end of its increment within the tolerance.")
      .def_property_readonly(
          "done", of_steps(&study::StepArrays::done, false),
          "Fraction of the increment; less than 1 where control was lost or the law failed.")
      .def_property_readonly("error", of_steps(&study::StepArrays::error, false),
                             "Largest estimated error, relative.")
      .def_property_readonly("stress_kPa", of_steps(&study::StepArrays::stress_kPa, true),
                             "Increments of effective stress of the part done, a row a point.")
      .def_property_readonly("strain", of_steps(&study::StepArrays::strain, true),
                             "Increments of strain of the part done, a row a point.")
      .def_property_readonly("work_kPa", of_steps(&study::StepArrays::work_kPa, false),
                             "Second-order work of the part done, kPa.")
      .def_property_readonly("work_normalised",
                             of_steps(&study::StepArrays::work_normalised, false),
                             "The same over the norms of both increments, in [-1, 1].")
      .def_property_readonly(
          "messages",
          [](const Steps& s) {
            py::dict all;
            for (const auto& [place, text] : s.arrays.messages) all[py::int_(place)] = text;
            return all;
          },
          "Why, by the place of the point; of the first hundred that were not accepted.");
}

}  // namespace

void bind_points(py::module_& module) {
  module.attr("OUTCOMES") = py::make_tuple("accepted", "inaccurate", "lost_control", "failed");
  bind_steps(module);
  py::class_<Points, std::shared_ptr<Points>>(
      module, "Points",
      "Points of one law. stress_kPa, void_ratio and memory are numpy arrays that show the states "
      "themselves, without a copy:\n"
      "what is written into them is what the next increment starts from. Components are axial, "
      "radial or 11, 22, 33, 12, 13, 23.")
      .def(py::init(&points_at), py::arg("material"), py::arg("stress_kPa"), py::arg("void_ratio"),
           "A point for each row of stress_kPa (effective, compression positive), without memory "
           "of shear.")
      .def_property_readonly(
          "material", [](const Points& p) { return p.material; }, "Their material.")
      .def_property_readonly(
          "stress_kPa",
          [](const py::object& self) {
            const auto& a = self.cast<const Points&>().arrays;
            return view(a.stress_kPa, self, shape(a.count, a.components));
          },
          "Effective stress, kPa, a row a point.")
      .def_property_readonly(
          "void_ratio",
          [](const py::object& self) {
            return view(self.cast<const Points&>().arrays.void_ratio, self);
          },
          "Void ratio.")
      .def_property_readonly(
          "memory",
          [](const py::object& self) {
            const auto& a = self.cast<const Points&>().arrays;
            return view(a.memory, self, shape(a.count, a.memories));
          },
          "What the law remembers, a row a point, in the order of memory_names.")
      .def_property_readonly(
          "memory_names", [](const Points& p) { return p.memory_names; },
          "Names of the columns of memory; those in _root2 hold sqrt(2) times the component.")
      .def_property_readonly(
          "p_kPa",
          [](const Points& p) {
            return owned(p.tensor()
                             ? invariant<Tensor>(p.arrays, &sim::mean_stress<Tensor>)
                             : invariant<Axisymmetric>(p.arrays, &sim::mean_stress<Axisymmetric>));
          },
          "Mean effective stress of each point, kPa.")
      .def_property_readonly(
          "q_kPa",
          [](const Points& p) {
            return owned(p.tensor() ? invariant<Tensor>(p.arrays, &sim::deviator_stress<Tensor>)
                                    : invariant<Axisymmetric>(p.arrays,
                                                              &sim::deviator_stress<Axisymmetric>));
          },
          "Deviator stress of each point, kPa: sigma1 - sigma3, of a tensor sqrt(3/2)|s|.")
      .def("advance", &advance, py::arg("strain") = py::none(), py::kw_only(),
           py::arg("stress_kPa") = py::none(), py::arg("control") = py::none(),
           py::arg("increment") = py::none(), py::arg("tolerance") = 1e-10,
           "Takes every point an increment further, in place: of strain, of effective stress, or "
           "of conditions\n"
           "S dsigma' + E depsilon = increment with control=(S, E). An increment is a row for all "
           "points, or a row a point.\n"
           "A point of which the increment cannot be done to its end stays where it came to, and "
           "its outcome says so.")
      .def("copy", &copy, "The same states once more, in memory of their own.")
      .def("__len__", [](const Points& p) { return p.arrays.count; })
      .def("__repr__", [](const Points& p) {
        return fmt::format("<triax.Points: {} of {}>", p.arrays.count, p.material->set.name);
      });
}

}  // namespace triax::python
