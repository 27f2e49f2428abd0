#pragma once
#include <string>

#include "src/study/grains/grain_report.hpp"

namespace triax::src {

inline constexpr const char* kGrainReportFormat = "triax-grains";
inline constexpr int kGrainReportVersion = 1;

/// One document: origin, format, version, programme, specimen (null before it was made) and every
/// stage with all its points or probes and what follows from them. Units in the keys; what is
/// unknown is null.
std::string grain_json(const study::GrainReport& report);

}  // namespace triax::src
