#include "scene_banner.h"

#include <vtkTextProperty.h>
#include <vtkViewport.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "facenav/scene/palette.h"
#include "scene_text.h"

namespace facenav::scene {
namespace {

constexpr int kFontSize = 22, kSmallestFontSize = 8, kMostLines = 3;
constexpr int kMargin_px = 6;         // between the words and the view's edges
constexpr double kMostHeight = 0.4;   // largest share of the view's height
constexpr double kUsualPlace = 0.90;  // height of the text's middle in the view
constexpr const char* kSide = "  ";   // padding of the dark box, left and right of each line

/// Adds a space behind the Japanese comma, where a line may end too.
std::string withBreaks(std::string words) {
  const std::string comma = "\u3001";
  for (auto at = words.find(comma); at != std::string::npos; at = words.find(comma, at + comma.size()))
    words.insert(at + comma.size(), " ");
  return words;
}

/// Breaks the text at spaces into lines of `longest` characters at most; a longer word gets a line of its
/// own.
std::vector<std::string> brokenAt(const std::string& words, std::size_t longest) {
  std::vector<std::string> lines;
  std::istringstream stream(withBreaks(words));
  for (std::string word; stream >> word;)
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= longest)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  return lines;
}

}  // namespace

std::string inLines(const std::string& words, int count) {
  std::size_t longest = words.size() / std::size_t(std::max(1, count));
  auto lines = brokenAt(words, longest);
  while (lines.size() > std::size_t(std::max(1, count))) lines = brokenAt(words, ++longest);
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "\n") + (kSide + line) + kSide;
  return all;
}

SceneBanner::SceneBanner() {
  vtkTextProperty* style = actor_->GetTextProperty();
  style->SetFontSize(kFontSize);
  style->BoldOn();
  style->SetJustificationToCentered();
  style->SetVerticalJustificationToCentered();
  style->SetColor(palette::kText[0], palette::kText[1], palette::kText[2]);
  style->SetBackgroundColor(0.02, 0.02, 0.025);
  style->SetBackgroundOpacity(0.82);
  actor_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor_->SetPosition(0.5, kUsualPlace);
  actor_->VisibilityOff();
}

void SceneBanner::setWords(const std::string& words) {
  actor_->SetVisibility(!words.empty());
  if (words == words_) return;
  words_ = words;
  is_outdated_ = true;
}

void SceneBanner::setTextScale(double scale) {
  text_scale_ = scale;
  is_outdated_ = true;
}

bool SceneBanner::fitsInto(vtkViewport* viewport, const std::string& lines, int font_size) {
  facenav::scene::setWords(*actor_, lines);
  actor_->GetTextProperty()->SetFontSize(font_size);
  double size_px[2];
  actor_->GetSize(viewport, size_px);
  const double width_px = fitted_to_px_[0], height_px = fitted_to_px_[1];
  const double highest = 1.0 - (0.5 * size_px[1] + kMargin_px) / std::max(1.0, height_px);
  actor_->SetPosition(0.5, std::min(kUsualPlace, highest));
  return size_px[0] <= width_px - 2 * kMargin_px && size_px[1] <= kMostHeight * height_px;
}

void SceneBanner::fit(vtkViewport* viewport) {
  const std::array<int, 2> size_px{viewport->GetSize()[0], viewport->GetSize()[1]};
  if (words_.empty() || (!is_outdated_ && size_px == fitted_to_px_)) return;
  is_outdated_ = false;
  fitted_to_px_ = size_px;
  for (double size = kFontSize * text_scale_; size >= kSmallestFontSize; size *= 0.85)
    for (int lines = 1; lines <= kMostLines; ++lines)
      if (fitsInto(viewport, inLines(words_, lines), int(std::lround(size)))) return;
}

}  // namespace facenav::scene
