#pragma once
#include <string>
#include <vector>

namespace triax::src {

/// The files of a database: itself and those that SQLite keeps beside it.
std::vector<std::string> database_files(const std::string& db);

/// Throws lab::BadInput where `output` is one of the `kept` files, under whichever name (links,
/// dots in the path), or would become one that does not exist yet. `option` is how the user gave
/// it; `what` names the kept files in the message. "-" and an empty output are never one of them.
void refuse_overwriting(const std::string& option, const std::string& output,
                        const std::vector<std::string>& kept, const std::string& what);

}  // namespace triax::src
