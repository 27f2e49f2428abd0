// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_host.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "sim/materials/umat_exchange.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

UmatExchange* served = nullptr;

void umat_host_end(const std::string& message) {
  if (served != nullptr) {
    served->say(message);
    served->stage = UmatStage::xit;
  }
  _exit(0);
}

struct Place {
  int row, column;
};
constexpr std::array<Place, 3> kShear{{{0, 1}, {0, 2}, {1, 2}}};

Eigen::Matrix3d tensor(const double* s, int kind, int direct, int shear) {
  Eigen::Matrix3d t = Eigen::Matrix3d::Zero();
  for (int i = 0; i < std::min(direct, 3); ++i) t(i, i) = s[i];
  for (int i = 0; i < std::min(shear, 3); ++i) {
    const Place at = kShear[static_cast<std::size_t>(i)];
    t(at.row, at.column) = t(at.column, at.row) = kind == 2 ? s[direct + i] / 2 : s[direct + i];
  }
  return t;
}

void put(const Eigen::Matrix3d& t, int kind, int direct, int shear, double* s) {
  for (int i = 0; i < std::min(direct, 3); ++i) s[i] = t(i, i);
  for (int i = 0; i < std::min(shear, 3); ++i) {
    const Place at = kShear[static_cast<std::size_t>(i)];
    s[direct + i] = kind == 2 ? 2 * t(at.row, at.column) : t(at.row, at.column);
  }
}

std::string trimmed(const char* text, std::size_t length) {
  std::string s(text, length);
  s.erase(s.find_last_not_of(' ') + 1);
  return s;
}

/// STRING with %I, %R and %S replaced by the next of INTV, REALV and CHARV.
std::string filled(const std::string& pattern, const int* integers, const double* reals,
                   const char* texts, std::size_t text_length) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char kind = pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1] : '\0';
    std::array<char, 32> number{};
    if (kind == 'I' || kind == 'i') {
      out += std::to_string(*integers++);
    } else if (kind == 'R' || kind == 'r') {
      std::snprintf(number.data(), number.size(), "%g", *reals++);
      out += number.data();
    } else if (kind == 'S' || kind == 's') {
      out += trimmed(texts, text_length);
      texts += text_length;
    } else {
      out += pattern[i];
      continue;
    }
    ++i;
  }
  return out;
}

void put_text(const std::string& text, char* out, int* length, std::size_t room) {
  std::fill_n(out, room, ' ');
  text.copy(out, room);
  *length = static_cast<int>(std::min(text.size(), room));
}

}  // namespace

void umat_host_serve(UmatExchange* exchange) { served = exchange; }

}  // namespace triax::sim

using namespace triax::sim;  // NOLINT(google-build-using-namespace)

// Names and arguments are Fortran's; integers and texts come by reference, lengths of texts at the
// end.
extern "C" {

void xit_() { umat_host_end(""); }

void stdb_abqerr_(const int* kind, const char* text, const int* integers, const double* reals,
                  const char* texts, std::size_t length, std::size_t texts_length) {
  const std::string message = filled(trimmed(text, length), integers, reals, texts, texts_length);
  if (*kind == -3) umat_host_end(message);
  if (*kind == -2 && served != nullptr) {
    served->say(message);
    served->stage = UmatStage::objected;
  }
  const std::string line = message + "\n";
  if (write(STDOUT_FILENO, line.data(), line.size()) < 0) return;
}

void sinv_(const double* s, double* p, double* q, const int* direct, const int* shear) {
  const Eigen::Matrix3d t = tensor(s, 1, *direct, *shear);
  *p = t.trace() / 3;
  *q = std::sqrt(1.5) * (t - *p * Eigen::Matrix3d::Identity()).norm();
}

void sprinc_(const double* s, double* values, const int* kind, const int* direct,
             const int* shear) {
  const auto [principal, axes] = principal_axes(tensor(s, *kind, *direct, *shear));
  for (int i = 0; i < 3; ++i) values[i] = principal(i);
}

void sprind_(const double* s, double* values, double* directions, const int* kind,
             const int* direct, const int* shear) {
  const auto [principal, axes] = principal_axes(tensor(s, *kind, *direct, *shear));
  for (int i = 0; i < 3; ++i) {
    values[i] = principal(i);
    for (int j = 0; j < 3; ++j) directions[i + 3 * j] = axes(j, i);
  }
}

void rotsig_(const double* s, const double* rotation, double* turned, const int* kind,
             const int* direct, const int* shear) {
  const Eigen::Map<const Eigen::Matrix3d> r(rotation);
  put(r * tensor(s, *kind, *direct, *shear) * r.transpose(), *kind, *direct, *shear, turned);
}

void getoutdir_(char* folder, int* length, std::size_t room) {
  std::array<char, 4096> here{};
  put_text(getcwd(here.data(), here.size()) != nullptr ? here.data() : ".", folder, length, room);
}
void getjobname_(char* name, int* length, std::size_t room) {
  put_text("triax", name, length, room);
}
void getrank_(int* rank) { *rank = 0; }
void getnumcpus_(int* number) { *number = 1; }
int getnumthreads_() { return 1; }
int get_thread_id_() { return 0; }
void mutexinit_(const int*) {}
void mutexlock_(const int*) {}
void mutexunlock_(const int*) {}

}  // extern "C"
