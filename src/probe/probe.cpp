// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe.hpp"

#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/probe/probe_data.hpp"
#include "src/probe/probe_figures.hpp"
#include "src/probe/probe_json.hpp"
#include "src/probe/probe_request.hpp"
#include "src/probe/probe_text.hpp"
#include "src/probe/sphere_figures.hpp"
#include "src/probe/sphere_json.hpp"
#include "src/probe/sphere_text.hpp"
#include "src/probe/strain_paths_figures.hpp"
#include "src/probe/strain_paths_json.hpp"
#include "src/probe/strain_paths_text.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

void keep_what_is_read(const ProbeOptions& o, const std::string& prefix) {
  for (const char* ending : {".csv", ".json", ".svg", ".png", ".pdf"})
    refuse_overwriting("--output", prefix + ending, files_read(o), "a file of the state");
}

/// The document, the table of all probes, and each figure with its data; nothing is written before
/// it is known that none of it would replace what was read.
void write_files(const ProbeOptions& o, const study::ProbeResult& result) {
  const auto figures = probe_figures(result);
  std::vector<std::string> prefixes = {o.prefix()};
  for (const auto& figure : figures) prefixes.push_back(o.prefix() + '_' + figure.name);
  for (const auto& prefix : prefixes) keep_what_is_read(o, prefix);
  make_folder("--output", o.output);
  write_file(o.prefix() + ".json", probe_json(result));
  write_file(o.prefix() + ".csv", to_csv(probes_data(result)));
  for (const auto& figure : figures) write_named_figure(figure, o.prefix());
}

void run_strain_paths(const ProbeOptions& o) {
  const auto result = study::strain_paths(strain_paths_request(o));
  if (!o.output.empty()) {
    keep_what_is_read(o, o.prefix());
    make_folder("--output", o.output);
    write_figure(strain_paths_drawing(result), o.prefix());
    write_file(o.prefix() + ".csv", to_csv(strain_paths_data(result)));
    write_file(o.prefix() + ".json", strain_paths_json(result));
  }
  print(o.json ? strain_paths_json(result) : strain_paths_text(result));
}

void run_sphere(const ProbeOptions& o) {
  const auto result = study::run_sphere(sphere_request(o), progress_bars());
  if (!o.output.empty()) {
    keep_what_is_read(o, o.prefix());
    make_folder("--output", o.output);
    write_file(o.prefix() + ".json", sphere_json(result));
    write_file(o.prefix() + ".csv", to_csv(sphere_data(result)));
    if (const Drawing drawing = sphere_drawing(result); drawing.plot)
      write_figure(drawing, o.prefix());
  }
  print(o.json ? sphere_json(result) : sphere_text(result));
  if (!result.any_answer()) throw lab::WorkFailed("the law gives no result in any direction");
}

void run_probe(const ProbeOptions& o) {
  if (!o.tests.empty()) tell_of_gaps(o.db);
  const auto result = study::run_probe(probe_request(o), progress_bars());
  if (!o.output.empty()) write_files(o, result);
  print(o.json ? probe_json(result)
               : probe_text(result, {.probes = o.probes, .control = o.control}));
  if (!result.any_answer())
    throw lab::WorkFailed("the law gives no result in any direction" +
                          (result.states.empty() || result.states.front().refusal.empty()
                               ? ""
                               : ": " + result.states.front().refusal));
}

void run(const ProbeOptions& o) {
  check_folder("--output", o.output, files_of_prefix(o.prefix()));
  if (!o.strain_paths.empty()) return run_strain_paths(o);
  if (o.plane == "3d") return run_sphere(o);
  run_probe(o);
}

}  // namespace

Command probe_command() {
  return {
      .name = "probe",
      .purpose = "Probe a state in all directions for negative second-order work",
      .description =
          {"Applies small increments in every direction of a plane to one state of a law and "
           "reports the directions with negative second-order work: the cones of unstable "
           "directions, with their edges located between the steps. Angles are measured from the "
           "axis of sqrt2 dsigma3 towards the axis of dsigma1 (Rendulic plane). Isotropic "
           "unloading, the increment of an undrained test at its peak of q, is at 215.26 degrees.",
           "--p-kPa with --eta or --q-kPa, or --stress-kPa, gives the state; the law then has no "
           "memory of a reversal of shear. --test takes the state of a reading of a stored test, "
           "also without memory, and its own direction is reported next to the "
           "cones. --path drives the law along a path first, and the memory of that path is kept.",
           "Controllability is reported too: the ratios R for which deps1 + 2R deps3 = 0 cannot be "
           "maintained while dsigma1 - dsigma3/R grows, the index of common programmes, and the "
           "roots of Eq. (34) of the paper. --strain-paths runs such paths from the isotropic "
           "state --p-kPa instead and reports their peaks.",
           "All results are computed from the law and are marked as simulated."},
      .diagnostics = {{"... is out of range for ...",
                       "choose a state within the limit surface and the void ratios of the law"},
                      {"test ... has no collapse: ...", "choose another reading with --at"},
                      {"test ... has no void ratio at reading ...",
                       "give --void-ratio: the record lacks it"}},
      .examples = {{"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.60 --void-ratio "
                    "1.086 --json",
                    "print the cones of one state as a JSON document"},
                   {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.65 --void-ratio "
                    "1.086 --conditions \"q_kPa = 1, axial_strain + 2*radial_strain = 0\"",
                    "compute Nova's index of a pair of conditions, here of a load-controlled "
                    "undrained test"},
                   {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.5,0.6,0.7 "
                    "--void-ratio 1.086 --step 1 --output loose",
                    "compare several states in one table and one circular diagram"},
                   {"triax probe --test 26 --at collapse --material inl2/S28-general",
                    "compare the increment of a test at collapse with the cone of the law"},
                   {"triax probe --path samples/paths/icu_100.toml --every 10",
                    "follow the cones along a path from the first unstable direction"},
                   {"triax probe --material sanisand/S28-general --stress-kPa 110,80,50 "
                    "--void-ratio 1.0 --plane plane-strain --probes",
                    "print every direction in plane strain"},
                   {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.6 --void-ratio "
                    "1.086 --plane 3d --step 5 --output sphere",
                    "probe all directions of principal increments and draw a map of them"},
                   {"triax probe --material inl2/S28-general --p-kPa 100 --void-ratio 1.086 "
                    "--strain-paths 0.7,0.8,0.9,1.0 --output fig16",
                    "run proportional strain paths and write figures and data to folder fig16"},
                   {"triax probe --material hypoplastic/S28-MT --p-kPa 70 --eta 0.6 --void-ratio "
                    "1.0 --finite --norm-kPa 0.5 --output probes",
                    "integrate increments of 0.5 kPa; write the results, figures and data to "
                    "folder probes"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ProbeOptions>();
        add_probe_options(app, *o);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src
