// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace triax::python {

/// A table by columns, as numpy sees it: each column is one block of memory. Constant once Python
/// has it.
struct Columns {
  using Values = std::variant<std::vector<double>, std::vector<std::int64_t>>;
  std::vector<std::pair<std::string, Values>> columns;

  /// A new column; the reference is good until the next one.
  template <class Number = double>
  std::vector<Number>& add(std::string name) {
    columns.emplace_back(std::move(name), std::vector<Number>());
    return std::get<std::vector<Number>>(columns.back().second);
  }
  /// A new column with what `of` gives of each row.
  template <class Number = double, class Rows, class Of>
  void add_of(std::string name, const Rows& rows, const Of& of) {
    auto& values = add<Number>(std::move(name));
    values.reserve(rows.size());
    for (const auto& row : rows) values.push_back(static_cast<Number>(of(row)));
  }
  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] const Values* find(const std::string& name) const;
};

/// The numbers of `values` without a copy, for as long as anybody has the array: it keeps `owner`,
/// which holds them.
template <class Number>
pybind11::array view(const std::vector<Number>& values, const pybind11::object& owner,
                     std::vector<pybind11::ssize_t> shape = {}) {
  if (shape.empty()) shape = {static_cast<pybind11::ssize_t>(values.size())};
  return pybind11::array_t<Number>(std::move(shape), values.data(), owner);
}
/// The same, not to be written to.
template <class Number>
pybind11::array read_only_view(const std::vector<Number>& values, const pybind11::object& owner,
                               std::vector<pybind11::ssize_t> shape = {}) {
  pybind11::array array = view(values, owner, std::move(shape));
  pybind11::detail::array_proxy(array.ptr())->flags &=
      ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}  // namespace triax::python
