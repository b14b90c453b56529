#include "facenav/segmentation/segmenter.h"
