// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/otherwise.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"

using namespace triax::lab;

namespace {

/// Reduced: q rises, peaks and falls by three quarters while the volume moves by 0.05 %, which may
/// be water or the compliance of a closed valve.
std::string record() {
  std::string text = "eps1  epsv  p  q  u\n%  %  kPa  kPa  kPa\n";
  for (int i = 0; i <= 200; ++i) {
    const double strain = 0.02 * i, x = strain / 0.6;
    const double q = 100 * x * std::exp(1 - x) * (x < 1 ? 1 : 0.8) + (x < 1 ? 0 : 20);
    text += fmt::format("{:.4f} {:.5f} {:.3f} {:.3f} 300\n", strain, 0.05 * strain / 4,
                        170 + 0.25 * q, q);
  }
  return text;
}

std::unique_ptr<RecordedRig> open(const std::vector<std::pair<std::string, std::string>>& sets) {
  return open_record(open_memory("test.dat", record()), {.sets = sets});
}

}  // namespace

TEST_CASE("a record is read once more with each answer that was not taken") {
  const auto rig = open({});
  REQUIRE(rig->header().guesses.size() == 2);
  CHECK(rig->header().guesses[0].otherwise.empty());
  REQUIRE(rig->header().guesses[1].otherwise.size() == 1);
  CHECK(rig->header().guesses[1].otherwise[0].key == "stages.1.drainage");
  CHECK(rig->header().guesses[1].otherwise[0].value == "closed");
  const auto others = judge_otherwise(rig->header(), {}, [](const Guess::Said& said) {
    return open({{said.key, said.value}});
  });
  REQUIRE(others.size() == 1);
  CHECK(others[0].said == "stages.1.drainage=closed");
  CHECK(others[0].collapse.judged);
  CHECK(others[0].collapse.detected());

  // Asked in the session it is a contradiction: with the drainage open the same is a failure.
  const Collapse c = run_session(*rig, {.otherwise = [&] { return others; }}).collapse;
  CHECK_FALSE(c.judged);
  // What was said is no guess any more, and nothing is asked.
  const auto said = open({{"stages.1.drainage", "closed"}, {"stages.1.role", "shear"}});
  CHECK(said->header().guesses.empty());
}

TEST_CASE("drained, the confinement goes and the strain runs away: a held q, or a faster frame") {
  std::string text = "eps1  epsv  p  q\n%  %  kPa  kPa\n";
  for (int i = 0; i <= 100; ++i)
    text +=
        fmt::format("{:.4f} {:.5f} {:.3f} {:.3f}\n", 0.005 * i, 0.002 * i, 100 + 0.3 * i, 0.9 * i);
  for (int i = 1; i <= 160; ++i)
    text += fmt::format("{:.4f} {:.5f} {:.3f} {:.3f}\n", 0.5 + 0.002 * i + (i > 150 ? i - 150 : 0),
                        0.2 - 0.0007 * i + (i > 150 ? 0.2 * (i - 150) : 0), 130 - 0.3 * i, 90.0);
  const auto open_it = [&](const std::vector<std::pair<std::string, std::string>>& sets) {
    return open_record(open_memory("csd.dat", text), {.sets = sets});
  };
  const auto rig = open_it({});
  const auto others = judge_otherwise(rig->header(), {}, [&](const Guess::Said& said) {
    return open_it({{said.key, said.value}});
  });
  REQUIRE(others.size() == 1);
  CHECK(others[0].said == "stages.1.control=constant_q");
  CHECK(others[0].collapse.detected());
  CHECK_FALSE(run_session(*rig, {.otherwise = [&] { return others; }}).collapse.judged);
}

TEST_CASE("an answer with which the record cannot be read is left out") {
  const auto rig = open({});
  CHECK(judge_otherwise(rig->header(), {}, [](const Guess::Said&) -> std::unique_ptr<RecordedRig> {
          throw BadInput("cannot be");
        }).empty());
}
