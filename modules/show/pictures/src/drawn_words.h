#pragma once
// Words in pictures. No other file of this module draws letters, so that no word of the window stays in
// another language than the window. Private to pictures.

#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

namespace facenav::pictures {

/// How letters look; the values are those of cv::putText.
struct Letters {
  double scale;
  cv::Scalar colour;
  int thickness = 1;
  int font = cv::FONT_HERSHEY_SIMPLEX;
  int line = cv::LINE_AA;
  std::optional<cv::Scalar> edge = {};  // its colour, for words on a picture of any brightness
};

/// Draws English words of a picture that a window shows, by the window's painter (pictures/picture_words.h)
/// or in OpenCV's letters. They begin at `base_px`, on their base line. `image`: 8-bit RGB.
void drawShownWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                    const Letters& letters);
/// Draws words of a picture that only files hold: always in English, and "?" for a letter that OpenCV lacks.
void drawFileWords(cv::Mat& image, const std::string& words, const cv::Point& base_px,
                   const Letters& letters);
/// Size of the words in OpenCV's letters.
cv::Size sizeOfWords(const std::string& words, const Letters& letters);

}  // namespace facenav::pictures
