// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/output.hpp"
#include "src/soil/soil_files.hpp"
#include "src/soil/soil_text.hpp"
#include "src/study/soil/soil_choice.hpp"
#include "src/study/soil/soil_json.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

struct SoilCommandOptions {
  study::SoilChoice choice;
  std::string criterion = "peak-q";
  double failure_strain_pct = 15, exponent = 0, stress_error_kPa = 1;
  bool has_exponent = false, keep_odd = false, json = false;
  std::string output;
};

study::SoilOptions study_options(const SoilCommandOptions& o) {
  study::SoilOptions options;
  options.criterion = study::failure_criterion(o.criterion);
  options.failure_strain = o.failure_strain_pct / 100;
  if (o.has_exponent) options.exponent = o.exponent;
  options.stress_error_kPa = o.stress_error_kPa;
  options.keep_odd = o.keep_odd;
  return options;
}

std::string text_of(const std::vector<study::Soil>& soils) {
  std::string out;
  for (const auto& soil : soils) out += (out.empty() ? "" : "\n") + soil_text(soil);
  return out;
}

void run(const SoilCommandOptions& o) {
  if (!o.output.empty()) check_folder("--output", o.output, {});
  tell_of_gaps(o.choice.db);
  const auto soils = study::study_soils(o.choice, study_options(o));
  if (!o.output.empty()) {
    make_folder("--output", o.output);
    write_soil_files(soils, o.output);
  }
  print(o.json ? study::json_of_soils(soils) : text_of(soils));
}

void add_options(CLI::App& app, SoilCommandOptions& o) {
  app.add_option("TEST", o.choice.tests, "numbers or names of tests; all if none is given")
      ->type_name("");
  app.add_option(
         "--where", o.choice.where,
         "only tests for which this is true: a condition of SQL on test_id, test, origin, "
         "programme, status, source, tags, material, void_ratio, p0_eff_kPa, kind, eta, csr, "
         "sweep")
      ->type_name("SQL");
  app.add_option("--group", o.choice.group,
                 "a result for each value of one of these columns, or of an expression of them")
      ->type_name("COLUMN");
  app.add_option(
         "--criterion", o.criterion,
         "when a specimen counts as failed for c' and phi': at the largest q, at the "
         "largest s1'/s3', at --failure-strain, or at the critical state where it was reached")
      ->type_name("peak-q|peak-ratio|strain|critical-state")
      ->check(CLI::IsMember({"peak-q", "peak-ratio", "strain", "critical-state"}).description(""))
      ->capture_default_str();
  app.add_option("--failure-strain", o.failure_strain_pct, "axial strain of --criterion strain")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.1, 50.0).description(""))
      ->capture_default_str();
  app.add_option("--exponent", o.exponent,
                 "holds the exponent of the power form of the critical state line; otherwise it is "
                 "fitted")
      ->type_name("X")
      ->check(CLI::Range(0.01, 3.0).description(""));
  app.add_option(
         "--stress-error", o.stress_error_kPa,
         "standard error of q and p' by zeros and calibrations, which the readings of a test "
         "do not show; critical states at small stresses weigh by it")
      ->type_name("kPa")
      ->check(CLI::Range(0.0, 100.0).description(""))
      ->capture_default_str();
  app.add_flag("--keep-odd", o.keep_odd,
               "tests that do not fit the others stay in, named all the same");
  app.add_option("--output", o.output, "folder for soil.toml and the figures with their numbers")
      ->type_name("FOLDER");
  add_db(app, o.choice.db);
  add_json(app, o.json);
}

}  // namespace

Command soil_command() {
  return {
      .name = "soil",
      .purpose =
          "what many tests say of one soil: critical state, strength, collapse, with intervals",
      .description =
          {"From each test: critical state (reached, or extrapolated and marked), phase "
           "transformation, peak, dilatancy at the peak, brittleness, onset of collapse. From all "
           "of "
           "them: critical state line, M in compression and in extension, friction angles, c' and "
           "phi' of the set with Mohr circles, state parameters, stress ratio at collapse over "
           "state, "
           "stress-dilatancy, undrained strength and cyclic resistance, each with the interval "
           "that "
           "holds the truth with 95 %.",
           "A test that lies where chance puts one fit of a hundred is named with the reason and "
           "left "
           "out of that fit, unless --keep-odd is given. A file that was read twice counts once. "
           "What the tests do not give is said under the table, with what is missing.",
           "--output writes soil.toml, from which parameters are calibrated, and each figure as "
           "SVG, "
           "PNG and PDF with its numbers as CSV and JSON."},
      .diagnostics =
          {{"the tests are of N materials: ...",
            "choose one with --where \"material = '...'\", or --group material for a result each"},
           {"there are only N tests ...", "choose more tests: trends and intervals need three"},
           {"SQL: no such column: ...", "the help of --where lists the columns"}},
      .examples = {{"triax soil", "all tests of triax.db, as text"},
                   {"triax soil --where \"material = 'Hostun S28'\" --output hostun",
                    "one sand, with soil.toml and figures"},
                   {"triax soil 1 2 3 --criterion peak-ratio --json",
                    "a set of three specimens at the largest stress ratio, as JSON"},
                   {"triax soil --group material", "a result for each material"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<SoilCommandOptions>();
        add_options(app, *o);
        return [o, &app] {
          o->has_exponent = app.count("--exponent") > 0;
          run(*o);
        };
      }};
}

}  // namespace triax::src
