// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/label_text.hpp"

#include <algorithm>
#include <cmath>

#include "lab/intake/names/heading_unit.hpp"

namespace triax::lab {

NamedLabels find_named_labels(const QString& text) {
  const LabelIndex& index = LabelIndex::get();
  const auto is_name = [&](const QString& name, const std::vector<const UnitName*>& units) {
    return std::ranges::any_of(index.find(name),
                               [&](const Label* label) { return label->fits(units); });
  };
  constexpr qsizetype kMaxLabelLength = 100;
  if (text.isEmpty() || text.size() > kMaxLabelLength) return {};
  const auto [name, unit] = split_unit(text, is_name);
  return {index.find(name), unit};
}

std::optional<Amount> read_amount(const QString& text) {
  static const QRegularExpression pattern(R"(^\s*([-+]?[.,]?\d[\d.,]*(?:[eE][-+]?\d+)?))");
  const auto match = pattern.match(text);
  if (!match.hasMatch()) return std::nullopt;
  QString number = match.captured(1);
  while (number.back() == u'.' || number.back() == u',') number.chop(1);
  const QString behind = text.sliced(match.capturedStart(1) + number.size());
  static const QRegularExpression unit_end(R"([;|]|,(?=\s|$)|(?<=\S)\s\s)");
  const qsizetype end = behind.indexOf(unit_end);
  const QString whole = (end < 0 ? behind : behind.first(end)).trimmed();
  const QString word = whole.section(u' ', 0, 0);
  for (const QString& unit : {whole, word})
    if (!find_units(unit).empty())
      return Amount{number, unit, behind.sliced(behind.indexOf(unit) + unit.size())};
  return Amount{number, {}, behind};
}

std::optional<double> decimal_number(QString text) {
  const qsizetype mark = std::max(text.lastIndexOf(u'.'), text.lastIndexOf(u','));
  if (mark >= 0) {
    const bool is_repeated = text.count(text[mark]) > 1;
    QString whole = text.first(mark);
    whole.remove(u'.').remove(u',');
    text = whole + (is_repeated ? "" : ".") + text.sliced(mark + 1);
  }
  bool ok = false;
  const double value = text.toDouble(&ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> grouped_number(const QString& text) {
  static const QRegularExpression grouped(R"(^[-+]?\d{1,3}[.,]\d{3}$)");
  if (!grouped.match(text).hasMatch()) return std::nullopt;
  return QString(text).remove(u'.').remove(u',').toDouble();
}

bool are_repeated(double a, double b) {
  constexpr double kRounding = 0.005;
  return std::fabs(a - b) <= kRounding * std::fabs(a);
}

const QRegularExpression& label_delimiter() {
  static const QRegularExpression pattern(R"([;|\t]|,(?!\d)|(?<!\d),|\s\s|\s[-–—/]\s)");
  return pattern;
}

NamedLabels take_last_label(QString& before) {
  std::vector<qsizetype> starts;
  for (auto at = label_delimiter().globalMatch(before); at.hasNext();)
    starts.push_back(at.next().capturedEnd());
  starts.insert(starts.begin(), 0);
  starts.insert(starts.begin(), before.lastIndexOf(u'(') + 1);
  for (; !starts.empty(); starts.pop_back()) {
    NamedLabels named = find_named_labels(before.sliced(starts.back()).trimmed());
    if (named.labels.empty()) continue;
    before.truncate(starts.back());
    return named;
  }
  return {};
}

qsizetype end_of_text(const QString& text) {
  static const QRegularExpression pattern(label_delimiter().pattern() + R"(|\s\()");
  static const QRegularExpression mark("[:=]");
  qsizetype start = 0;
  while (start < text.size() && text[start].isSpace()) ++start;
  for (auto at = pattern.globalMatch(text, start); at.hasNext();) {
    const auto match = at.next();
    constexpr qsizetype kDashLength = 3;
    if (match.capturedLength() != kDashLength) return match.capturedStart();
    const qsizetype end = text.indexOf(mark, match.capturedEnd());
    const QString next =
        text.sliced(match.capturedEnd(), std::max<qsizetype>(end - match.capturedEnd(), 0));
    if (!find_named_labels(next.trimmed()).labels.empty()) return match.capturedStart();
  }
  return text.size();
}

}  // namespace triax::lab
