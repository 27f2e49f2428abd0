#include "src/report/domain_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/records/bad_input.hpp"
#include "sim/stability/domain_run.hpp"
#include "src/report/domain_json.hpp"

namespace triax::src {
namespace {

using Json = nlohmann::ordered_json;

/// A domain of the largest grid is some hundred megabytes.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;

Json column_json(const ReportedColumn& column) {
  Json states = Json::array();
  for (const auto& state : column.states) states.push_back(state_json(state));
  return {{"column", column.column},
          {"p_eff_kPa", column.p_eff_kPa},
          {"compression", boundary_json(column.compression)},
          {"extension", boundary_json(column.extension)},
          {"refusal", column.refusal.empty() ? Json(nullptr) : Json(column.refusal)},
          {"states", std::move(states)}};
}

/// "grid void_ratio is 1.1, in FILE 1": the first setting that differs.
std::string difference(const DomainPiece& a, const DomainPiece& b) {
  const auto first = [&](const char* of, const Json& x, const Json& y) -> std::string {
    for (const auto& [key, value] : x.items()) {
      const auto other = y.find(key);
      if (other != y.end() && *other == value) continue;
      return fmt::format("{} {} is {}, in {} {}", of, key, dumped(value), b.file,
                         other == y.end() ? "missing" : dumped(*other));
    }
    return {};
  };
  const auto &sa = a.domain.settings, &sb = b.domain.settings;
  for (const std::string& found :
       {first("grid", grid_json(sa.grid), grid_json(sb.grid)),
        first("material", material_json(sa.material), material_json(sb.material))})
    if (!found.empty()) return found;
  return "their settings differ";
}

void check_together(const std::vector<DomainPiece>& pieces) {
  const DomainPiece& first = pieces.front();
  std::vector<const DomainPiece*> of(static_cast<std::size_t>(first.count), nullptr);
  for (const DomainPiece& piece : pieces) {
    const auto refuse = [&](const std::string& why) { throw lab::BadInput(piece.file, 0, why); };
    if (piece.count != first.count)
      refuse(fmt::format("is a piece of {}, {} one of {}; pieces of one cut belong together",
                         piece.count, first.file, first.count));
    if (piece.domain.settings != first.domain.settings)
      refuse("is a piece of another domain: " + difference(piece, first));
    if (piece.program != first.program)
      refuse(fmt::format("was written by triax {}, {} by {}; let one version compute all pieces",
                         piece.program, first.file, first.program));
    const DomainPiece*& place = of[static_cast<std::size_t>(piece.index - 1)];
    if (place != nullptr)
      refuse(fmt::format("is piece {} of {} as {} is; give each piece once", piece.index,
                         piece.count, place->file));
    place = &piece;
  }
  const auto missing = std::ranges::find(of, nullptr);
  if (missing == of.end()) return;
  throw lab::BadInput(fmt::format("--merge: piece {} of {} is missing ({} of them are given)",
                                  missing - of.begin() + 1, first.count, pieces.size()));
}

}  // namespace

std::string piece_json(const ReportedDomain& columns, int index, int count) {
  std::string out = fmt::format(
      "{{\n\"format\": \"{}\",\n\"version\": {},\n\"program\": \"" TRIAX_VERSION
      "\",\n\"origin\": \"simulated\",\n\"piece\": {},\n\"material\": {},\n\"grid\": "
      "{},\n\"warnings\": {},\n\"columns\": [",
      kPieceFormat, kPieceVersion, dumped({{"index", index}, {"count", count}}),
      dumped(material_json(columns.settings.material)), dumped(grid_json(columns.settings.grid)),
      dumped(Json(columns.settings.warnings)));
  for (std::size_t i = 0; i < columns.columns.size(); ++i)
    out += (i > 0 ? ",\n" : "\n") + dumped(column_json(columns.columns[i]));
  return out + "\n]\n}\n";
}

DomainPiece load_piece(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))
    throw lab::BadInput(path, 0,
                        "cannot be read; a file that triax domain --piece wrote is wanted");
  if (std::filesystem::file_size(path, none) > kLargestFile)
    throw lab::BadInput(path, 0, "is larger than 1 GB; cut the domain into more pieces");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw lab::BadInput(path, 0, "cannot be read");
  return read_piece(text.view(), path);
}

ReportedDomain merged(std::vector<DomainPiece> pieces) {
  check_together(pieces);
  ReportedDomain whole{.settings = pieces.front().domain.settings};
  for (DomainPiece& piece : pieces)
    std::ranges::move(piece.domain.columns, std::back_inserter(whole.columns));
  std::ranges::sort(whole.columns, {}, &ReportedColumn::column);
  return whole;
}

}  // namespace triax::src
