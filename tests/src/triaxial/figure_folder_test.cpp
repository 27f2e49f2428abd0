// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figure_folder.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"
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
