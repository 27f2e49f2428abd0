// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figure_folder.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include "lab/base/bad_input.hpp"
#include "src/triaxial/figures/few_states.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("triax_figures_" + std::to_string(::getpid()))) {}
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string inside(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::vector<std::string> write_figures(const std::vector<TestResult>& tests,
                                       const std::vector<CollapseIncrement>& increments,
                                       const std::string& folder) {
  FigureFolder figures(folder);
  for (const auto& test : tests) figures.add(test);
  figures.finish(increments);
  return figures.written();
}

}  // namespace

TEST_CASE("each figure is there as SVG, PNG and PDF, under a name that any file system takes") {
  const Folder here;
  const auto folder = here.inside("a/b");
  const auto written = write_figures({test::flow_test(), test::simulated_test()},
                                     {{"L<oose> 1", "ICU", 100e3, 60e3, -1, 0}}, folder);
  for (const char* name :
       {"l_oose__1_stress_path", "sim_26_history", "sim_26_onset", "icu_stress_paths",
        "csu_shear_curves", "icu_strains", "collapse_points", "stress_increments"}) {
    INFO(name);
    for (const char* ending : {".svg", ".png", ".pdf"})
      CHECK(std::filesystem::file_size(folder + "/" + name + ending) > 1000);
  }
  CHECK(written.size() == 2 * 3 + 2 * 3 + 2);
}

TEST_CASE("of two tests with one name the second is told by its id") {
  const Folder here;
  auto second = test::flow_test();
  second.stored.id = 8;
  write_figures({test::flow_test(), second}, {}, here.inside("x"));
  CHECK(std::filesystem::exists(here.inside("x/l_oose__1_stress_path.svg")));
  CHECK(std::filesystem::exists(here.inside("x/l_oose__1_8_stress_path.svg")));
  CHECK_FALSE(std::filesystem::exists(here.inside("x/stress_increments.svg")));
}

TEST_CASE("where no folder can be made the message says so") {
  const Folder here;
  std::filesystem::create_directories(here.inside(""));
  std::ofstream(here.inside("file")) << "x";
  CHECK_THROWS_AS(write_figures({test::flow_test()}, {}, here.inside("file")), lab::BadInput);
}

TEST_CASE("names that differ by blanks and case, that look like another's, or of 300 letters") {
  const Folder here;
  std::vector<TestResult> tests;
  for (const std::string name : {"a b", "A_b", "a_b_2", "a_b_2_3"}) {
    tests.push_back(test::flow_test());
    tests.back().stored.header.name = name;
    tests.back().stored.id = static_cast<std::int64_t>(tests.size());
  }
  tests.push_back(test::flow_test());
  tests.back().stored.header.name = std::string(300, 'N');
  tests.back().stored.id = 5;
  const auto written = write_figures(tests, {}, here.inside("x"));
  CHECK(std::set<std::string>(written.begin(), written.end()).size() == written.size());
  std::size_t paths = 0;
  for (const auto& file : std::filesystem::directory_iterator(here.inside("x")))
    paths += file.path().string().ends_with("_stress_path.svg") ? 1 : 0;
  CHECK(paths == tests.size());
}

TEST_CASE("of hundreds of tests few states are kept, and curves through them are the same") {
  auto test = test::flow_test();
  auto& states = test.curves.states;
  const auto one = states;
  states.clear();
  for (const auto& s : one)  // a logger that is twenty times as fast
    for (int i = 0; i < 20; ++i) states.push_back(s);
  const auto all = states.size();
  keep_few_states(test);
  CHECK(states.size() < all / 10);
  REQUIRE(states.size() > 10);
  CHECK(test.curves.work.empty());
  double most = 0, kept = 0;
  for (const auto& s : one) most = std::max(most, s.q);
  for (const auto& s : states) kept = std::max(kept, s.q);
  CHECK(kept >= most * (1 - 1e-3));
  CHECK(states.back().reading == one.back().reading);
}
