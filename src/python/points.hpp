// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Points of a law in arrays (src/study/element/point_arrays.hpp) as Python has them.
#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "src/python/material.hpp"
#include "src/study/element/point_arrays.hpp"

namespace triax::python {

using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

struct Points {
  Points(std::shared_ptr<Material> of, study::PointArrays states, std::vector<std::string> names)
      : material(std::move(of)), arrays(std::move(states)), memory_names(std::move(names)) {}
  std::shared_ptr<Material> material;
  study::PointArrays arrays;
  std::vector<std::string> memory_names;
  std::mutex one_at_a_time;
  [[nodiscard]] bool tensor() const { return arrays.components == sim::Tensor::kSize; }
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
    throw lab::BadInput(
        material.set.name +
        " integrates its points itself and cannot be used in arrays; use triax.simulate");
  return *law;
}

/// `given` as rows: one for all points, or one a point. Throws lab::BadInput that says its `name`.
std::vector<double> rows_of(const char* name, const Array& given, std::size_t count,
                            std::size_t components);

/// The shape of an array of rows.
inline std::vector<pybind11::ssize_t> shape(std::size_t rows, std::size_t columns) {
  return {static_cast<pybind11::ssize_t>(rows), static_cast<pybind11::ssize_t>(columns)};
}

using Given = std::optional<Array>;
/// S and E of S dσ′ + E dε = dy.
using Matrices = std::optional<std::pair<Array, Array>>;

/// Takes the points an increment further, without the GIL. Throws lab::BadInput where that is not
/// said by one of strain, stress and control with increment.
std::shared_ptr<Steps> advance(Points& points, const Given& strain, const Given& stress,
                               const Matrices& control, const Given& increment, double tolerance);

}  // namespace triax::python
