// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A record as it would be read, before it is stored.
#include <vector>

#include "lab/rig/recorded.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {

/// Array of objects (key, label, unit, why) for the keys that the reduction needs and the header
/// does not have: each is found with the others taken as given.
Json missing_keys(const lab::RecordHeader& header);

/// Array of objects: what, taken, evidence, remedy, otherwise.
Json guesses_json(const std::vector<lab::Guess>& guesses);

/// The texts of the first 50.
Json warnings_json(const std::vector<lab::Warning>& warnings);

/// An object: "missing" (missing_keys()), "guessed", "warnings", "readings" (their
/// number, at most 200,000 are read) and "path" with equally long arrays "p_eff_kPa", "q_kPa" and
/// "axial_strain" of at most 800 readings; null if a key is missing. An unknown value is null.
/// Throws BadInput as RecordedRig::next() and Reduction::reduce().
Json preview_json(lab::RecordedRig& rig);

}  // namespace triax::study
