// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A saved state of grains as what a specimen of the apparatus is made of.
#include <memory>
#include <string>

#include "lab/materials/material_library.hpp"
#include "sim/grains/paths/grain_law.hpp"

namespace triax::lab {

/// The law of these grains. Throws BadInput: the file, or why the apparatus cannot take the grains
/// (sim/grains/paths/grain_law.hpp).
std::shared_ptr<const sim::GrainLaw> grain_specimen(const std::string& path,
                                                    const sim::GrainDriving& how = {});

/// The grains among materials, "2000 spheres, loose.grains": no law by name, no parameters, no
/// tensor form.
MaterialSet grain_material(std::shared_ptr<const sim::GrainLaw> law, const std::string& path);

}  // namespace triax::lab
