// SPDX-License-Identifier: GPL-3.0-or-later
// read_grain_piece(): every value is looked at before it is used, since the file may be anyone's.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "lab/grains/grain_words.hpp"
#include "src/study/document_part.hpp"
#include "src/study/grains/grain_piece_values.hpp"

namespace triax::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostDirections = 36000, kMostPieces = 10000;
constexpr std::int64_t kMostCounted = std::int64_t{1} << 53;  ///< exact as a number of JSON, too
constexpr double kLargest = std::numeric_limits<double>::max();

/// Fills what it visits from a part of the document.
class FromJson {
 public:
  explicit FromJson(const DocumentPart& part) : part_(part) {}
  void operator()(const char* key, double& value) {
    value = part_.number(key, -kLargest, kLargest);
  }
  void operator()(const char* key, std::int64_t& value) {
    value = part_.whole(key, 0, kMostCounted);
  }
  void operator()(const char* key, int& value) {
    value = static_cast<int>(part_.whole(key, 1, kMostDirections));
  }
  void operator()(const char* key, bool& value) { value = part_.flag(key); }
  void operator()(const char* key, std::string& value) { value = part_.text(key); }
  void operator()(const char* key, sim::ProbeKind& value) {
    const std::string word = part_.text(key);
    for (const auto kind : {sim::ProbeKind::stress, sim::ProbeKind::strain})
      if (lab::word(kind) == word) {
        value = kind;
        return;
      }
    part_.fail(fmt::format("{} must be stress or strain", key));
  }
  void operator()(const char* key, std::array<double, 3>& value) { take(key, value.data(), 3); }
  void operator()(const char* key, Eigen::Matrix3d& value) { take(key, value.data(), 9); }

 private:
  void take(const char* key, double* to, std::size_t count) {
    const Json& values = part_.array(key);
    if (values.size() != count) part_.fail(fmt::format("{} must have {} numbers", key, count));
    for (std::size_t k = 0; k < count; ++k) {
      if (!values[k].is_number() || !std::isfinite(values[k].get<double>()))
        part_.fail(fmt::format("{} must have {} numbers", key, count));
      to[k] = values[k].get<double>();
    }
  }
  const DocumentPart& part_;
};

ProbedGrains read_specimen(const DocumentPart& root) {
  ProbedGrains specimen;
  const DocumentPart part = root.part("specimen"), probing = root.part("probing");
  FromJson from(part), of_probing(probing);
  visit_specimen(from, specimen);
  visit_probing(of_probing, specimen);
  if (specimen.fingerprint.size() != 16 ||
      specimen.fingerprint.find_first_not_of("0123456789abcdef") != std::string::npos)
    part.fail("fingerprint must be 16 hexadecimal digits");
  if (specimen.grains < 1) part.fail("grains must be at least 1");
  if (specimen.probing.norm_pa < 0) probing.fail("norm_Pa must not be below 0");
  if (specimen.probing.norm_strain < 0) probing.fail("norm_strain must not be below 0");
  return specimen;
}

sim::GrainProbe read_probe(const DocumentPart& part, const ProbedGrains& of, int number) {
  sim::GrainProbe probe;
  FromJson from(part);
  visit_probe(from, probe);
  if (part.whole("number", 0, kMostDirections) != number)
    part.fail(fmt::format("number must be {}, as in the piece", number));
  const bool by_stress = of.probing.kind == sim::ProbeKind::stress;
  const double norm = number == 0 || !by_stress ? 0 : of.probing.norm_pa;
  const double norm_strain = number == 0 || by_stress ? 0 : of.probing.norm_strain;
  const double angle = number == 0 ? 0 : sim::rose_angles(of.directions)[number - 1];
  if (probe.norm_pa != norm) part.fail(fmt::format("norm_Pa must be {}", norm));
  if (probe.norm_strain != norm_strain)
    part.fail(fmt::format("norm_strain must be {}", norm_strain));
  if (probe.angle != angle) part.fail(fmt::format("angle_rad must be {}", angle));
  return probe;
}

}  // namespace

GrainPiece read_grain_piece(std::string_view text, const std::string& file) {
  const Json document = parsed_document(
      text, file, kGrainPieceFormat,
      "is not a piece of probes of grains; triax grains --piece I/N --output FILE writes one");
  const DocumentPart root(document, file);
  require_version(root, kGrainPieceVersion);
  GrainPiece piece{.file = file, .program = root.text("program")};
  const DocumentPart of = root.part("piece");
  piece.count = static_cast<int>(of.whole("count", 1, kMostPieces));
  piece.index = static_cast<int>(of.whole("index", 1, piece.count));
  piece.specimen = read_specimen(root);
  const auto numbers = sim::numbers_of_piece(piece.specimen.directions, piece.index, piece.count);
  const Json& found = root.array("probes");
  if (found.size() != numbers.size())
    root.fail(fmt::format("has {0} probes; piece {1} of {2} must have {3}", found.size(),
                          piece.index, piece.count, numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k)
    piece.probes.push_back(
        read_probe(root.in(found[k], fmt::format("probes[{}]", k)), piece.specimen, numbers[k]));
  return piece;
}

}  // namespace triax::study
