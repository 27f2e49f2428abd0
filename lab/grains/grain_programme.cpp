// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_programme.hpp"

#include <cctype>

namespace triax::lab {

std::string in_file_name(const std::string& name) {
  std::string text = name;
  for (char& c : text)
    if (const auto u = static_cast<unsigned char>(c);
        !(u < 128 && (std::isalnum(u) != 0 || c == '.' || c == '-')))
      c = '_';
  return text;
}

}  // namespace triax::lab
