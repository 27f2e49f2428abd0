// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace triax::python {

/// What --json prints, as dicts and lists.
inline pybind11::object document(const std::string& json) {
  return pybind11::module_::import("json").attr("loads")(json);
}

/// Writes a text as Python does, and raises what Python raises.
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  pybind11::module_::import("pathlib")
      .attr("Path")(path.string())
      .attr("write_text")(text, "utf-8");
}

/// {"specimen.height_mm": 140} as the --set of the program.
inline std::vector<std::pair<std::string, std::string>> key_values(const pybind11::dict& sets) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [key, value] : sets) {
    std::string text = pybind11::str(value);
    if (pybind11::isinstance<pybind11::bool_>(value)) text = text == "True" ? "true" : "false";
    all.emplace_back(pybind11::str(key), std::move(text));
  }
  return all;
}

}  // namespace triax::python
