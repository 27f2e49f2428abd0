// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/encoding_odds.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace triax::lab {
namespace {

/// A language group as the characters beyond ASCII that its headings are made of. The odds of a
/// character are the fraction of its group divided by the number of characters in the group.
struct CodePage {
  const char* name;
  const char* iconv_name;
  double prior;                ///< logarithm
  std::u32string_view common;  ///< letters that make up half of a text and more
  char32_t from, to;           ///< range of the other letters
  bool is_latin;               ///< letters are between ASCII letters
  bool is_alphabet;            ///< or they are never beside one
};

constexpr std::u32string_view kWestern = U"éèàùâêîôûçñáíóúãõäöüßìòÉÀÇÓÍÁÄÖÜåøæ";
constexpr std::u32string_view kCentral = U"ąćęłńóśźżĄĆĘŁŃÓŚŹŻáčďéěíňřšťúůýžÁČĎÉĚÍŇŘŠŤÚŮÝŽőűöüäÖÜ";
constexpr std::u32string_view kTurkish = U"çğıöşüÇĞİÖŞÜâ";
constexpr std::u32string_view kRussian = U"абвгдежзийклмнопрстуфхцчшщъыьэюяё";
constexpr std::u32string_view kChinese =
    U"试验编号时间轴向位移应变力差围压孔隙水主体积系数高度直径土样本量环百分表读温反剪切固结排校正"
    U"面有效应总平均偏速率日期初始"
    U"最大值小单注备名称项目工程钻深取号次荷载传感器测";
constexpr std::u32string_view kJapanese =
    U"のひずみせん断軸変位応力差主間隙水圧側背供試体高直径時経過荷重体積測定番号面排有効過剰圧縮力"
    U"平均日量読計試料度温有初期直最大";
constexpr std::u32string_view kKorean =
    U"시험번호시간축변위응력차변형률간극수압구속배체적하중높이직경단면유효과잉측정값온도일시공시료"
    U"심도전단압밀주평균최대";
constexpr std::u32string_view kOfUnits = U"°²³";
constexpr std::u32string_view kSigns = U"\u00A0´§‰µ±·σεΔδτφγ′’“”‘–—×…®©½¼№：（），、。・ー％℃";

constexpr std::array kPages{
    CodePage{"Windows-1252", "CP1252", 0, kWestern, 0xA1, 0xFF, true, false},
    CodePage{"Windows-1254", "CP1254", -5, kTurkish, 0xA1, 0x15F, true, false},
    CodePage{"Windows-1250", "CP1250", -5, kCentral, 0xA1, 0x17E, true, false},
    CodePage{"Windows-1251", "CP1251", -2, kRussian, 0x410, 0x44F, false, true},
    CodePage{"GB18030", "GB18030", -2, kChinese, 0x4E00, 0x9FFF, false, false},
    CodePage{"Shift-JIS", "CP932", -3, kJapanese, 0x3041, 0x9FFF, false, false},
    CodePage{"EUC-KR", "CP949", -3, kKorean, 0xAC00, 0xD7A3, false, false}};

bool is_ascii_letter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The words with bytes above 0x7F, each once.
std::set<std::string_view> find_words(std::string_view bytes) {
  constexpr std::size_t kMaxWords = 2000;
  constexpr std::string_view kBetween = "\t\r\n,;\"";  // no second bytes of characters
  std::set<std::string_view> words;
  while (!bytes.empty() && words.size() < kMaxWords) {
    const auto begin = bytes.find_first_not_of(kBetween);
    if (begin == std::string_view::npos) break;
    bytes.remove_prefix(begin);
    const auto end = std::min(bytes.find_first_of(kBetween), bytes.size());
    const auto word = bytes.substr(0, end);
    if (std::ranges::any_of(word, [](char c) { return c < 0; })) words.insert(word);
    bytes.remove_prefix(end);
  }
  return words;
}

/// A character beyond ASCII with its neighbours. Each combination counts once: what a file repeats
/// in each heading ("mm³") adds no evidence.
using Place = std::array<char32_t, 3>;

class Decoder {
 public:
  explicit Decoder(const char* name) : handle_(iconv_open("UTF-32LE", name)) {}
  ~Decoder() {
    if (is_open()) iconv_close(handle_);
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// NOLINTNEXTLINE(performance-no-int-to-ptr): the value that iconv_open defines for a failure
  bool is_open() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  /// Characters of a word; 0 for bytes that are none.
  std::u32string decode(std::string_view word) {
    std::string bytes(word);
    std::u32string out(2 * bytes.size() + 1, U'\0');
    char* in = bytes.data();
    std::size_t left = bytes.size();
    char* to = reinterpret_cast<char*>(out.data());
    const char* const begin = to;
    std::size_t room = out.size() * sizeof(char32_t);
    while (left > 0) {
      if (iconv(handle_, &in, &left, &to, &room) != static_cast<std::size_t>(-1)) break;
      ++in;
      --left;
      to += sizeof(char32_t);
      room -= sizeof(char32_t);
    }
    iconv(handle_, nullptr, nullptr, nullptr, nullptr);
    out.resize(static_cast<std::size_t>(to - begin) / sizeof(char32_t));
    return out;
  }

 private:
  iconv_t handle_;
};

double log_odds_of(const CodePage& page, const Place& place) {
  constexpr double kInvalid = -25;
  constexpr double kRare = -16;  // a character that no heading has
  // Fractions of the text.
  constexpr double kOther = 0.08;
  constexpr double kCommon = 0.75;
  constexpr double kPowers = 0.1;
  constexpr double kSign = 0.07;
  constexpr double kWrongPlace = -4;      // a Latin letter apart from others, another among them
  constexpr char32_t kHalfKana = 0xFF61;  // Katakana of half width, of old Japanese programs
  constexpr std::size_t kHalfKanas = 63;
  const auto [before, c, after] = place;
  if (c == 0) return kInvalid;
  const auto share = [](double fraction, std::size_t count) {
    return std::log(fraction / static_cast<double>(count));
  };
  if (kOfUnits.find(c) != std::u32string_view::npos) return share(kPowers, kOfUnits.size());
  if (kSigns.find(c) != std::u32string_view::npos) return share(kSign, kSigns.size());
  double odds = kRare;
  if (page.common.find(c) != std::u32string_view::npos)
    odds = share(kCommon, page.common.size());
  else if (c >= page.from && c <= page.to)
    odds = share(kOther, page.to - page.from + 1);
  else if (c >= kHalfKana && c < kHalfKana + kHalfKanas)
    odds = share(kOther, kHalfKanas);
  const bool beside = is_ascii_letter(before) || is_ascii_letter(after);
  const bool wrong = page.is_latin ? before > 0x7F || !beside : page.is_alphabet && beside;
  return odds + (wrong ? kWrongPlace : 0);
}

/// Brackets of ASCII that are open at the end of a text.
template <class Text>
std::ptrdiff_t open_brackets(const Text& text) {
  return std::ranges::count(text, '[') + std::ranges::count(text, '(') -
         std::ranges::count(text, ']') - std::ranges::count(text, ')');
}

double log_odds_of(const CodePage& page, const std::set<std::string_view>& words) {
  constexpr double kOpenBracket = -12;  // the second byte of a character closes it in ASCII
  Decoder decoder(page.iconv_name);
  if (!decoder.is_open()) return -HUGE_VAL;
  std::set<Place> places;
  double sum = page.prior;
  for (const auto word : words) {
    const auto text = decoder.decode(word);
    if (open_brackets(word) == 0 && open_brackets(text) != 0) sum += kOpenBracket;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == 0 || text[i] > 0x7F)
        places.insert(
            {i > 0 ? text[i - 1] : U' ', text[i], i + 1 < text.size() ? text[i + 1] : U' '});
  }
  for (const Place& place : places) sum += log_odds_of(page, place);
  return sum;
}

}  // namespace

std::string find_code_page(std::string_view first, std::string_view last) {
  if (!last.empty()) {  // without the lines that are cut
    first = first.substr(0, first.rfind('\n'));
    last.remove_prefix(std::min(last.find('\n'), last.size()));
  }
  auto words = find_words(first);
  words.merge(find_words(last));
  const auto* const best = std::ranges::max_element(
      kPages, {}, [&](const CodePage& page) { return log_odds_of(page, words); });
  return best->name;
}

}  // namespace triax::lab
