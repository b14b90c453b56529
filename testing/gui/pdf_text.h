#pragma once
// The words of a PDF as Qt writes it: inflates its streams and turns glyphs into characters by the fonts'
// ToUnicode tables. Blanks are dropped. For tests that search a PDF.

#include <QByteArray>
#include <map>
#include <regex>
#include <string>

namespace facenav::ui::fixtures {

struct PdfObjects {
  std::map<int, std::string> heads, streams;  // by object number; streams are inflated
};

inline std::string inflated(const std::string& bytes) {
  // qUncompress needs the size of the result first; 16 MiB are enough for any page.
  QByteArray packed;
  packed.append(char(1)).append(char(0)).append(char(0)).append(char(0));
  packed.append(bytes.data(), int(bytes.size()));
  const QByteArray plain = qUncompress(packed);
  return plain.isEmpty() ? bytes : plain.toStdString();
}

inline PdfObjects objectsOf(const std::string& pdf) {
  PdfObjects objects;
  for (std::size_t at = 0; (at = pdf.find(" 0 obj", at)) != std::string::npos; at += 6) {
    std::size_t begin = at;
    while (begin > 0 && std::isdigit(static_cast<unsigned char>(pdf[begin - 1]))) --begin;
    if (begin == at) continue;
    const int number = std::stoi(pdf.substr(begin, at - begin));
    const std::size_t end = pdf.find("endobj", at), stream = pdf.find("stream\n", at);
    objects.heads[number] = pdf.substr(at + 6, std::min(end, stream) - at - 6);
    if (stream > end || stream == std::string::npos) continue;
    const std::size_t stop = pdf.find("endstream", stream);
    const std::string bytes = pdf.substr(stream + 7, stop - stream - 7);
    const bool is_packed = objects.heads[number].find("/FlateDecode") != std::string::npos;
    objects.streams[number] = is_packed ? inflated(bytes) : bytes;
  }
  return objects;
}

constexpr const char* kLigatures[] = {"ff", "fi", "fl", "ffi", "ffl"};  // U+FB00 to U+FB04

using Glyphs = std::map<unsigned, unsigned>;  // glyph -> UTF-16 unit

inline Glyphs glyphsOf(const std::string& to_unicode) {
  Glyphs glyphs;
  static const std::regex kRange(
      R"(<([0-9A-Fa-f]{4})>\s*<([0-9A-Fa-f]{4})>\s*(<([0-9A-Fa-f]{4})>|\[([^\]]*)\]))");
  static const std::regex kUnit("<([0-9A-Fa-f]{4})>");
  const auto hex = [](const std::string& text) { return unsigned(std::stoul(text, nullptr, 16)); };
  const std::size_t from = to_unicode.find("beginbfrange");
  const std::string table = from == std::string::npos ? "" : to_unicode.substr(from);
  for (std::sregex_iterator it(table.begin(), table.end(), kRange), none; it != none; ++it) {
    unsigned glyph = hex((*it)[1]);
    if ((*it)[4].matched) {
      for (unsigned unit = hex((*it)[4]); glyph <= hex((*it)[2]); ++glyph, ++unit) glyphs[glyph] = unit;
      continue;
    }
    const std::string list = (*it)[5];
    for (std::sregex_iterator unit(list.begin(), list.end(), kUnit); unit != none; ++unit)
      glyphs[glyph++] = hex((*unit)[1]);
  }
  return glyphs;
}

inline std::string wordsOfPdf(const std::string& pdf) {
  const PdfObjects objects = objectsOf(pdf);
  std::map<int, Glyphs> fonts;
  static const std::regex kToUnicode(R"(/ToUnicode (\d+) 0 R)");
  for (const auto& [number, head] : objects.heads) {
    std::smatch match;
    if (std::regex_search(head, match, kToUnicode) && objects.streams.count(std::stoi(match[1])))
      fonts[number] = glyphsOf(objects.streams.at(std::stoi(match[1])));
  }
  static const std::regex kToken(R"(/F(\d+) [\d.\-]+ Tf|<([0-9A-Fa-f]+)>\s*Tj)");
  std::string words;
  for (const auto& [number, stream] : objects.streams) {
    if (stream.find("> Tj") == std::string::npos) continue;  // a picture or a font
    const Glyphs* font = nullptr;
    for (std::sregex_iterator it(stream.begin(), stream.end(), kToken), none; it != none; ++it) {
      if ((*it)[1].matched) {
        const auto found = fonts.find(std::stoi((*it)[1]));
        font = found == fonts.end() ? nullptr : &found->second;
        continue;
      }
      const std::string run = (*it)[2];
      for (std::size_t i = 0; font && i + 4 <= run.size(); i += 4) {
        const auto unit = font->find(unsigned(std::stoul(run.substr(i, 4), nullptr, 16)));
        if (unit == font->end()) continue;
        if (unit->second > 32 && unit->second < 127) words += char(unit->second);
        if (unit->second >= 0xFB00 && unit->second <= 0xFB04) words += kLigatures[unit->second - 0xFB00];
      }
    }
  }
  return words;
}

}  // namespace facenav::ui::fixtures
