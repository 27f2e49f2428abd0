// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/points.hpp"
#include "src/python/signals.hpp"

namespace triax::python {

namespace py = pybind11;

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

namespace {

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

}  // namespace

std::shared_ptr<Steps> advance(Points& points, const Given& strain, const Given& stress,
                               const Matrices& control, const Given& increment, double tolerance) {
  return points.tensor()
             ? advanced<sim::Tensor>(points, strain, stress, control, increment, tolerance)
             : advanced<sim::Axisymmetric>(points, strain, stress, control, increment, tolerance);
}

}  // namespace triax::python
