// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/pybind11.h>

#include <mutex>

#include "lab/materials/material_library.hpp"

namespace triax::python {

/// A parameter set with a law of its own: nothing that changes while it is asked is shared with
/// another.
struct Material {
  explicit Material(lab::MaterialSet found);
  lab::MaterialSet set;
  /// For laws that are asked one at a time: a UMAT has one worker process.
  std::mutex one_at_a_time;
};

/// A name or a triax.Material as the set. Throws lab::BadInput, TypeError.
lab::MaterialSet material_of(const pybind11::object& name_or_material);

/// The void ratio of states that are given. Throws lab::BadInput.
double checked_void_ratio(double void_ratio);

}  // namespace triax::python
