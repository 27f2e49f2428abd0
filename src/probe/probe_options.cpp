// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_options.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/range.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/condition_text.hpp"
#include "src/cli/shared_options.hpp"

namespace triax::src {
namespace {

constexpr double kMinStress_kPa = 1e-3, kMaxStress_kPa = 1e5;
constexpr double kSmallestNorm_kPa = 1e-6, kLargestNorm_kPa = 1e4;
constexpr double kSmallestNormStrain = 1e-10, kLargestNormStrain = 0.1;
constexpr double kSmallestRatio = 0.01, kLargestR = 100;
constexpr double kSmallestStrain = 1e-5, kLargestStrain = 0.5;
constexpr double kSmallestStep_deg = 0.01, kLargestStep_deg = 45;
constexpr double kSmallestSphereStep_deg = 0.5;

void must_lie(const char* option, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest))
    throw lab::BadInput(fmt::format("{} {:g}: out of range; expected a number from {:g} to {:g}",
                                    option, value, lowest, highest));
}

int directions_of(double step_deg) {
  must_lie("--step", step_deg, kSmallestStep_deg, kLargestStep_deg);
  const double whole = std::round(360 / step_deg);
  if (std::abs(whole * step_deg - 360) > 1e-6)
    throw lab::BadInput(
        fmt::format("--step {:g}: not valid; it must divide 360 degrees, for example {:g}",
                    step_deg, 360 / whole));
  return static_cast<int>(whole);
}

/// A dependent option without the one it depends on.
void only_with(bool given, const char* option, bool with, const char* other) {
  if (given && !with) throw lab::BadInput(fmt::format("{} needs {}", option, other));
}

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::vector<double> numbers_of(const std::string& part) {
  if (!lab::looks_like_range(part)) {
    double number = 0;
    if (part.empty() || !CLI::detail::lexical_cast(part, number))
      throw std::invalid_argument(
          lab::excerpt(part) +
          " is not a number; expected numbers separated by commas, or a range "
          "FROM:TO:STEP or FROM:TO/COUNT");
    return {number};
  }
  constexpr std::int64_t kMostNumbers = 10'000;
  const lab::Range range = lab::read_range(part, kMostNumbers);
  std::vector<double> numbers;
  for (std::int64_t i = 0; i < range.count; ++i) numbers.push_back(range.at(i));
  return numbers;
}

/// Numbers or ranges separated by commas, none of them left out: the parser's own delimiter would
/// skip an empty one silently.
void add_numbers(CLI::App& app, const std::string& name, std::vector<double>& numbers,
                 const char* type, const std::string& help) {
  app.add_option_function<std::vector<std::string>>(
         name,
         [&numbers, name](const std::vector<std::string>& texts) {
           for (const auto& text : texts)
             for (const auto& part : parts_of(text)) try {
                 for (const double number : numbers_of(part)) numbers.push_back(number);
               } catch (const std::invalid_argument& error) {
                 throw CLI::ValidationError(name, fmt::format("{}: {}", text, error.what()));
               }
         },
         help)
      ->type_name(type)
      ->allow_extra_args(false);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Two conditions of a path file as a control of rates, on effective stress.
sim::NamedControl control_of_conditions(const std::string& text) {
  const auto parts = parts_of(text);
  if (parts.size() != 2)
    throw lab::BadInput(fmt::format("--conditions {}: expected two conditions separated by a comma",
                                    lab::excerpt(text)));
  sim::NamedControl control{.name = {}, .control = {}};
  for (std::size_t i = 0; i < 2; ++i) try {
      const auto row = static_cast<Eigen::Index>(i);
      const auto condition = lab::read_condition<sim::Axisymmetric>(trimmed(parts[i]));
      control.control.stress.row(row) = condition.left.stress;
      control.control.strain.row(row) = condition.left.strain;
      control.control.increment(row) = condition.total;
      control.conditions.push_back(condition.label);
      control.name +=
          fmt::format("{}{} = {:g}", i > 0 ? ", " : "", condition.label, condition.total);
    } catch (const std::invalid_argument& error) {
      throw lab::BadInput(fmt::format("--conditions {}: {}", lab::excerpt(text), error.what()));
    }
  if (control.control.increment.isZero(0))
    throw lab::BadInput(fmt::format(
        "--conditions {}: one of them must prescribe a value other than 0", lab::excerpt(text)));
  return control;
}

}  // namespace

void add_probe_options(CLI::App& app, ProbeOptions& o) {
  add_material(app, o.material);
  app.add_option("--p-kPa", o.p_kPa,
                 "mean effective stress p' of the state, in kPa, with --eta or --q-kPa")
      ->type_name("KPA");
  add_numbers(app, "--eta", o.eta, "ETA,...",
              "stress ratios q/p', one state each: numbers, FROM:TO:STEP or FROM:TO/COUNT");
  add_numbers(app, "--q-kPa", o.q_kPa, "KPA,...",
              "deviator stresses in kPa instead of --eta, negative in extension");
  add_numbers(app, "--stress-kPa", o.stress_kPa, "S1[,S2],S3",
              "principal effective stresses of the state in kPa, axial stress first");
  app.add_option("--test", o.tests,
                 "use the state of this stored test and also report the increment of the test "
                 "itself (repeatable)")
      ->type_name("TEST")
      ->allow_extra_args(false);
  app.add_option("--at", o.at,
                 "state of --test: at collapse, peak or end, or at reading N [collapse]")
      ->type_name("collapse|peak|end|N");
  add_db(app, o.db);
  app.add_option("--path", o.path,
                 "use the state at the end of this path, with the internal variables of the law")
      ->type_name("PATH.toml");
  app.add_option("--every", o.every, "probe every N-th row of --path and the last row [last row]")
      ->type_name("N");
  app.add_option("--plane", o.plane,
                 "plane of the directions; 3d: all directions of principal increments")
      ->check(CLI::IsMember({"axisymmetric", "plane-strain", "3d"}).description(""))
      ->type_name("axisymmetric|plane-strain|3d")
      ->capture_default_str();
  app.add_flag("--strain", o.strain, "apply strain increments instead of stress increments");
  app.add_option("--norm-kPa", o.norm_kPa, "norm of stress increments, in kPa [1]")
      ->type_name("KPA");
  app.add_option("--norm-strain", o.norm_strain, "norm of strain increments [1e-5]")
      ->type_name("STRAIN");
  app.add_option("--step", o.step_deg,
                 "angle between directions in degrees, refined at edges of cones [10]")
      ->type_name("DEG");
  app.add_flag("--finite", o.finite,
               "integrate every increment instead of scaling the rate of the law");
  app.add_flag("--probes", o.probes, "also print every direction");
  add_numbers(app, "--R", o.R, "R,...",
              "ratios R of the control deps1 + 2R deps3 = 0 [0.1,0.2,...,3]");
  app.add_flag("--control", o.control, "also print controllability over R and for named controls");
  app.add_option("--conditions", o.conditions,
                 "compute the control index for these two conditions on effective stress, written "
                 "as in path files (repeatable)")
      ->type_name("\"COND, COND\"")
      ->allow_extra_args(false);
  add_numbers(app, "--strain-paths", o.strain_paths, "R,...",
              "run proportional strain paths of these R from the isotropic state --p-kPa instead "
              "of probes");
  app.add_option("--axial-strain", o.axial_strain,
                 "axial strain at the end of --strain-paths, as a fraction [0.05]")
      ->type_name("STRAIN");
  app.add_option("--output", o.output,
                 "also write probe.csv, probe.json and the figures (SVG, PNG, PDF) with their data "
                 "to FOLDER")
      ->type_name("FOLDER");
  add_json(app, o.json);
}

study::Probing checked_probing(const ProbeOptions& o) {
  only_with(o.norm_strain.has_value(), "--norm-strain", o.strain, "--strain");
  only_with(o.norm_kPa.has_value(), "--norm-kPa", !o.strain, "stress probes, without --strain");
  for (const double R : o.R) must_lie("--R", R, kSmallestRatio, kLargestR);
  study::Probing probing;
  if (!o.R.empty()) probing.ratios = o.R;
  if (!o.conditions.empty() && o.plane != "axisymmetric")
    throw lab::BadInput("--conditions needs the axisymmetric plane; leave --plane out");
  for (const auto& text : o.conditions) probing.conditions.push_back(control_of_conditions(text));
  probing.plane =
      o.plane == "plane-strain" ? sim::ProbePlane::plane_strain : sim::ProbePlane::axisymmetric;
  probing.kind = o.strain ? sim::ProbeKind::strain : sim::ProbeKind::stress;
  probing.directions = directions_of(o.step_deg.value_or(10));
  probing.finite = o.finite;
  if (o.strain) {
    probing.norm = o.norm_strain.value_or(1e-5);
    must_lie("--norm-strain", probing.norm, kSmallestNormStrain, kLargestNormStrain);
  } else {
    const double norm_kPa = o.norm_kPa.value_or(1);
    must_lie("--norm-kPa", norm_kPa, kSmallestNorm_kPa, kLargestNorm_kPa);
    probing.norm = 1e3 * norm_kPa;
  }
  return probing;
}

study::SphereProbing checked_sphere(const ProbeOptions& o) {
  const study::Probing plane = checked_probing(o);
  // Directions and what is written of them grow with the square: at 0.5 degrees 260,000.
  must_lie("--plane 3d --step", o.step_deg.value_or(10), kSmallestSphereStep_deg, kLargestStep_deg);
  if (o.finite || o.control || o.probes || !o.R.empty() || !o.conditions.empty())
    throw lab::BadInput("--plane 3d excludes --finite, --control, --R, --conditions and --probes");
  if (plane.directions % 2 != 0 || plane.directions < 12)
    throw lab::BadInput(
        fmt::format("--step {:g}: not valid; with --plane 3d it must divide 180 degrees into 6 "
                    "parts or more",
                    o.step_deg.value_or(10)));
  return {.kind = plane.kind, .norm = plane.norm, .rings = plane.directions / 2};
}

void check_strain_path_options(const ProbeOptions& o) {
  if (!o.p_kPa)
    throw lab::BadInput("--strain-paths needs --p-kPa, the isotropic state to start from");
  must_lie("--p-kPa", *o.p_kPa, kMinStress_kPa, kMaxStress_kPa);
  for (const double R : o.strain_paths) must_lie("--strain-paths", R, kSmallestRatio, kLargestR);
  must_lie("--axial-strain", o.axial_strain.value_or(kUsualAxialStrain), kSmallestStrain,
           kLargestStrain);
  if (!o.eta.empty() || !o.q_kPa.empty() || !o.stress_kPa.empty() || !o.tests.empty() ||
      !o.path.empty() || o.strain || o.finite || o.plane != "axisymmetric")
    throw lab::BadInput(
        "--strain-paths starts from the isotropic state --p-kPa in axisymmetry and excludes other "
        "states, planes and probes");
  if (o.probes || o.control || !o.R.empty() || !o.conditions.empty() || o.step_deg || o.norm_kPa ||
      o.norm_strain || o.every || !o.at.empty())
    throw lab::BadInput(
        "--strain-paths makes no probes and excludes --probes, --control, --R, --conditions, "
        "--step, --norm-kPa, --norm-strain, --every and --at");
}

void check_state_options(const ProbeOptions& o) {
  const int sources =
      o.p_kPa.has_value() + !o.stress_kPa.empty() + !o.tests.empty() + !o.path.empty();
  if (sources != 1)
    throw lab::BadInput(fmt::format(
        "{}; give one of --p-kPa (with --eta or --q-kPa), --stress-kPa, --test and --path",
        sources == 0 ? "no state is given" : "more than one kind of state is given"));
  only_with(o.axial_strain.has_value(), "--axial-strain", !o.strain_paths.empty(),
            "--strain-paths");
  only_with(!o.R.empty(), "--R", o.control || o.json || !o.output.empty(),
            "--control, --output or --json");
  only_with(!o.eta.empty(), "--eta", o.p_kPa.has_value(), "--p-kPa");
  only_with(!o.q_kPa.empty(), "--q-kPa", o.p_kPa.has_value(), "--p-kPa");
  only_with(!o.at.empty(), "--at", !o.tests.empty(), "--test");
  only_with(o.every.has_value(), "--every", !o.path.empty(), "--path");
  if (o.p_kPa) {
    must_lie("--p-kPa", *o.p_kPa, kMinStress_kPa, kMaxStress_kPa);
    if (o.eta.empty() == o.q_kPa.empty())
      throw lab::BadInput(o.eta.empty()
                              ? "--p-kPa needs --eta or --q-kPa; --eta 0 is the isotropic state"
                              : "--eta and --q-kPa exclude each other");
    for (const double eta : o.eta) must_lie("--eta", eta, -3, 3);
    for (const double q : o.q_kPa) must_lie("--q-kPa", q, -kMaxStress_kPa, kMaxStress_kPa);
  }
  if (o.stress_kPa.size() == 1 || o.stress_kPa.size() > 3)
    throw lab::BadInput(
        fmt::format("--stress-kPa has {} values; expected S1,S3 or S1,S2,S3", o.stress_kPa.size()));
  for (const double s : o.stress_kPa) must_lie("--stress-kPa", s, -kMaxStress_kPa, kMaxStress_kPa);
  if (o.stress_kPa.size() == 3 && o.stress_kPa[1] != o.stress_kPa[2] && o.plane == "axisymmetric")
    throw lab::BadInput(
        "--stress-kPa: a state in which S2 and S3 differ is not axisymmetric; use --plane "
        "plane-strain");
  if (o.every && *o.every < 1)
    throw lab::BadInput(
        fmt::format("--every {}: out of range; expected a number of rows, 1 or more", *o.every));
}

}  // namespace triax::src
