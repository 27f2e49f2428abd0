// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/left_waiting.hpp"

#include <fmt/format.h>

#include "db/missing_readings.hpp"
#include "db/recording/spool.hpp"
#include "lab/base/text.hpp"
#include "src/output/notice.hpp"
#include "src/output/table.hpp"

namespace triax::src {

void tell_of_gaps(const std::string& db) {
  for (const db::LeftWaiting& left : db::left_waiting(db)) {
    const std::string what =
        left.test.empty()
            ? "something"
            : fmt::format("{} with {} readings", lab::excerpt(left.test), left.readings);
    notify(
        on_one_line(fmt::format("{}: {} of a program that has ended is not in the database and not "
                                "in this result; `triax tests repair` stores it",
                                left.spool, what)));
  }
  for (const db::MissingReadings& missing : db::missing_readings(db))
    notify(on_one_line(fmt::format("{}: test {} {}: {}", db, missing.test,
                                   lab::excerpt(missing.name), in_words(missing))));
}

}  // namespace triax::src
