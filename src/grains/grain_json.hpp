// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "db/grain_store.hpp"

namespace triax::src {

inline constexpr const char* kGrainReportFormat = "triax-grains";
inline constexpr int kGrainReportVersion = 1;

/// One document: origin, format, version, programme, specimen (null before it was made) and every
/// stage with all its points or probes and what follows from them. Units in the keys; what is
/// unknown is null.
std::string grain_json(const lab::GrainReport& report);

/// The same with what the database adds before it: id, name, status and when it was recorded.
std::string grain_run_json(const db::StoredGrainRun& run);

}  // namespace triax::src
