// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_piece.hpp"

#include <fmt/format.h>

#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/grain_bytes.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "src/study/domain/domain_json.hpp"
#include "src/study/grains/grain_piece_values.hpp"
#include "src/study/pieces.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

using Json = nlohmann::ordered_json;

class ToJson {
 public:
  template <class T>
  void operator()(const char* key, const T& value) {
    json[key] = value;
  }
  void operator()(const char* key, const sim::ProbeKind& value) { json[key] = lab::word(value); }
  void operator()(const char* key, const Eigen::Matrix3d& value) {
    json[key] = std::vector<double>(value.data(), value.data() + value.size());
  }
  Json json = Json::object();
};

Json specimen_json(const ProbedGrains& specimen) {
  ToJson to;
  visit_specimen(to, specimen);
  return std::move(to.json);
}

Json probing_json(const ProbedGrains& specimen) {
  ToJson to;
  visit_probing(to, specimen);
  return std::move(to.json);
}

}  // namespace

std::string difference(const GrainPiece& a, const GrainPiece& b) {
  const auto first = [&](const char* of, const Json& x, const Json& y) -> std::string {
    for (const auto& [key, value] : x.items())
      if (const Json& other = y.at(key); other != value)
        return fmt::format("{} {} is {}, in {} {}", of, key, dumped(value), b.file, dumped(other));
    return {};
  };
  const std::string found = first("specimen", specimen_json(a.specimen), specimen_json(b.specimen));
  return !found.empty() ? found
                        : first("probing", probing_json(a.specimen), probing_json(b.specimen));
}

ProbedGrains probed_grains(const sim::GrainState& state, const std::string& programme,
                           const std::string& stage, const lab::GrainProbeStage& how) {
  return {.programme = programme,
          .stage = stage,
          .fingerprint = fmt::format("{:016x}", sim::fingerprint(state)),
          .grains = static_cast<std::int64_t>(state.grains.size()),
          .stress = sim::axisymmetric_stress(state),
          .measures = sim::measure(state),
          .probing = how.probing,
          .directions = how.directions};
}

std::string grain_piece_json(const GrainPiece& piece) {
  const auto numbers = sim::numbers_of_piece(piece.specimen.directions, piece.index, piece.count);
  std::string out = fmt::format(
      "{{\n\"format\": \"{}\",\n\"version\": {},\n\"program\": \"{}\",\n\"origin\": "
      "\"simulated\",\n\"piece\": {},\n\"specimen\": {},\n\"probing\": "
      "{},\n\"probes\": [",
      kGrainPieceFormat, kGrainPieceVersion, version(),
      dumped({{"index", piece.index}, {"count", piece.count}}),
      dumped(specimen_json(piece.specimen)), dumped(probing_json(piece.specimen)));
  for (std::size_t k = 0; k < piece.probes.size(); ++k) {
    ToJson to;
    to("number", numbers.at(k));
    visit_probe(to, piece.probes[k]);
    out += (k > 0 ? ",\n" : "\n") + dumped(to.json);
  }
  return sealed(out + "\n]\n}\n");
}

GrainPiece load_grain_piece(const std::string& path) {
  const std::string text = piece_text(path, "triax grains --piece", "rose");
  GrainPiece piece = read_grain_piece(text, path);
  check_seal(text, path);
  return piece;
}

lab::GrainRose merged(const std::vector<GrainPiece>& pieces) {
  std::vector<PieceName> names;
  for (const GrainPiece& p : pieces) names.push_back({p.file, p.program, p.index, p.count});
  check_together(names, "rose",
                 [&](std::size_t k) { return difference(pieces[k], pieces.front()); });
  const ProbedGrains& specimen = pieces.front().specimen;
  lab::GrainRose whole{specimen.stress, sim::rose_angles(specimen.directions), {}};
  whole.rose.probes.resize(whole.angles.size());
  for (const GrainPiece& piece : pieces) {
    const auto numbers = sim::numbers_of_piece(specimen.directions, piece.index, piece.count);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      (numbers[k] == 0 ? whole.rose.null_probe : whole.rose.probes[numbers[k] - 1]) =
          piece.probes.at(k);
  }
  return whole;
}

}  // namespace triax::study
