#include "facenav/anatomy/face_norms.h"

namespace facenav::anatomy {
namespace {

constexpr const char* kFarkas = "Farkas 1994, North American whites, without a second population";
constexpr const char* kInnerCorners =
    "67 studies pooled, 22 638 people (PMC9029890): 31.2 (1.5) Middle Eastern, 31.4 (2.5) White, 36.4 (1.6) "
    "Asian, 38.5 "
    "(3.2) African";
constexpr const char* kNoseHeight =
    "Farkas 1994; Kenyan men 51.0 (1.9), women 47.6 (3.1) (Virdi 2019, doi 10.1186/s40902-019-0191-7)";
constexpr const char* kNoseWidth =
    "Farkas 1994; Kenyan men 43.2 (3.8), women 40.7 (3.7) (Virdi 2019, doi 10.1186/s40902-019-0191-7)";
constexpr const char* kFaceWidth =
    "Farkas 1994; Kenyan men 134 (5), women 130 (4) (Virdi 2019, doi 10.1186/s40902-019-0191-7)";
constexpr const char* kHeadWidth = "ANSUR II 2012, men 154 (6), women 148 (5)";
constexpr const char* kHeadLength =
    "ANSUR II 2012, men 200 (7), women 190 (7); British women 180 (7) (anthropometry tables of the City "
    "University of "
    "Hong Kong)";

FaceNorm of(const char* name, const char* from, const char* to, double low_mm, double high_mm,
            const char* source = kFarkas) {
  return {name, from, to, Norm(name, "mm", low_mm, high_mm, "adults, both sexes", source)};
}

}  // namespace

const std::vector<FaceNorm>& faceNorms() {
  static const std::vector<FaceNorm> all{
      of("inner corners of the eyes", "endocanthion R", "endocanthion L", 26, 45, kInnerCorners),
      of("centres of the closed lids", "lid centre R", "lid centre L", 54, 74),
      of("nose length, root to tip", "nasion", "pronasale", 37, 58),
      of("nose height, root to base", "nasion", "subnasale", 41, 62, kNoseHeight),
      of("nose depth, base to tip", "subnasale", "pronasale", 14, 26),
      of("nose width over the wings", "alare R", "alare L", 27, 51, kNoseWidth),
      {"nose tip to inner corner of the right eye", "pronasale", "endocanthion R", std::nullopt},
      {"nose tip to inner corner of the left eye", "pronasale", "endocanthion L", std::nullopt},
      of("nose root to chin", "nasion", "pogonion", 88, 125),
      of("width of the face", "zygion R", "zygion L", 115, 155, kFaceWidth),
      of("ear to ear (tragus)", "tragion R", "tragion L", 122, 160),
      of("right tragus to nose root", "tragion R", "nasion", 105, 135),
      of("left tragus to nose root", "tragion L", "nasion", 105, 135),
      of("right tragus to nose tip", "tragion R", "pronasale", 118, 155),
      of("left tragus to nose tip", "tragion L", "pronasale", 118, 155),
      of("width of the head", "euryon R", "euryon L", 134, 168, kHeadWidth),
      of("length of the head", "glabella", "opisthocranion", 166, 214, kHeadLength),
  };
  return all;
}

}  // namespace facenav::anatomy
