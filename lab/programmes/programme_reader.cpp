#include "lab/programmes/programme_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "lab/programmes/stage_reader.hpp"
#include "lab/records/bad_input.hpp"
#include "lab/records/toml_reader.hpp"

namespace triax::lab {
namespace {

constexpr Bounds kPositive{.above = 0};
constexpr Bounds kPressure_kPa{.above = 0, .at_most = kLargestPressure_kPa};
constexpr Bounds kNotNegative{.at_least = 0};

void read_test(const TomlTable& table, Programme& programme) {
  programme.name = table.required_text("name");
  programme.type = table.required_text("type");
  programme.seed = static_cast<std::uint64_t>(table.integer("seed", 0).value_or(1));
  programme.scan_interval_s =
      table.required_number("scan_interval_s", {.at_least = 1e-3, .at_most = 3600});
  table.finish();
}

std::vector<MaterialSet> user_materials(const std::string& name, Programme& programme) {
  const auto path = std::filesystem::path(programme.source).parent_path() / name;
  programme.files.push_back(path.string());
  return read_materials(read_text_file(path.string()), path.string());
}

void read_specimen(const TomlTable& table, Programme& programme) {
  const std::string material = table.required_text("material");
  const auto file = table.text("material_file");
  try {
    programme.material =
        file ? find_material(material, user_materials(*file, programme)) : find_material(material);
  } catch (const BadInput& error) {
    if (file) throw;
    table.fail("material", error.what());
  }
  programme.specimen.height_m =
      1e-3 * table.required_number("height_mm", {.at_least = 5, .at_most = 3000});
  programme.specimen.diameter_m =
      1e-3 * table.required_number("diameter_mm", {.at_least = 5, .at_most = 3000});
  programme.void_ratio = table.required_number("void_ratio", {.at_least = 0.05, .at_most = 20});
  programme.initial_effective_stress_pa =
      1e3 * table.required_number("initial_effective_stress_kPa", {.at_least = 1, .at_most = 1e4});
  programme.specific_gravity = table.number("specific_gravity", {.at_least = 1, .at_most = 10});
  table.finish();
  const auto& law = *programme.material.material.axisymmetric;
  if (const auto objection =
          law.objection(law.isotropic(programme.initial_effective_stress_pa, programme.void_ratio)))
    table.fail("void_ratio", *objection);
}

Transducer read_transducer(const TomlTable& table, Quantity quantity) {
  Transducer t;
  const std::string unit(info(quantity).unit);
  // The load cell is spoken of in newtons, although its column is in kN.
  const bool force = quantity == Quantity::axial_force;
  const std::string spoken = force ? "N" : unit;
  const double scale = force ? 1e-3 : 1;
  t.unit = *sim::find_unit(unit);
  const bool pressure = t.unit.dimension == sim::find_unit("kPa")->dimension;
  const Bounds& range = pressure ? kPressure_kPa : kPositive;
  t.range = scale * table.number("range_" + spoken, range).value_or(0);
  t.step = scale * table.number("resolution_" + spoken, kNotNegative).value_or(0);
  t.noise_rms = scale * table.number("noise_" + spoken, kNotNegative).value_or(0);
  t.offset = scale * table.number("offset_" + spoken).value_or(0);
  const auto bits = table.integer("bits", 4, 32);
  if (bits) {
    if (t.range == 0) table.fail("bits", fmt::format("needs range_{} beside it", spoken));
    if (t.step > 0) table.fail("bits", fmt::format("give either bits or resolution_{}", spoken));
    t.step = converter_step(t.range, static_cast<int>(*bits));
  }
  if (t.range > 0 && t.step > t.range)
    table.fail("resolution_" + spoken, "is coarser than the range");
  table.finish();
  return t;
}

void read_transducers(const std::optional<TomlTable>& table, Programme& programme) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const auto& row = quantities()[i];
    programme.transducers[i].unit = *sim::find_unit(row.unit);
    if (!table) continue;
    if (auto one = table->table(row.name))
      programme.transducers[i] = read_transducer(*one, row.quantity);
  }
  if (table) table->finish();
}

PressureController read_controller(const std::optional<TomlTable>& table) {
  PressureController c{.range_pa = 3e6, .rate_limit_pa_per_s = 10e3};
  if (!table) return c;
  c.range_pa = 1e3 * table->number("range_kPa", kPressure_kPa).value_or(c.range_pa / 1e3);
  c.rate_limit_pa_per_s =
      1e3 / 60 *
      table->number("rate_limit_kPa_per_min", kPositive).value_or(c.rate_limit_pa_per_s * 60 / 1e3);
  table->finish();
  return c;
}

LoadingFrame read_frame(const std::optional<TomlTable>& table) {
  constexpr double kMmPerMin = 1e-3 / 60;
  LoadingFrame f{.slowest_m_per_s = 0.00001 * kMmPerMin,
                 .fastest_m_per_s = 5.99999 * kMmPerMin,
                 .travel_m = 0.05,
                 .servo_gain_m_per_s_per_n = 6 * kMmPerMin};
  if (!table) return f;
  const auto set = [&](const char* key, double scale, double& member) {
    if (const auto value = table->number(key, kPositive)) member = *value * scale;
  };
  set("slowest_mm_per_min", kMmPerMin, f.slowest_m_per_s);
  set("fastest_mm_per_min", kMmPerMin, f.fastest_m_per_s);
  set("travel_mm", 1e-3, f.travel_m);
  set("servo_gain_mm_per_min_per_N", kMmPerMin, f.servo_gain_m_per_s_per_n);
  if (f.slowest_m_per_s > f.fastest_m_per_s)
    table->fail("slowest_mm_per_min", "is above fastest_mm_per_min");
  table->finish();
  return f;
}

void read_rig(const TomlTable& table, Programme& programme) {
  programme.cell_controller = read_controller(table.table("cell_controller"));
  programme.back_controller = read_controller(table.table("back_controller"));
  programme.frame = read_frame(table.table("frame"));
  const double highest =
      std::min(programme.back_controller.range_pa,
               programme.cell_controller.range_pa - programme.initial_effective_stress_pa) /
      1e3;
  programme.initial_back_pressure_pa =
      1e3 * table.required_number("back_pressure_kPa", {.at_least = 0, .at_most = highest});
  if (const auto modulus = table.number("water_bulk_modulus_GPa", kPositive))
    programme.specimen.water_compressibility = 1e-9 / *modulus;
  programme.specimen.system_compliance =
      1e-12 * table.number("system_compliance_mm3_per_kPa", kNotNegative).value_or(0);
  programme.specimen.drainage_resistance =
      1e12 * table.number("drainage_resistance_kPa_s_per_mm3", kNotNegative).value_or(0);
  read_transducers(table.table("transducers"), programme);
  table.finish();
}

}  // namespace

Programme read_programme(std::string_view toml_text, const std::string& file,
                         const std::vector<TomlEdit>& edits) {
  const TomlTable root = TomlTable::parse(toml_text, file, 1, edits);
  Programme programme;
  programme.source = file;
  programme.files = {file};
  const TomlTable test = root.required_table("test");
  const TomlTable specimen = root.required_table("specimen");
  const TomlTable rig = root.required_table("rig");
  const auto stages = root.tables("stages");
  root.finish();
  read_test(test, programme);
  read_specimen(specimen, programme);
  read_rig(rig, programme);
  if (stages.empty()) throw BadInput(file, 0, "no stage is given; write [[stages]]");
  double cell_pa = programme.initial_back_pressure_pa + programme.initial_effective_stress_pa;
  double back_pa = programme.initial_back_pressure_pa;
  for (const TomlTable& stage : stages)
    programme.stages.push_back(read_stage(stage, programme, cell_pa, back_pa));
  return programme;
}

Programme load_programme(const std::string& path) {
  return read_programme(read_text_file(path), path);
}

}  // namespace triax::lab
