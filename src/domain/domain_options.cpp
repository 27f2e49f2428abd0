// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/domain_options.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/range.hpp"
#include "lab/base/text.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "src/cli/shared_options.hpp"
#include "src/study/domain/usual_grid.hpp"

namespace triax::src {
namespace {

constexpr std::int64_t kMostValues = 1'000'000;  // of a range; a grid has fewer

/// FROM:TO/COUNT, FROM:TO:STEP or FROM:TO; `usual` where nothing is given.
study::GridLine line(const char* option, const std::string& text, const study::GridLine& usual) {
  if (text.empty()) return usual;
  const bool ends_only = std::ranges::count(text, ':') == 1 && text.find('/') == std::string::npos;
  try {
    const lab::Range range =
        lab::read_range(ends_only ? fmt::format("{}/{}", text, usual.count) : text, kMostValues);
    if (!range.meets_end())
      throw std::invalid_argument(fmt::format(
          "{} does not reach its end with this step; for {:g} values write {:g}:{:g}/{:g}",
          lab::excerpt(text), *range.step, range.from, range.to, *range.step));
    study::GridLine found = usual;
    found.from = range.from;
    found.to = range.to;
    found.count = static_cast<int>(range.count);
    return found;
  } catch (const std::invalid_argument& error) {
    throw lab::BadInput(fmt::format("{} {}", option, error.what()));
  }
}

}  // namespace

void add_domain_options(CLI::App& app, DomainOptions& o) {
  add_material(app, o.material);
  app.add_option("--p-kPa", o.p,
                 "mean effective stresses in kPa; RANGE is FROM:TO (200 values), FROM:TO/COUNT or "
                 "FROM:TO:STEP "
                 "[10:300/200 within the range of the set]")
      ->type_name("RANGE");
  app.add_option(
         "--q-kPa", o.q,
         "deviator stresses in kPa, negative in extension [200 values from 0 to M times the "
         "highest p']")
      ->type_name("RANGE");
  app.add_option("--plane", o.plane, "plane of the stress increments [axisymmetric]")
      ->check(CLI::IsMember({"axisymmetric", "plane-strain"}).description(""))
      ->type_name("axisymmetric|plane-strain");
  app.add_option("--directions", o.directions, "number of directions at each state")
      ->capture_default_str()
      ->type_name("N");
  for (const auto& kind : sim::domain_criterion_kinds())
    if (kind.on_request())
      app.add_flag_callback(
          fmt::format("--{}", kind.name), [&o, kind] { o.criteria.emplace_back(kind.name); },
          std::string(kind.help));
  add_jobs(app, o.jobs, "number of threads, without effect on the results", 4096);
  app.add_option("--piece", o.piece,
                 "compute only columns I, I+N, I+2N, ... and write them to the file --output")
      ->type_name("I/N");
  app.add_option("--merge", o.merge, "merge these pieces instead of computing")
      ->type_name("FILE...");
  app.add_option("--output", o.output,
                 "write domain.csv (states), domain_boundaries.csv, domain.json, the map as "
                 "domain.svg, .png and .pdf, and cones at some states as domain_cones_pq and "
                 "domain_cones_rendulic to FOLDER; with --piece, the file of the piece")
      ->type_name("FOLDER");
  app.add_option("--test", o.tests,
                 "show the measured increment of this test at collapse in the figures of cones "
                 "(repeatable)")
      ->type_name("TEST")
      ->allow_extra_args(false);
  add_db(app, o.db);
  add_json(app, o.json);
}

void check_domain_options(const CLI::App& app, const DomainOptions& o) {
  static constexpr std::array<std::string_view, 6> kWithMerge = {"--merge", "--output", "--test",
                                                                 "--db",    "--format", "--json"};
  if (!o.merge.empty())
    for (const CLI::Option* option : app.get_options())
      if (option->count() > 0 &&
          std::ranges::find(kWithMerge, option->get_name()) == kWithMerge.end())
        throw lab::BadInput(
            fmt::format("{} cannot be used with --merge: the options are those of the pieces",
                        option->get_name()));
  if (!o.piece.empty() && o.output.empty()) throw lab::BadInput("--piece needs --output FILE");
  if (!o.piece.empty() && o.json)
    throw lab::BadInput("--piece excludes --json: it writes to --output and prints nothing");
  if (!o.tests.empty() && (o.output.empty() || !o.piece.empty() || o.plane != "axisymmetric"))
    throw lab::BadInput("--test needs --output and the axisymmetric plane, and excludes --piece");
}

study::DomainSettings::Grid chosen_grid(const DomainOptions& o, const lab::MaterialSet& material) {
  const study::GridLine p = line("--p-kPa", o.p, study::usual_p(material));
  const study::GridLine q = line("--q-kPa", o.q, study::usual_q(material, p));
  return study::asked_grid(material,
                           {.p = p,
                            .q = q,
                            .void_ratio = chosen_void_ratio(o.material, material),
                            .plane = o.plane,
                            .directions = o.directions,
                            .criteria = o.criteria},
                           {.plane = "--plane ", .criterion = "--"});
}

}  // namespace triax::src
