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
  app.add_option("LAW", o.law, "constitutive law, as listed by triax materials")
      ->required()
      ->type_name("");
  app.add_option("TEST", o.tests, "tests, by number or name [all]")->type_name("");
  add_db(app, o.db);
  app.add_option("--start", o.start,
                 "start from a shipped set, from a set of a parameter file, or from soil.toml of "
                 "triax soil [first set of the law]")
      ->type_name("LAW/SET|FILE.toml[:SET]");
  app.add_option("--free", o.free, "parameters to calibrate [all with a search range]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KEY,...");
  app.add_option("--fix", o.fixed, "parameter to keep at VALUE, or at its start value (repeatable)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KEY[=VALUE]");
  app.add_option("--searches", o.searches, "number of independent global searches")
      ->check(CLI::Range(1, 10000).description(""))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--seed", o.seed, "seed of the searches; the same seed gives the same results")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{lab::kMaxSeed}).description(""))
      ->capture_default_str()
      ->type_name("N");
  app.add_option(
         "--void-ratio-error", o.void_ratio_error,
         "standard error of the void ratio of each specimen, which widens the intervals [0]")
      ->check(CLI::Range(0.0, 0.5).description(""))
      ->type_name("E");
  add_jobs(app, o.jobs, "number of threads, without effect on the results", 4096);
  app.add_option("--piece", o.piece,
                 "run only searches I, I+N, I+2N, ... and write them to the file --output")
      ->type_name("I/N");
  app.add_option("--merge", o.merge,
                 "use the searches of this piece instead of searching (repeatable)")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--output", o.output,
                 "write the parameters as a parameter file for --materials; with --piece, the file "
                 "of the piece")
      ->type_name("FILE.toml");
  app.add_option("--figures", o.figures,
                 "write measured and computed curves of all tests (calibrate_undrained, "
                 "calibrate_drained, calibrate_stress_path) and cones and domain of the set "
                 "(calibrate_domain) as .svg, .png, .pdf, .csv and .json to FOLDER")
      ->type_name("FOLDER");
  add_json(app, o.json);
}

void check_calibrate_options(const CalibrateOptions& o) {
  if (o.piece.empty()) return;
  if (!o.merge.empty())
    throw lab::BadInput(
        "--piece and --merge exclude each other: first run all pieces, then merge them");
  if (o.output.empty()) throw lab::BadInput("--piece needs --output FILE");
  if (o.json || !o.figures.empty())
    throw lab::BadInput("--piece writes to --output only; use --merge for results");
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
