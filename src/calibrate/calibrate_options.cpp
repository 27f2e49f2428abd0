// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/calibrate_options.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/results/record_header.hpp"
#include "src/cli/shared_options.hpp"

namespace triax::src {

void add_calibrate_options(CLI::App& app, CalibrateOptions& o) {
  app.add_option("LAW", o.law, "constitutive law; listed by triax materials")
      ->required()
      ->type_name("");
  app.add_option("TEST", o.tests, "tests of the database, by number or name [all]")->type_name("");
  add_db(app, o.db);
  app.add_option("--start", o.start,
                 "set to begin with, of the program or of a parameter file, or what triax soil "
                 "measured [the law's first set]")
      ->type_name("LAW/SET|FILE.toml[:SET]");
  app.add_option("--free", o.free, "parameters to search [all with a range]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KEY,...");
  app.add_option("--fix", o.fixed,
                 "parameter to keep, at this value or as the start has it; may be repeated")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KEY[=VALUE]");
  app.add_option("--searches", o.searches, "global searches, each from members of its own")
      ->check(CLI::Range(1, 10000).description(""))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--seed", o.seed, "of the searches; the same seed gives the same result")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{lab::kLargestSeed}).description(""))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--void-ratio-error", o.void_ratio_error,
                 "standard error of each specimen's void ratio, which widens the intervals [0]")
      ->check(CLI::Range(0.0, 0.5).description(""))
      ->type_name("E");
  add_jobs(app, o.jobs, "threads; results do not depend on them", 4096);
  app.add_option("--piece", o.piece,
                 "run every N-th search from the I-th on only, and write what they found to the "
                 "file --output")
      ->type_name("I/N");
  app.add_option("--merge", o.merge, "what these pieces found instead of searching")
      ->type_name("FILE...")
      ->allow_extra_args(false);
  app.add_option("--output", o.output,
                 "write the parameters as a parameter file, which --materials of other commands "
                 "takes; with --piece the file of the piece")
      ->type_name("FILE.toml");
  app.add_option("--figures", o.figures,
                 "write measured and computed curves of all tests into FOLDER, as "
                 "calibrate_undrained, calibrate_drained and calibrate_stress_path, and cones and "
                 "domain of the set as calibrate_domain (.svg, .png, .pdf, .csv, .json)")
      ->type_name("FOLDER");
  add_json(app, o.json);
}

void check_calibrate_options(const CalibrateOptions& o) {
  if (o.piece.empty()) return;
  if (!o.merge.empty())
    throw lab::BadInput(
        "--piece and --merge exclude each other: first run all pieces, then merge them");
  if (o.output.empty())
    throw lab::BadInput("--piece needs --output FILE, where the piece is to be written");
  if (o.json || !o.figures.empty())
    throw lab::BadInput(
        "--piece writes what its searches found to --output only; ask for results with --merge");
}

study::StartWish start_wish(const CalibrateOptions& o) {
  study::StartWish wish{.law = o.law, .start = o.start, .free = o.free, .fixed = {}};
  for (const std::string& text : o.fixed) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
      wish.fixed.emplace_back(text, std::nullopt);
      continue;
    }
    const auto value = lab::whole_text_as<double>(text.substr(equals + 1));
    if (!value)
      throw lab::BadInput(fmt::format("--fix {}: expected KEY=NUMBER or KEY", lab::excerpt(text)));
    wish.fixed.emplace_back(text.substr(0, equals), value);
  }
  return wish;
}

}  // namespace triax::src
