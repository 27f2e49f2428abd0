// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/report_choice.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::src {
namespace {

constexpr std::string_view kGrains = "grains:";

std::int64_t run_after_prefix(const db::GrainStore& runs, const std::string& name) {
  const std::string asked = name.substr(kGrains.size());
  if (const auto id = runs.find(asked)) return *id;
  throw lab::BadInput(fmt::format(
      "grain run '{}' does not exist; `triax query grain_runs` lists all grain runs", asked));
}

/// A number alone is that of a test.
std::optional<std::int64_t> run_called(const db::GrainStore& runs, const std::string& name) {
  return lab::whole_text_as<std::int64_t>(name) ? std::nullopt : runs.find(name);
}

void choose(ReportChoice& choice, const db::Store& tests, const db::GrainStore& runs,
            const std::string& name) {
  if (name.starts_with(kGrains)) {
    choice.runs.push_back(run_after_prefix(runs, name));
    return;
  }
  const auto run = run_called(runs, name);
  if (!run) {
    choice.tests.push_back(tests.find({name}).front());
    return;
  }
  std::optional<std::int64_t> test;
  try {
    test = tests.find({name}).front();
  } catch (const lab::BadInput&) {
    // No test, or several, none of which has the whole name: the run has it.
  }
  if (test && tests.load(*test).header.name == name)
    throw lab::BadInput(fmt::format(
        "'{0}' is both test {1} and grain run {2}; give {1} for the test, grains:{2} for the run",
        name, *test, *run));
  choice.runs.push_back(*run);
}

}  // namespace

ReportChoice report_choice(const db::Store& tests, const db::GrainStore& runs,
                           const std::vector<std::string>& names) {
  if (names.empty()) return {tests.find({}), runs.all()};
  ReportChoice choice;
  for (const auto& name : names) choose(choice, tests, runs, name);
  return choice;
}

}  // namespace triax::src
