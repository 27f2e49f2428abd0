// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_piece.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/study/domain/domain_json.hpp"
#include "src/study/pieces.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

std::string piece_json(const ReportedDomain& columns, int index, int count) {
  std::string out = fmt::format(
      "{{\n\"format\": \"{}\",\n\"version\": {},\n\"program\": \"{}\",\n\"origin\": "
      "\"simulated\",\n\"piece\": {},\n\"material\": {},\n\"grid\": "
      "{},\n\"warnings\": {},\n\"columns\": [",
      kPieceFormat, kPieceVersion, version(), dumped({{"index", index}, {"count", count}}),
      dumped(material_json(columns.settings.material)), dumped(grid_json(columns.settings.grid)),
      dumped(Json(columns.settings.warnings)));
  for (std::size_t i = 0; i < columns.columns.size(); ++i)
    out += (i > 0 ? ",\n" : "\n") + dumped(column_json(columns.columns[i]));
  return sealed(out + "\n]\n}\n");
}

DomainPiece load_piece(const std::string& path) {
  const std::string text = piece_text(path, "triax domain --piece", "domain");
  DomainPiece piece = read_piece(text, path);
  check_seal(text, path);
  return piece;
}

ReportedDomain merged(std::vector<DomainPiece> pieces) {
  std::vector<PieceName> names;
  for (const DomainPiece& p : pieces) names.push_back({p.file, p.program, p.index, p.count});
  check_together(names, "domain", [&](std::size_t k) {
    return pieces[k].domain.settings == pieces.front().domain.settings
               ? std::string()
               : difference(pieces[k], pieces.front());
  });
  ReportedDomain whole{.settings = pieces.front().domain.settings};
  for (DomainPiece& piece : pieces)
    std::ranges::move(piece.domain.columns, std::back_inserter(whole.columns));
  std::ranges::sort(whole.columns, {}, &ReportedColumn::column);
  return whole;
}

}  // namespace triax::study
