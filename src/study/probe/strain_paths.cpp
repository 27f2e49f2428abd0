// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/strain_paths.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"

namespace triax::study {

StrainPathsResult strain_paths(const StrainPathsRequest& request) {
  const auto& [material, p, void_ratio, R, axial_strain] = request;
  const auto* law = material.material.axisymmetric.get();
  if (law == nullptr)
    throw lab::BadInput(material.name + " has no form in axisymmetry, which strain paths need");
  const auto start = law->isotropic(p, void_ratio);
  if (const auto objection = law->objection(start))
    throw lab::BadInput(fmt::format("p' {:.6g} kPa, void ratio {:.6g}: out of range for {}: {}",
                                    p / 1e3, void_ratio, material.name, *objection));
  StrainPathsResult result{.material = material,
                           .p = p,
                           .void_ratio = void_ratio,
                           .axial_strain = axial_strain,
                           .paths = {},
                           .warnings = {}};
  for (const auto& words :
       {lab::void_ratio_outside(material, void_ratio), lab::p_eff_outside(material, p)})
    if (words) result.warnings.push_back(*words);
  for (const double one : R) {
    const sim::StrainPathOptions options{.axial_strain = axial_strain};
    const sim::StrainPath& path =
        result.paths.emplace_back(sim::strain_path(*law, start, one, options));
    if (path.vanished && !path.peak)
      result.warnings.push_back(
          fmt::format("R {:g}: p' falls below {:g} kPa at an axial strain of {:.4g} % without a "
                      "peak; the search ends there",
                      one, options.least_p / 1e3, 100 * path.vanished->axial_strain));
    if (!path.message.empty())
      result.warnings.push_back(fmt::format("R {:g}: {}", one, path.message));
  }
  return result;
}

}  // namespace triax::study
