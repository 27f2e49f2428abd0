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
  app.add_option("TEST", o.choice.tests, "tests, by number or name [all]")->type_name("");
  app.add_option("--where", o.choice.where,
                 "only tests that match this SQL condition on test_id, test, origin, programme, "
                 "status, source, tags, material, void_ratio, p0_eff_kPa, kind, eta, csr, sweep")
      ->type_name("SQL");
  app.add_option("--group", o.choice.group,
                 "estimate for each value of a column of --where, or of an expression")
      ->type_name("COLUMN");
  app.add_option("--criterion", o.criterion,
                 "failure criterion for c' and phi': largest q, largest s1'/s3', strain of "
                 "--failure-strain, or the critical state if it was reached")
      ->type_name("peak-q|peak-ratio|strain|critical-state")
      ->check(CLI::IsMember({"peak-q", "peak-ratio", "strain", "critical-state"}).description(""))
      ->capture_default_str();
  app.add_option("--failure-strain", o.failure_strain_pct,
                 "axial strain of --criterion strain, in percent")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.1, 50.0).description(""))
      ->capture_default_str();
  app.add_option("--exponent", o.exponent,
                 "exponent of the power form of the critical state line [fitted]")
      ->type_name("X")
      ->check(CLI::Range(0.01, 3.0).description(""));
  app.add_option("--stress-error", o.stress_error_kPa,
                 "standard error of q and p' from zero offsets and calibration, in kPa; reduces "
                 "the weight of critical states at small stresses")
      ->type_name("KPA")
      ->check(CLI::Range(0.0, 100.0).description(""))
      ->capture_default_str();
  app.add_flag("--keep-odd", o.keep_odd, "keep outliers in the fits; they are still listed");
  app.add_option("--output", o.output, "write soil.toml and the figures with their data to FOLDER")
      ->type_name("FOLDER");
  add_db(app, o.choice.db);
  add_json(app, o.json);
}

}  // namespace

Command soil_command() {
  return {
      .name = "soil",
      .purpose = "Estimate soil properties from tests",
      .description =
          {"Each test gives its critical state (reached, or extrapolated and marked), phase "
           "transformation, peak, dilatancy at the peak, brittleness and onset of collapse. All "
           "tests together give the critical state line, M in compression and in extension, "
           "friction angles, c' and phi' of the set with Mohr circles, state parameters, stress "
           "ratio at collapse against state, stress-dilatancy, undrained strength and cyclic "
           "resistance, each with a 95 % confidence interval.",
           "A test is an outlier if chance explains its deviation from a fit in only one of a "
           "hundred fits. It is listed with the reason and left out of that fit, unless "
           "--keep-odd is given. A file that was replayed twice counts once. Properties that the "
           "tests cannot determine are listed below the table with the reason.",
           "--output writes soil.toml, from which triax calibrate can start, and each figure as "
           "SVG, PNG and PDF with its data as CSV and JSON."},
      .diagnostics =
          {{"the tests are of N materials: ...",
            "choose one with --where \"material = '...'\", or estimate each with --group material"},
           {"there are only N tests; ...",
            "choose more tests: trends and intervals need at least three"},
           {"SQL: no such column: ...", "use the columns listed in the help of --where"}},
      .examples = {{"triax soil", "estimate from all tests of triax.db"},
                   {"triax soil --where \"material = 'Hostun S28'\" --output hostun",
                    "estimate for one sand and write soil.toml and figures"},
                   {"triax soil 1 2 3 --criterion peak-ratio --json",
                    "estimate from three specimens at the largest stress ratio, as JSON"},
                   {"triax soil --group material", "estimate for each material separately"}},
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
