// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/subjects.hpp"

#include <fstream>
#include <sstream>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/programmes/programme_reader.hpp"

namespace triax::bench {
namespace {

double void_ratio_from(const std::string& text, const std::string& list, std::int64_t line) {
  const auto value = lab::whole_text_as<double>(text);
  if (!value || !(*value > 0))
    throw lab::BadInput(list, line, "void ratio \"" + text + "\": a number above 0 or - is asked");
  return *value;
}

}  // namespace

std::vector<Subject> read_subjects(const std::string& list, const std::string& folder) {
  std::ifstream file(list);
  if (!file) throw lab::BadInput(list + ": cannot be read");
  std::vector<Subject> subjects;
  std::string text;
  for (std::int64_t line = 1; std::getline(file, text); ++line) {
    if (text.empty() || text.front() == '#') continue;
    std::istringstream words(text);
    std::string programme, material, void_ratio, expected, more;
    if (!(words >> programme >> material >> void_ratio >> expected) || words >> more ||
        (expected != "collapse" && expected != "stable"))
      throw lab::BadInput(
          list, line, "\"" + text + "\": PROGRAMME MATERIAL VOID_RATIO collapse|stable is asked");
    Subject s{lab::load_programme(folder + "/" + programme + ".toml"), expected == "collapse"};
    if (material != "-") s.programme.material = lab::find_material(material);
    if (void_ratio != "-") s.programme.void_ratio = void_ratio_from(void_ratio, list, line);
    subjects.push_back(std::move(s));
  }
  if (subjects.empty()) throw lab::BadInput(list + ": no programme in it");
  return subjects;
}

}  // namespace triax::bench
