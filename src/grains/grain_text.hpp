#pragma once
#include <string>

#include "src/study/grains/grain_report.hpp"

namespace triax::src {

/// The specimen, a table of the stages, and tables of what paths, rests, probes and perturbations
/// came to, for people; with short names of stages no line is longer than 100 columns.
std::string grain_text(const study::GrainReport& report);

}  // namespace triax::src
