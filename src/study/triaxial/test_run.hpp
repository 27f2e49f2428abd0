// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "db/recording/patience.hpp"
#include "lab/rig/session.hpp"

namespace triax::study {

/// Runs one back end through the session into the database;
/// gives the test's id. Bad input takes out again what was stored of this test; any other failure
/// leaves it there, marked as interrupted. `also` listen beside the database, which
/// is waited for with `patience`. `entered` is told its id as soon as the test is there, by another
/// thread. `writer` as in db::Recorder. `db` is the path of the database that has the test
/// afterwards, another one where its folder was renamed meanwhile.
std::int64_t run_test(lab::BackEnd& back_end, const lab::SessionOptions& options, std::string& db,
                      lab::SessionListeners also = {}, db::Patience patience = {},
                      std::function<void(std::int64_t)> entered = {},
                      const std::string& writer = {});

}  // namespace triax::study
