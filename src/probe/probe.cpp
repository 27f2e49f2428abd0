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
    refuse_overwriting("--output", prefix + ending, files_read(o), "what the state is read from");
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
      .purpose = "second-order work of a state in every direction: cones of unstable directions",
      .description =
          {"Takes one state of a law, applies small increments in every direction of a plane and "
           "says in which of them second-order work is negative: the cones of unstable "
           "directions, with edges isolated between the steps. Angles are measured from the axis "
           "of "
           "sqrt2 dsigma3 towards that of dsigma1 (Rendulic plane); isotropic unloading, the "
           "increment of an "
           "undrained test at its peak of q, is at 215.26 degrees.",
           "The state is given by --p-kPa with --eta or --q-kPa, or by --stress-kPa; then the law "
           "has no "
           "memory of a reversal of shear. With --test it is that of a reading of a test in the "
           "database, also without memory, and the direction of the test itself is given beside "
           "the cones. With --path the law is driven along a path first, and "
           "remembers it.",
           "Controllability is reported too: the ratios R for which deps1 + 2R deps3 = 0 cannot be "
           "held "
           "while dsigma1 - dsigma3/R grows, the index of usual programmes, the roots of Eq. (34) "
           "of "
           "the paper. --strain-paths runs such paths from the isotropic state --p-kPa instead and "
           "gives "
           "their peaks.",
           "All of it is computed from the law and called simulated."},
      .diagnostics = {{"... is out of range for ...",
                       "the state lies beyond the law's limit surface or void ratios"},
                      {"test ... has no collapse: ...", "name another reading by --at"},
                      {"test ... does not know its void ratio ...",
                       "the record does not hold it: give it"}},
      .examples =
          {{"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.60 --void-ratio 1.086 "
            "--json",
            "cones of one state as a document"},
           {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.65 --void-ratio 1.086 "
            "--conditions \"q_kPa = 1, axial_strain + 2*radial_strain = 0\"",
            "Nova's index of any pair of conditions, here of an undrained test by load"},
           {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.5,0.6,0.7 --void-ratio "
            "1.086 "
            "--step 1 --output loose",
            "several states in one table and one circular diagram, loose_circular.svg"},
           {"triax probe --test 26 --at collapse --material inl2/S28-general",
            "a test's own increment at collapse beside the cone of the law"},
           {"triax probe --path samples/paths/icu_100.toml --every 10",
            "cones along a path: the first unstable direction, and how they open"},
           {"triax probe --material sanisand/S28-general --stress-kPa 110,80,50 --void-ratio 1.0 "
            "--plane plane-strain --probes",
            "plane strain, every direction printed"},
           {"triax probe --material inl2/S28-general --p-kPa 70 --eta 0.6 --void-ratio 1.086 "
            "--plane "
            "3d "
            "--step 5 --output sphere",
            "all directions of principal increments, with a map of them"},
           {"triax probe --material inl2/S28-general --p-kPa 100 --void-ratio 1.086 --strain-paths "
            "0.7,0.8,0.9,1.0 --output fig16",
            "proportional strain paths, with fig16.svg, .png, .pdf, .csv and .json"},
           {"triax probe --material hypoplastic/S28-MT --p-kPa 70 --eta 0.6 --void-ratio 1.0 "
            "--finite --norm-kPa 0.5 --output probes",
            "increments of 0.5 kPa integrated; probes.csv, probes.json and figures with their data "
            "beside them"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ProbeOptions>();
        add_probe_options(app, *o);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src
