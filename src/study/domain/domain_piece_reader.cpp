// SPDX-License-Identifier: GPL-3.0-or-later
// read_piece(): every value is looked at before it is used, since the file may be anyone's.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/path_reader.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "sim/stability/domain_run.hpp"
#include "src/study/document_part.hpp"
#include "src/study/domain/domain_json.hpp"
#include "src/study/domain/domain_piece.hpp"

namespace triax::study {
namespace {

using Json = nlohmann::ordered_json;
using Part = DocumentPart;

constexpr double kMaxStress_kPa = 1e5, kMinStress_kPa = 1e-3;
constexpr int kMostLines = 10000, kMostStates = 4000000, kMostDirections = 36000;

int count(const Part& part, const char* key, int lowest, int highest) {
  return static_cast<int>(part.whole(key, lowest, highest));
}

DomainSettings::Material read_material(const Part& part) {
  DomainSettings::Material m{part.text("name"),
                             part.text("law"),
                             part.text("based_on"),
                             part.text("description"),
                             part.text("source"),
                             part.text("range"),
                             {},
                             {}};
  const Part parameters = part.part("parameters");
  for (const auto& [key, value] : part["parameters"].items())
    m.parameters.emplace_back(key, parameters.text(key.c_str()));
  const Part files = part.part("files");
  for (const auto& [key, value] : part["files"].items())
    m.files.emplace_back(key, files.text(key.c_str()));
  return m;
}

DomainSettings::Grid read_grid(const Part& part, const std::string& file) {
  DomainSettings::Grid g{.p_from_kPa = part.number("p_from_kPa"),
                         .p_to_kPa = part.number("p_to_kPa"),
                         .q_from_kPa = part.number("q_from_kPa"),
                         .q_to_kPa = part.number("q_to_kPa"),
                         .columns = count(part, "columns", 1, kMostLines),
                         .rows = count(part, "rows", 1, kMostLines),
                         .void_ratio = part.number("void_ratio"),
                         .plane = part.text("plane"),
                         .directions = count(part, "directions", 8, kMostDirections),
                         .criteria = {}};
  for (const auto& kind : sim::domain_criterion_kinds())
    if (const std::string name(kind.name); part.flag(name.c_str())) g.criteria.push_back(name);
  check_grid(g, file + ": grid");
  return g;
}

std::optional<DomainMark> read_mark(const Part& boundary, const char* key) {
  if (boundary[key].is_null()) return std::nullopt;
  const Part part = boundary.part(key);
  return DomainMark{part.number("q_kPa"), part.number("eta"), part.known("alpha_deg")};
}

ReportedBoundary read_boundary(const Part& part) {
  ReportedBoundary boundary;
  for (const std::string& key : boundary_keys())
    boundary.set_mark(key, read_mark(part, key.c_str()));
  return boundary;
}

sim::DomainStateKind read_kind(const Part& part) {
  const std::string word = part.text("kind");
  for (const auto kind : sim::kDomainStateKinds)
    if (word == word_of(kind)) return kind;
  part.fail(fmt::format("{} is not a kind of state", lab::excerpt(word)));
}

ReportedDomainState read_state(const Part& part, double q_kPa, int directions) {
  ReportedDomainState state{.q_kPa = part.number("q_kPa"),
                            .kind = read_kind(part),
                            .least_work = part.known("w2_normalised_least"),
                            .least_angle_deg = part.known("alpha_deg"),
                            .refused_directions = count(part, "refused_directions", 0, directions)};
  if (state.q_kPa != q_kPa) part.fail(fmt::format("q_kPa must be {}, as in the grid", q_kPa));
  for (const Json& cone : part.array("cones")) {
    const Part sector = part.in(cone, "cones");
    state.cones_deg.emplace_back(sector.number("from_deg", 0, 720),
                                 sector.number("to_deg", 0, 720));
  }
  return state;
}

ReportedColumn read_column(const Part& part, const sim::DomainGrid& grid, int column) {
  ReportedColumn out{.column = column,
                     .p_eff_kPa = part.number("p_eff_kPa"),
                     .compression = read_boundary(part.part("compression")),
                     .extension = read_boundary(part.part("extension")),
                     .refusal = part.text("refusal")};
  if (part.whole("column", 0, grid.columns - 1) != column)
    part.fail(fmt::format("column must be {}, as in the piece", column));
  if (out.p_eff_kPa != grid.p(column) / 1e3)
    part.fail(fmt::format("p_eff_kPa must be {}, as in the grid", grid.p(column) / 1e3));
  const Json& states = part.array("states");
  if (states.size() != static_cast<std::size_t>(grid.rows))
    part.fail(fmt::format("has {} states, the grid {} rows", states.size(), grid.rows));
  for (int row = 0; row < grid.rows; ++row)
    out.states.push_back(
        read_state(part.in(states[static_cast<std::size_t>(row)], fmt::format("states[{}]", row)),
                   grid.q(row) / 1e3, grid.directions));
  return out;
}

}  // namespace

void check_grid(const DomainSettings::Grid& g, const std::string& subject) {
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) throw lab::BadInput(fmt::format("{}: {}", subject, what));
  };
  require(g.columns >= 1 && g.columns <= kMostLines && g.rows >= 1 && g.rows <= kMostLines &&
              g.columns * static_cast<double>(g.rows) <= kMostStates,
          fmt::format("{} x {} states; 1 to {} each way and at most {} in all are possible",
                      g.columns, g.rows, kMostLines, kMostStates));
  require(g.p_from_kPa >= kMinStress_kPa && g.p_to_kPa <= kMaxStress_kPa &&
              (g.p_from_kPa < g.p_to_kPa || (g.columns == 1 && g.p_from_kPa == g.p_to_kPa)),
          fmt::format("p' from {:g} to {:g} kPa; must increase, within {:g} to {:g} kPa",
                      g.p_from_kPa, g.p_to_kPa, kMinStress_kPa, kMaxStress_kPa));
  require(std::abs(g.q_from_kPa) <= kMaxStress_kPa && std::abs(g.q_to_kPa) <= kMaxStress_kPa &&
              (g.q_from_kPa < g.q_to_kPa || (g.rows == 1 && g.q_from_kPa == g.q_to_kPa)),
          fmt::format("q from {:g} to {:g} kPa; must increase, within {:g} to {:g} kPa",
                      g.q_from_kPa, g.q_to_kPa, -kMaxStress_kPa, kMaxStress_kPa));
  require(g.void_ratio >= lab::kSmallestVoidRatio && g.void_ratio <= lab::kLargestVoidRatio,
          fmt::format("void ratio {:g}; must be {:g} to {:g}", g.void_ratio,
                      lab::kSmallestVoidRatio, lab::kLargestVoidRatio));
  require(g.plane == "axisymmetric" || g.plane == "plane-strain",
          lab::excerpt(g.plane) + " is not a plane; expected axisymmetric or plane-strain");
  require(g.directions >= 8 && g.directions <= kMostDirections,
          fmt::format("{} directions; must be 8 to {}", g.directions, kMostDirections));
}

DomainPiece read_piece(std::string_view text, const std::string& file) {
  const Json document = parsed_document(
      text, file, kPieceFormat,
      "is not a piece of a domain; triax domain --piece I/N --output FILE writes one");
  const Part root(document, file);
  require_version(root, kPieceVersion);
  DomainPiece piece{.file = file, .program = root.text("program")};
  const Part of = root.part("piece");
  piece.count = count(of, "count", 1, kMostLines);
  piece.index = count(of, "index", 1, piece.count);
  DomainSettings& settings = piece.domain.settings;
  settings.material = read_material(root.part("material"));
  settings.grid = read_grid(root.part("grid"), file);
  for (const Json& warning : root.array("warnings")) {
    if (!warning.is_string()) root.fail("warnings must be texts");
    settings.warnings.push_back(warning.get<std::string>());
  }
  const sim::DomainGrid grid = domain_grid(settings.grid);
  const std::vector<int> columns = sim::columns_of_piece(grid, piece.index, piece.count);
  const Json& found = root.array("columns");
  if (found.size() != columns.size())
    root.fail(fmt::format("has {} columns, piece {} of {} of this grid {}", found.size(),
                          piece.index, piece.count, columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    piece.domain.columns.push_back(
        read_column(root.in(found[i], fmt::format("columns[{}]", i)), grid, columns[i]));
  return piece;
}

}  // namespace triax::study
