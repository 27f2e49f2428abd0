// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace triax::lab {

/// Input that cannot be understood: one line that names the file, the line or key, what was found
/// and what would be right. The program ends with status 2 and leaves nothing behind.
class BadInput : public std::runtime_error {
 public:
  explicit BadInput(const std::string& what) : std::runtime_error(what) {}
  /// "FILE:LINE: message"; line 0 leaves the line out.
  BadInput(const std::string& file, std::int64_t line, const std::string& message)
      : std::runtime_error(line > 0 ? file + ":" + std::to_string(line) + ": " + message
                                    : file + ": " + message) {}
};

/// A record does not say what its reduction needs: the key that gives it, and what it is.
class MissingKey : public BadInput {
 public:
  MissingKey(const std::string& file, std::string key, std::string label, std::string unit,
             const std::string& message)
      : BadInput(file, 0, message),
        key_(std::move(key)),
        label_(std::move(label)),
        unit_(std::move(unit)) {}
  const std::string& key() const { return key_; }      ///< "specimen.height_mm"
  const std::string& label() const { return label_; }  ///< "height of the specimen"
  const std::string& unit() const { return unit_; }    ///< "mm"

 private:
  std::string key_, label_, unit_;
};

/// Work that was understood but failed on the way (disk full, control lost): status 1.
class WorkFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace triax::lab
