// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Labels, numbers and delimiters inside a text above a table.
#include <QRegularExpression>
#include <QString>
#include <algorithm>
#include <optional>
#include <vector>

#include "lab/intake/names/label_index.hpp"

namespace triax::lab {

struct NamedLabels {
  std::vector<const Label*> labels;
  QString unit;

  bool has_number() const { return std::ranges::any_of(labels, &Label::is_number); }
  bool has_text() const { return !std::ranges::all_of(labels, &Label::is_number); }
};
/// The labels that a whole text names, with the unit behind them; none for a long text.
NamedLabels find_named_labels(const QString& text);

/// A number with its unit at the beginning of a text.
struct Amount {
  QString number;
  QString unit;
  QString rest;  ///< of the text
};
std::optional<Amount> read_amount(const QString& text);
/// The number with its one mark, or the last of two kinds of marks, as decimal mark.
std::optional<double> decimal_number(QString text);
/// The number with its mark between thousands, if it can be that: "86,193".
std::optional<double> grouped_number(const QString& text);

/// True if both numbers can be one measurement, stated with another rounding.
bool are_repeated(double a, double b);

/// Between two labels of one text. A comma between digits is a decimal mark.
const QRegularExpression& label_delimiter();
/// The label at the end of `before`: behind its last delimiter if that is the name of one, else
/// behind an earlier one ("Height, mm"), else in a bracket that is open. `before` keeps the rest.
NamedLabels take_last_label(QString& before);
/// Where the text at the beginning of `text`, behind a colon, ends. A dash may belong to it, if no
/// label with a colon follows.
qsizetype end_of_text(const QString& text);

}  // namespace triax::lab
