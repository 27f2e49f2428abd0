// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/earlier_tests.hpp"

#include <fmt/format.h>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::study {

lab::EarlierTests earlier_tests(const std::string& db, const std::vector<std::string>& names) {
  lab::EarlierTests all;
  if (names.empty()) return all;
  const db::Store store(db);
  for (const std::int64_t id : store.find(names)) {
    const db::StoredTest test = store.load(id);
    const auto said = test.status == db::TestStatus::complete
                          ? lab::earlier_test(test.header, test.summary, store.forecasts(id))
                          : std::nullopt;
    if (!said)
      throw lab::BadInput(
          fmt::format("--earlier {}: not usable for the onset forecast: the test was not assessed "
                      "to the end of shear, failed on the limit surface, or was sheared drained "
                      "with prescribed displacement; leave it out",
                      test.header.name));
    all.add(*said);
  }
  return all;
}

}  // namespace triax::study
