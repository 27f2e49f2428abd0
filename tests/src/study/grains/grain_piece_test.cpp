// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_piece.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lab/base/bad_input.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "src/study/grains/grain_piece_values.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax;
using namespace triax::study;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kPieces = 3;
constexpr std::size_t kValues = 61;  ///< of a probe

/// A lattice under some stress, and short probes of it in five directions.
const sim::GrainState& state() {
  static const sim::GrainState made = [] {
    sim::Grains grains(sim::test::lattice(4));
    grains.drive(sim::triaxial_drives(sim::stress_drive(2e4), sim::stress_drive(1e4)));
    grains.step(2000);
    return grains.state();
  }();
  return made;
}

lab::GrainProbeStage how() {
  lab::GrainProbeStage stage;
  stage.directions = 5;
  stage.probing.norm_pa = 100.1;
  stage.probing.ramp_steps = 50;
  stage.probing.check_every = 50;
  stage.probing.most_steps = 200;
  stage.probing.sample_every = 20;
  return stage;
}

ProbedGrains specimen() { return probed_grains(state(), "dense.toml", "a \"rose\"", how()); }

GrainPiece computed(int index) {
  GrainPiece piece{.index = index, .count = kPieces, .specimen = specimen()};
  piece.probes = sim::some_probes(state(), sim::rose_angles(5),
                                  sim::numbers_of_piece(5, index, kPieces), how().probing, 1)
                     .probes;
  return piece;
}

const std::string& piece(int index) {
  static const std::vector<std::string> all{
      grain_piece_json(computed(1)), grain_piece_json(computed(2)), grain_piece_json(computed(3))};
  return all.at(index - 1);
}

std::vector<GrainPiece> all_pieces() {
  return {read_grain_piece(piece(3), "c.json"), read_grain_piece(piece(1), "a.json"),
          read_grain_piece(piece(2), "b.json")};
}

/// All values of a probe, to the bit.
struct Bits {
  std::vector<double> numbers;
  void operator()(const char*, double x) { numbers.push_back(x); }
  void operator()(const char*, std::int64_t x) { numbers.push_back(static_cast<double>(x)); }
  void operator()(const char*, bool x) { numbers.push_back(x ? 1 : 0); }
  void operator()(const char*, const std::array<double, 3>& x) {
    numbers.insert(numbers.end(), x.begin(), x.end());
  }
};
bool same(const sim::GrainProbe& a, const sim::GrainProbe& b) {
  Bits x, y;
  visit_probe(x, a);
  visit_probe(y, b);
  return x.numbers.size() == kValues && y.numbers.size() == kValues &&
         std::memcmp(x.numbers.data(), y.numbers.data(), kValues * sizeof(double)) == 0;
}

/// The message of the refusal of piece 2 after this change.
template <class Change>
std::string refusal(const Change& change) {
  Json document = Json::parse(piece(2));
  change(document);
  try {
    read_grain_piece(document.dump(), "b.json");
  } catch (const lab::BadInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("pieces of a rose of grains are the run in one go to the bit") {
  const sim::ProbeRose whole = sim::probe_rose(state(), sim::rose_angles(5), how().probing, 2);
  const lab::GrainRose together = merged(all_pieces());
  CHECK(together.angles == sim::rose_angles(5));
  CHECK(together.stress.axial == sim::axisymmetric_stress(state()).axial);
  CHECK(together.stress.radial == sim::axisymmetric_stress(state()).radial);
  CHECK_FALSE(together.rose.stopped);
  CHECK(same(together.rose.null_probe, whole.null_probe));
  REQUIRE(together.rose.probes.size() == 5);
  for (int k = 0; k < 5; ++k) {
    INFO(k);
    CHECK(same(together.rose.probes[k], whole.probes[k]));
    CHECK(whole.probes[k].steps > 0);
  }
  CHECK_FALSE(same(whole.probes[0], whole.probes[1]));
}

TEST_CASE("a piece keeps what was probed, and odd numbers, to the bit") {
  GrainPiece odd = computed(1);
  odd.probes[0].work.lagrangian = -0.0;
  odd.probes[0].work.normal_part = 4.9e-324;
  odd.probes[0].work.boundary_part = 1.0 / 3;
  odd.probes[0].most_kinetic_j = 1.7976931348623157e308;
  odd.probes[0].work.opened = std::int64_t{1} << 52;
  const GrainPiece read = read_grain_piece(grain_piece_json(odd), "a.json");
  CHECK(same(read.probes[0], odd.probes[0]));
  CHECK(std::signbit(read.probes[0].work.lagrangian));
  CHECK(grain_piece_json(read) == grain_piece_json(odd));
  const ProbedGrains& s = read.specimen;
  CHECK(s.programme == "dense.toml");
  CHECK(s.stage == "a \"rose\"");
  CHECK(s.fingerprint.size() == 16);
  CHECK(s.grains == 64);
  CHECK(s.directions == 5);
  CHECK(s.probing.norm_pa == 100.1);
  CHECK(s.measures.stress_pa == sim::measure(state()).stress_pa);
  CHECK(s.measures.wall_stress_pa == sim::measure(state()).wall_stress_pa);
  CHECK(Json::parse(piece(1))["origin"] == "simulated");
}

TEST_CASE("a piece of a rose that is missing, twice or of something else is named") {
  auto pieces = all_pieces();
  pieces.erase(pieces.begin());
  CHECK_THROWS_WITH(merged(pieces), "--merge: piece 3 of 3 is missing (2 given)");
  pieces.push_back(read_grain_piece(piece(1), "again.json"));
  CHECK_THROWS_WITH(merged(pieces), Contains("again.json: is piece 1 of 3, like a.json"));

  const auto refused = [](const auto& change, const char* words) {
    auto some = all_pieces();
    change(some[2]);
    CHECK_THROWS_WITH(merged(some), Contains("b.json: ") && Contains(words));
  };
  refused([](GrainPiece& p) { p.count = 4; }, "is one of 4 pieces, c.json one of 3");
  refused([](GrainPiece& p) { p.program = "0.0.1"; }, "was written by triax 0.0.1");
  refused([](GrainPiece& p) { p.specimen.probing.norm_pa = 50; },
          "another rose: probing norm_Pa is 50.0, in c.json 100.1");
  refused([](GrainPiece& p) { p.specimen.fingerprint = "0123456789abcdef"; },
          "another rose: specimen fingerprint is \"0123456789abcdef\", in c.json");
  refused([](GrainPiece& p) { p.specimen.stress.axial += 1e-9; }, "specimen axial_stress_Pa is");
}

TEST_CASE("what is no whole piece of a rose is refused in one line that names the file") {
  const std::string good = piece(2);
  CHECK(refusal([](Json&) {}).empty());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, good.size() / 2, good.size() - 3})
    CHECK_THROWS_WITH(read_grain_piece(good.substr(0, length), "b.json"),
                      Contains("b.json: is not a complete JSON document"));
  for (const char* foreign :
       {"{}", "[]", "null", "{\"format\": \"triax bifurcation domain piece\"}"})
    CHECK_THROWS_WITH(read_grain_piece(foreign, "b.json"),
                      Contains("b.json: is not a piece of probes of grains"));
  CHECK_THROWS_AS(read_grain_piece(std::string(100000, '['), "b.json"), lab::BadInput);

  const auto says = [](const std::string& message, const char* words) {
    INFO(message);
    CHECK(message.rfind("b.json: ", 0) == 0);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find(words) != std::string::npos);
  };
  says(refusal([](Json& d) { d["version"] = 2; }), "format version '2'");
  says(refusal([](Json& d) { d["piece"]["index"] = 4; }), "index must be an integer, 1 to 3");
  says(refusal([](Json& d) { d["piece"]["index"] = 1; }), "number must be 0, as in the piece");
  says(refusal([](Json& d) { d["piece"]["count"] = 1; }), "index must be");
  says(refusal([](Json& d) { d.erase("specimen"); }), "specimen is missing");
  says(refusal([](Json& d) { d["specimen"]["fingerprint"] = "XYZ"; }), "16 hexadecimal digits");
  says(refusal([](Json& d) { d["specimen"]["grains"] = 0; }), "grains must be at least 1");
  says(refusal([](Json& d) { d["specimen"]["grains"] = -1; }), "grains must be an integer");
  says(refusal([](Json& d) { d["specimen"]["wall_stress_Pa"] = {1, 2}; }), "must have 3 numbers");
  says(refusal([](Json& d) { d["specimen"]["stress_Pa"][8] = "x"; }), "must have 9 numbers");
  says(refusal([](Json& d) { d["probing"]["directions"] = 36; }),
       "has 2 probes; piece 2 of 3 must have");
  says(refusal([](Json& d) { d["probing"]["directions"] = 0; }), "directions must be");
  says(refusal([](Json& d) { d["probing"]["norm_Pa"] = 7; }), "norm_Pa must be 7");
  says(refusal([](Json& d) { d["probing"]["norm_Pa"] = -7; }), "norm_Pa must not be below 0");
  says(refusal([](Json& d) { d["probing"]["norm_strain"] = -7; }), "norm_strain must not be");
  says(refusal([](Json& d) { d["probing"]["kind"] = "both"; }), "kind must be stress or strain");
  says(refusal([](Json& d) { d["probing"]["kind"] = "strain"; }), "norm_Pa must be 0");
  says(refusal([](Json& d) { d["probes"].clear(); }), "has 0 probes");
  says(refusal([](Json& d) { d["probes"][1]["number"] = 3; }), "number must be 4");
  says(refusal([](Json& d) { d["probes"][0]["angle_rad"] = 0.1; }), "angle_rad must be 0");
  says(refusal([](Json& d) { d["probes"][0]["steps"] = 1.5; }), "steps must be an integer");
  says(refusal([](Json& d) { d["probes"][0]["steps"] = 1e300; }), "steps must be an integer");
  says(refusal([](Json& d) { d["probes"][0]["axial_strain"] = nullptr; }),
       "probes[0]: axial_strain must be a number");
  says(refusal([](Json& d) { d["probes"][0].erase("w2_normalised"); }), "w2_normalised is missing");
  says(refusal([](Json& d) { d["probes"][0]["at_rest"] = 1; }), "at_rest must be true or false");
}

TEST_CASE("more pieces than probes: the last ones are empty, and belong") {
  std::vector<GrainPiece> pieces;
  for (int index = 1; index <= 8; ++index) {
    GrainPiece one{.index = index, .count = 8, .specimen = specimen()};
    one.probes = sim::some_probes(state(), sim::rose_angles(5), sim::numbers_of_piece(5, index, 8),
                                  how().probing, 1)
                     .probes;
    pieces.push_back(read_grain_piece(grain_piece_json(one), std::to_string(index)));
  }
  CHECK(pieces[7].probes.empty());
  CHECK(same(merged(pieces).rose.probes[4], merged(all_pieces()).rose.probes[4]));
}

TEST_CASE("a piece of a rose is read from its file, which must be one") {
  const auto file = std::filesystem::temp_directory_path() / "triax_grain_piece_test.json";
  std::ofstream(file) << piece(2);
  const GrainPiece read = load_grain_piece(file.string());
  CHECK(read.index == 2);
  CHECK(read.count == kPieces);
  CHECK(read.file == file.string());
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(load_grain_piece(file.string()), Contains("triax grains --piece"));
  CHECK_THROWS_WITH(load_grain_piece("."), Contains("is not a regular file"));
}

TEST_CASE("the fuzzer's seeds are pieces of a rose") {
  int seeds = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator("tests/fuzz/seeds/grain_piece_fuzz")) {
    CHECK_NOTHROW(load_grain_piece(entry.path().string()));
    ++seeds;
  }
  CHECK(seeds >= 2);
}
