// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A header as SCPI's manuals write it: "[SOURce:]PRESsure#:TARGet?". Capitals are the short form,
/// the whole word the long one, nothing between is known; what stands in brackets may be left out;
/// behind # a number may stand, 1 where it does not; a query ends with ?. "*IDN?" has one form.
class ScpiPattern {
 public:
  explicit ScpiPattern(std::string_view pattern);

  enum class Match { no, wrong_suffix, yes };
  /// `header` without a leading colon, in any case. `suffixes` gets a number for every # of the
  /// pattern, in its order, if it is a match. wrong_suffix: it would be one without its numbers.
  Match match(std::string_view header, std::vector<int>& suffixes) const;

  const std::string& text() const { return text_; }
  bool is_query() const { return query_; }
  /// The short form with all that may be left out left out, as a controller sends it.
  std::string shortest() const;
  /// The long form with everything.
  std::string longest() const;

 private:
  struct Node {
    std::string shorter, longer;
    bool optional, numbered;
  };
  Match match_from(std::size_t node, std::string_view rest, std::vector<int>& suffixes) const;
  static Match match_node(const Node& node, std::string_view word, std::vector<int>& suffixes);

  std::string text_;
  std::vector<Node> nodes_;
  bool query_;
};

}  // namespace triax::lab
