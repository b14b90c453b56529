#include "genicam_picture.h"

#include <array>
#include <opencv2/imgproc.hpp>

namespace facenav::capture {
namespace {

struct GenicamFormat {
  ArvPixelFormat code;
  const char* name;
  int type;            // OpenCV type of the buffer
  int to_grey;         // cv::ColorConversionCodes, -1: none
  double scale = 1.0;  // factor to 8 bits
};

// Known formats in the order of preference. OpenCV names a Bayer pattern by its second row.
const std::array<GenicamFormat, 10> kGenicamFormats = {{
    {ARV_PIXEL_FORMAT_MONO_8, "Mono8", CV_8UC1, -1},
    {ARV_PIXEL_FORMAT_MONO_10, "Mono10", CV_16UC1, -1, 255.0 / 1023},
    {ARV_PIXEL_FORMAT_MONO_12, "Mono12", CV_16UC1, -1, 255.0 / 4095},
    {ARV_PIXEL_FORMAT_MONO_16, "Mono16", CV_16UC1, -1, 255.0 / 65535},
    {ARV_PIXEL_FORMAT_BAYER_GR_8, "BayerGR8", CV_8UC1, cv::COLOR_BayerGB2GRAY},
    {ARV_PIXEL_FORMAT_BAYER_RG_8, "BayerRG8", CV_8UC1, cv::COLOR_BayerBG2GRAY},
    {ARV_PIXEL_FORMAT_BAYER_GB_8, "BayerGB8", CV_8UC1, cv::COLOR_BayerGR2GRAY},
    {ARV_PIXEL_FORMAT_BAYER_BG_8, "BayerBG8", CV_8UC1, cv::COLOR_BayerRG2GRAY},
    {ARV_PIXEL_FORMAT_YUV_422_YUYV_PACKED, "YUV422_8", CV_8UC2, cv::COLOR_YUV2GRAY_YUY2},
    {ARV_PIXEL_FORMAT_RGB_8_PACKED, "RGB8", CV_8UC3, cv::COLOR_RGB2GRAY},
}};

cv::Mat convertToGrey(const cv::Mat& raw, const GenicamFormat& format) {
  cv::Mat grey;
  if (format.to_grey >= 0)
    cv::cvtColor(raw, grey, format.to_grey);
  else
    raw.convertTo(grey, CV_8U, format.scale);
  return grey;
}

}  // namespace

std::string chooseGenicamFormat(ArvCamera* camera, const std::string& wanted) {
  GenicamCall call;
  guint count = 0;
  const std::unique_ptr<const char*, decltype(&g_free)> names(
      arv_camera_dup_available_pixel_formats_as_strings(camera, &count, call), g_free);
  for (const auto& format : kGenicamFormats)
    for (guint i = 0; names && i < count; ++i)
      if (std::string(names.get()[i]) == format.name && (wanted.empty() || wanted == format.name))
        return format.name;
  return "";
}

cv::Mat decodeGrey(ArvBuffer* buffer) {
  std::size_t size = 0;
  const void* bytes = arv_buffer_get_image_data(buffer, &size);
  const ArvPixelFormat code = arv_buffer_get_image_pixel_format(buffer);
  const int width = arv_buffer_get_image_width(buffer), height = arv_buffer_get_image_height(buffer);
  for (const auto& format : kGenicamFormats) {
    if (format.code != code) continue;
    const std::size_t expected =
        std::size_t(width) * std::size_t(height) * std::size_t(CV_ELEM_SIZE(format.type));
    if (!bytes || size < expected) return {};
    return convertToGrey(cv::Mat(height, width, format.type, const_cast<void*>(bytes)), format);
  }
  return {};
}

}  // namespace facenav::capture
