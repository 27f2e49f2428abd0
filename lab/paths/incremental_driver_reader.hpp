// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads the three files of Niemunis' incrementalDriver: a loading path (test.inp), a material
// (parameters.inp) and a start (initialconditions.inp). They are in kPa, tension positive, with
// components 11, 22, 33, 12, 13, 23 and shear strains γ = 2 ε; here all becomes SI, compression
// positive. Their stresses are effective ones.
//
// Keywords: *LinearLoad, *CirculatingLoad and *ImportFile in the frames *Cartesian, *Roscoe,
// *RoscoeIsomorph and *Rendulic; *OedometricE1, *OedometricS1, *TriaxialE1, *TriaxialS1,
// *TriaxialUEq, *TriaxialUq, *PureRelaxation, *PureCreep, *UndrainedCreep, *ObeyRestrictions;
// *Repetition; *End; "? CONDITION" behind a keyword ends a step. What is no set of linear
// conditions (*DeformationGradient, *PerturbationsS, *PerturbationsE) is refused by name.
//
// The number of increments of a step only makes rows of output; what the material does does not
// depend on it.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/paths/path_description.hpp"

namespace triax::lab {

/// What the files do not say.
struct IncrementalDriverSettings {
  std::string umat;                  ///< library that is the material; empty: a law of triax
  std::optional<double> void_ratio;  ///< at the start
  int void_ratio_index = 0;  ///< 1-based number of the state variable that is it; 0: unknown
  std::optional<double> time_limit_s;  ///< for a call of `umat`
};

struct IncrementalDriverTest {
  std::string name;     ///< of the output that test.inp asks for, without its extension
  std::string heading;  ///< behind the # of that line
  MaterialSet material;
  sim::Path<sim::Tensor> path;
  std::vector<std::string> files;     ///< those read
  std::vector<std::string> warnings;  ///< what a reader must know of the translation
};

/// A file by its name, as the three call each other: its text. Throws BadInput where there is none.
using InpFile = std::function<std::string(const std::string& name)>;

/// `file` is asked for "test.inp", "parameters.inp", "initialconditions.inp" and what they name.
/// Messages call a file `folder`/name, from where a library is looked for, too. Throws BadInput
/// (file:line, what was found, what would be right).
IncrementalDriverTest read_incremental_driver(const InpFile& file, const std::string& folder,
                                              const IncrementalDriverSettings& settings);

/// The same from a folder, or from a test.inp (of any name) with the other two beside it.
IncrementalDriverTest load_incremental_driver(const std::string& path,
                                              const IncrementalDriverSettings& settings);

/// The same as any other path. Of the settings umat, void_ratio, void_ratio_index and, beside umat,
/// time_limit_s are taken out and used; change_setting() is for the rest. Throws BadInput.
PathDescription describe_incremental_driver(
    const std::string& path, std::vector<std::pair<std::string, std::string>>& settings);

/// Whether load_incremental_driver is meant: a folder, or a file NAME.inp.
bool is_incremental_driver(const std::string& path);

}  // namespace triax::lab
