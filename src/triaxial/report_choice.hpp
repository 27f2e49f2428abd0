// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `triax report` was asked for: tests, and runs of grains.
#include <cstdint>
#include <string>
#include <vector>

#include "db/grain_store.hpp"
#include "db/store.hpp"

namespace triax::src {

struct ReportChoice {
  std::vector<std::int64_t> tests, runs;
};

/// A test by its number or name (db::Store::find), a run of grains by its name, or by "grains:ID"
/// and "grains:NAME"; all of both without names. Throws lab::BadInput where there is neither, or
/// where a name stands for a test as well as for a run.
ReportChoice report_choice(const db::Store& tests, const db::GrainStore& runs,
                           const std::vector<std::string>& names);

}  // namespace triax::src
