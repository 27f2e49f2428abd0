// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/paths/incremental_driver_reader.hpp"
#include "lab/paths/inp_lines.hpp"

namespace triax::lab {

/// The steps of a test.inp, from behind its first line to *End or its end, as segments. Throws
/// BadInput.
std::vector<sim::Segment<sim::Tensor>> read_inp_steps(InpLines& lines, const InpFile& file,
                                                      std::vector<std::string>& files,
                                                      std::vector<std::string>& warnings);

}  // namespace triax::lab
