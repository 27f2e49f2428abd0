// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/writer_identity.hpp"

#include <unistd.h>

#include <QString>
#include <QSysInfo>
#include <fstream>
#include <sstream>

namespace triax::db {
namespace {

/// Field 22 of /proc/PID/stat; the second field is a name that may hold blanks and brackets.
std::int64_t start_of(std::int64_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(line.substr(name_end + 1));
  std::string state;
  fields >> state;
  if (state == "Z" || state == "X") return 0;  // dead, waiting to be noticed
  std::string skipped;
  for (int field = 4; field < 22; ++field) fields >> skipped;
  std::int64_t started = 0;
  fields >> started;
  return started;
}

}  // namespace

WriterIdentity this_process() {
  return {getpid(), start_of(getpid()), QSysInfo::machineHostName().toStdString()};
}

bool may_be_alive(const WriterIdentity& writer) {
  if (writer.host != QSysInfo::machineHostName().toStdString()) return true;
  return start_of(writer.pid) == writer.started && writer.started != 0;
}

}  // namespace triax::db
