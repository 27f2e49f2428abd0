// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/element.hpp"

#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/element/figures/path_figure.hpp"
#include "src/element/path_csv.hpp"
#include "src/element/path_json.hpp"
#include "src/element/path_text.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/study/element/run_element.hpp"

namespace triax::src {
namespace {

struct ElementOptions {
  std::string path;
  std::vector<std::string> sets;
  std::string output;
  std::string save_failure;
  std::string format;
  std::string figure;
};

void run_element(const ElementOptions& o) {
  const lab::PathDescription description =
      study::described_path(o.path, key_values(o.sets, "void_ratio=1.086"));
  refuse_overwriting("--output", o.output, description.files, "what the path is read from");
  refuse_overwriting("--save-failure", o.save_failure, description.files,
                     "what the path is read from");
  if (!o.save_failure.empty() && description.material_name.empty())
    throw lab::BadInput(
        "--save-failure: the material of incrementalDriver files has no name that a path file "
        "could "
        "use");
  if (!o.output.empty())
    refuse_overwriting("--save-failure", o.save_failure, {o.output}, "the file of --output");
  const study::PathResult result = study::run_element(description, progress_bars());
  if (!o.save_failure.empty() && !result.failed_increment.empty())
    write_file(o.save_failure, result.failed_increment);
  if (!o.output.empty())
    write_file(o.output, o.output.ends_with(".json") ? path_json(result) : path_csv(result));
  if (!o.figure.empty()) {
    const auto figure = path_figure(result);
    if (!figure.drawing.plot) throw lab::BadInput("--figure: the path has no two rows to draw");
    write_named_figure(figure, o.figure);
  }
  print(o.format == "json"  ? path_json(result)
        : o.format == "csv" ? path_csv(result)
                            : path_text(result));
  if (!result.went_to_the_end()) throw lab::WorkFailed(result.message);
}

}  // namespace

Command element_command() {
  return {
      .name = "element",
      .purpose = "take one material point along a path, without apparatus",
      .description =
          {"PATH is a TOML file: a material, a start, and segments of conditions on stress and "
           "strain increments, any six of them (two in axisymmetry): drained, undrained, constant "
           "p', constant q, proportional strain, free combinations. Integration is "
           "error-controlled; zero of the second-order work, peaks, end conditions and the limit "
           "of control are isolated within the step.",
           "Beyond the limit load the run stops, says which condition cannot be held any longer "
           "and where, and ends with status 1 after it has printed its results. --save-failure "
           "writes the increment that could not be done as a path of its own.",
           "Of what a law remembers, columns memory.NAME, those that end in _root2 hold sqrt(2) "
           "times "
           "the component of the tensor; [start] memory is given in the same measure.",
           "PATH may also be a folder with test.inp, parameters.inp and initialconditions.inp of "
           "Niemunis' incrementalDriver, or the test.inp (of any name that ends in .inp) in it; "
           "--set umat=libNAME.so names the library with its UMAT."},
      .diagnostics =
          {{"control of q_kPa is lost ...",
            "the material cannot carry more: reduce the load, or control a strain instead"},
           {"... is out of range for ...", "the start lies outside what the law can describe"},
           {"the closed cycle of stress ... gives ... more than it takes",
            "bulk and shear modulus that follow p' alone have no energy: --set hyperelastic=1"},
           {"undrained needs one condition on a total stress",
            "the pore pressure would be undetermined: add radial_stress_kPa = 0, say"}},
      .examples =
          {{"triax element samples/paths/icu_100.toml --set void_ratio=1.05 --json",
            "undrained compression of a denser specimen"},
           {"triax element samples/paths/load_beyond_limit.toml --save-failure step.toml",
            "a load that cannot be carried: status 1, and the step as a file"},
           {"triax element FOLDER/test.inp",
            "files of incrementalDriver; the folder alone says the same"},
           {"triax element FOLDER --set umat=libsand.so --set void_ratio_index=7",
            "the same with their UMAT, built as a shared library"},
           {"triax element samples/paths/drained_100.toml --figure drained",
            "the path as figures: drained_path.svg, .png, .pdf"},
           {"triax element path.toml --set material=sanisand/Toyoura-DM04 --output rows.csv",
            "another material, and all rows for a spreadsheet"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ElementOptions>();
        app.add_option("PATH", o->path,
                       "path file (.toml), folder of incrementalDriver files, or its test.inp")
            ->required()
            ->type_name("");
        app.add_option("--set", o->sets,
                       "material, void_ratio, p_eff_kPa, tolerance or a parameter of the law "
                       "instead of the file's; may be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--output", o->output, "also write all rows, as CSV or (.json) as JSON")
            ->type_name("FILE.csv|FILE.json");
        app.add_option("--save-failure", o->save_failure,
                       "write an increment that could not be done as a path of its own")
            ->type_name("FILE.toml");
        app.add_option(
               "--figure", o->figure,
               "draw the path: q, volume and pore pressure over strain, stress path, e over "
               "log p'; PREFIX_path.svg, .png, .pdf and its numbers as .csv and .json")
            ->type_name("PREFIX");
        add_format(app, o->format, {"text", "json", "csv"});
        return [o] { run_element(*o); };
      }};
}

}  // namespace triax::src
