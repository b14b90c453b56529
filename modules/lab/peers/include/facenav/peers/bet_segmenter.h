#pragma once
// BetSegmenter: a peer method to compare the brain segmentation with. The plain deformable surface after
// Smith (Human Brain Mapping 17, 2002), adapted to heads with a long neck.

#include <memory>

#include "facenav/segmentation/segmenter.h"

namespace facenav::peers {

std::unique_ptr<segmentation::Segmenter> makeBetSegmenter();  // "bet"

}  // namespace facenav::peers
