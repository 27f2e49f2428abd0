// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration_piece.hpp"

#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/byte_source.hpp"
#include "lab/base/digest.hpp"
#include "src/study/document_part.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/pieces.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

constexpr const char* kFormat = "triax calibration piece";
constexpr int kFormatVersion = 1;
constexpr int kMostPieces = 1000000;

Json path_json(const MeasuredPath& path) {
  Json knots = Json::array();
  for (const auto& k : path.knots)
    knots.push_back({k.axial_strain, k.volumetric_strain, k.p_eff, k.q, k.weight});
  return {{"name", path.name},
          {"imposed", to_string(path.imposed)},
          {"void_ratio", path.void_ratio},
          {"start", {path.start.p_eff, path.start.q}},
          {"scale", path.scale},
          {"knots", std::move(knots)}};
}

/// All that the searches depend on.
std::string settings_of(const CalibrationRequest& request) {
  Json ranges = Json::array(), paths = Json::array();
  for (const auto& r : request.free)
    ranges.push_back(
        {r.key, r.low, r.high, r.prior ? r.prior->value : 0.0, r.prior ? r.prior->error : 0.0});
  for (const auto& path : request.paths) paths.push_back(path_json(path));
  const auto& set = request.start.parameters;
  const Json all = {{"law", request.start.law->name},
                    {"numbers", set.numbers},
                    {"texts", set.texts},
                    {"lists", set.lists},
                    {"ranges", ranges},
                    {"searches", request.searches},
                    {"seed", request.seed},
                    {"paths", paths}};
  return lab::sha256(*lab::open_memory("settings", all.dump()));
}

struct CalibrationPiece {
  PieceName name;
  std::string settings;
  std::vector<SearchEnd> ends;
};

SearchEnd read_end(const DocumentPart& part, std::size_t unknowns) {
  SearchEnd end{.number = static_cast<int>(part.whole("number", 1, kMostPieces)),
                .optima = {},
                .runs = part.whole("runs", 0, std::int64_t{1} << 50)};
  for (const Json& one : part.array("optima")) {
    const DocumentPart at = part.in(one, "optimum");
    Optimum optimum{.values = {}, .cost = at.number("cost", 0, 1e300)};
    for (const Json& value : at.array("values")) {
      if (!value.is_number()) at.fail("values must be numbers");
      optimum.values.push_back(value.get<double>());
    }
    if (optimum.values.size() != unknowns) at.fail("has not one value for each free parameter");
    end.optima.push_back(std::move(optimum));
  }
  return end;
}

CalibrationPiece load(const std::string& file, std::size_t unknowns) {
  const std::string text = piece_text(file, "triax calibrate --piece", "calibration");
  const Json document = parsed_document(
      text, file, kFormat,
      "is not a piece of a calibration; triax calibrate --piece I/N --output FILE writes one");
  const DocumentPart root(document, file);
  require_version(root, kFormatVersion);
  check_seal(text, file);
  const DocumentPart piece = root.part("piece");
  CalibrationPiece found{.name = {.file = file, .program = root.text("program")},
                         .settings = root.text("settings"),
                         .ends = {}};
  found.name.count = static_cast<int>(piece.whole("count", 1, kMostPieces));
  found.name.index = static_cast<int>(piece.whole("index", 1, found.name.count));
  for (const Json& one : root.array("searches"))
    found.ends.push_back(read_end(root.in(one, "search"), unknowns));
  return found;
}

}  // namespace

std::string calibration_piece_json(const CalibrationRequest& request,
                                   const std::vector<SearchEnd>& ends, int index, int count) {
  Json searches = Json::array();
  for (const SearchEnd& end : ends) {
    Json optima = Json::array();
    for (const Optimum& o : end.optima) optima.push_back({{"cost", o.cost}, {"values", o.values}});
    searches.push_back({{"number", end.number}, {"runs", end.runs}, {"optima", std::move(optima)}});
  }
  return sealed(json_document({{"format", kFormat},
                               {"version", kFormatVersion},
                               {"program", version()},
                               {"piece", {{"index", index}, {"count", count}}},
                               {"settings", settings_of(request)},
                               {"searches", std::move(searches)}}));
}

std::vector<SearchEnd> merged_searches(const CalibrationRequest& request,
                                       const std::vector<std::string>& files) {
  std::vector<CalibrationPiece> pieces;
  std::vector<PieceName> names;
  for (const std::string& file : files) {
    pieces.push_back(load(file, request.free.size()));
    names.push_back(pieces.back().name);
  }
  const std::string settings = settings_of(request);
  check_together(names, "calibration", [&](std::size_t k) -> std::string {
    return pieces[k].settings == settings
               ? ""
               : "its law, start, ranges, tests or seed differ from those requested here";
  });
  std::vector<SearchEnd> ends;
  for (CalibrationPiece& piece : pieces) std::ranges::move(piece.ends, std::back_inserter(ends));
  std::ranges::sort(ends, {}, &SearchEnd::number);
  return ends;
}

}  // namespace triax::study
