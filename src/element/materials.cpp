// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/materials.hpp"

#include <memory>

#include "lab/base/toml_reader.hpp"
#include "lab/materials/material_library.hpp"
#include "src/cli/shared_options.hpp"
#include "src/element/material_report.hpp"
#include "src/output/output.hpp"

namespace triax::src {
namespace {

struct MaterialsOptions {
  std::string name;
  std::string file;
  bool json = false;
};

void run_materials(const MaterialsOptions& o) {
  const auto sets = o.file.empty() ? lab::shipped_materials()
                                   : lab::read_materials(lab::read_text_file(o.file), o.file);
  if (o.name.empty()) return print(o.json ? materials_json(sets) : materials_text(sets));
  if (const auto* law = sim::find_law(o.name))
    return print(o.json ? law_json(*law) : law_text(*law));
  const auto set = lab::find_material(o.name, sets);
  print(o.json ? material_json(set) : material_text(set));
}

}  // namespace

Command materials_command() {
  return {.name = "materials",
          .purpose = "list laws and parameter sets, or show the parameters of one",
          .description = {"Without NAME all laws with their parameter sets: what they describe, in "
                          "which range, and where the numbers come from. With a set, LAW/SET, its "
                          "parameters with symbol, value, unit, range and meaning; with a law, the "
                          "same without values."},
          .diagnostics = {{"unknown material 'LAW/SET'; ...",
                           "the nearest name, and all that are known"}},
          .examples = {{"triax materials", "all laws and sets"},
                       {"triax materials sanisand/S28-general", "the parameters of one set"},
                       {"triax materials --materials my_sand.toml", "your own sets"}},
          .set_up = [](CLI::App& app) -> std::function<void()> {
            const auto o = std::make_shared<MaterialsOptions>();
            app.add_option("NAME", o->name, "set LAW/SET, or law")->type_name("");
            app.add_option("--materials", o->file, "sets of this file instead of the shipped ones")
                ->type_name("FILE.toml");
            add_json(app, o->json);
            return [o] { run_materials(*o); };
          }};
}

}  // namespace triax::src
