#include "src/commands/grain_outputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "lab/grains/grain_files.hpp"
#include "lab/grains/lammps_export.hpp"
#include "lab/records/bad_input.hpp"
#include "src/output/output.hpp"

namespace triax::src {
namespace {

constexpr const char* kState = ".grains";
constexpr const char* kLammpsData = ".lammps.data";
constexpr const char* kLammpsScript = ".lammps.in";
constexpr const char* kLammpsTable = ".lammps.csv";

bool for_lammps(const lab::GrainStage& stage) {
  const auto* path = std::get_if<lab::GrainPathStage>(&stage.work);
  return path != nullptr && path->lammps;
}

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

GrainOutputs::GrainOutputs(const lab::GrainProgramme& programme, std::string prefix)
    : programme_(programme), prefix_(std::move(prefix)) {
  for (const lab::GrainStage& stage : programme.stages)
    if (prefix_.empty() && (stage.save || for_lammps(stage)))
      throw lab::BadInput(
          programme.source, stage.line,
          fmt::format("stage '{}' writes files: name them by --output PREFIX", stage.name));
}

std::string GrainOutputs::named(const lab::GrainStage& stage, const std::string& ending) const {
  return prefix_ + "_" + lab::in_file_name(stage.name) + ending;
}

std::vector<std::string> GrainOutputs::files() const {
  std::vector<std::string> files;
  for (const lab::GrainStage& stage : programme_.stages) {
    if (stage.save) files.push_back(named(stage, kState));
    if (!for_lammps(stage)) continue;
    files.push_back(named(stage, kLammpsData));
    files.push_back(named(stage, kLammpsScript));
  }
  return files;
}

void GrainOutputs::begins(const lab::GrainStage& stage, const sim::GrainState& state) const {
  if (!for_lammps(stage)) return;
  lab::LammpsOptions options;
  options.title = programme_.name + ", stage " + stage.name;
  options.data_file = without_folder(named(stage, kLammpsData));
  options.table_file = without_folder(named(stage, kLammpsTable));
  const lab::LammpsExport made =
      lab::lammps_export(state, std::get<lab::GrainPathStage>(stage.work).path, options);
  write_file(named(stage, kLammpsData), made.data);
  write_file(named(stage, kLammpsScript), made.script);
}

void GrainOutputs::ends(const lab::GrainStage& stage, const sim::GrainState& state) const {
  if (stage.save) lab::save_state(named(stage, kState), state);
}

}  // namespace triax::src
