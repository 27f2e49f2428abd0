// SPDX-License-Identifier: GPL-3.0-or-later
// Uploaded records.
#include <string>
#include <utility>
#include <vector>

#include "lab/base/text.hpp"
#include "src/page/api/changes_api.hpp"

namespace triax::src {
namespace {

/// What reading a record may need: a line of the longest, the head, a batch for the database.
constexpr std::size_t kMemoryOfReader = std::size_t{64} << 20;

std::string file_name_in(const Target& target) {
  std::string name = target.value("name").value_or("record");
  if (const auto slash = name.find_last_of("/\\"); slash != std::string::npos)
    name = name.substr(slash + 1);
  constexpr std::size_t kMost = 200;
  if (name.empty() || name.size() > kMost)
    throw Refused(400, "name: expected the name of the file, at most 200 bytes");
  return name;
}

std::vector<std::pair<std::string, std::string>> sets_of(const Target& target) {
  std::vector<std::pair<std::string, std::string>> sets;
  for (const auto& [name, value] : target.query) {
    if (name != "set") continue;
    const auto equals = value.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Refused(400, "set=" + lab::excerpt(value) + ": expected KEY=VALUE");
    sets.emplace_back(value.substr(0, equals), value.substr(equals + 1));
  }
  return sets;
}

/// One value for each line, since a target must not have control characters.
std::string dialect_in(const Target& target) {
  std::string text;
  for (const auto& [name, line] : target.query)
    if (name == "dialect") text.append(line).push_back('\n');
  return text;
}

}  // namespace

PageAnswer take_record(PageLaboratory& laboratory, const PageRequest& request, RecordTask task) {
  const auto share = laboratory.budget.take(kMemoryOfReader);
  if (!share) throw Refused(503, "too many records are read at once; try again later");
  const RecordToRead record{.db = laboratory.db,
                            .name = file_name_in(request.target),
                            .sets = sets_of(request.target),
                            .task = task,
                            .dialect = dialect_in(request.target),
                            .sheet = request.target.value("worksheet").value_or("")};
  return json_answer(laboratory.read_record(
      record, *request.upload, [&] { return laboratory.ending || request.is_cancelled(); }));
}

}  // namespace triax::src
