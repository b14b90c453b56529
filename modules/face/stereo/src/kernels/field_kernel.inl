// Body of the field kernels, included by field_kernel_base.cpp and field_kernel_avx2.cpp inside an anonymous
// namespace.

constexpr float kLeastNoise = 0.3f;  // grey levels squared: quantisation of both images
constexpr float kLeastGain = 0.2f, kMostGain = 5.0f;
constexpr float kLargestChange_px = 0.8f;
// Variances of right image and gradient below these (grey levels squared) carry no disparity; they keep the
// division defined.
constexpr float kFlat = 0.05f;
// Interpolating the images smooths their noise: what is left at single pixels is this share of what counts
// over a window (cubic B-splines at a random phase, both images and both axes).
constexpr float kNoiseShare = 0.6f;

inline float between(float value, float low, float high) {
  value = value > low ? value : low;  // no number: low
  return value < high ? value : high;
}

// near, far: value three quarters of the way to `near`, or `near` itself across a jump.
inline float interpolated(float near, float far) {
  const float step = far - near;
  return step < kJump_px && step > -kJump_px ? near + 0.25f * step : near;
}

// Node row -> pixel columns 0 .. 2 * columns - 1.
inline void spreadRow(const float* __restrict nodes, int columns, float* __restrict pixels) {
  pixels[0] = nodes[0];
  pixels[1] = interpolated(nodes[0], nodes[columns > 1 ? 1 : 0]);
  for (int i = 1; i + 1 < columns; ++i) {
    pixels[2 * i] = interpolated(nodes[i], nodes[i - 1]);
    pixels[2 * i + 1] = interpolated(nodes[i], nodes[i + 1]);
  }
  if (columns > 1) pixels[2 * columns - 2] = interpolated(nodes[columns - 1], nodes[columns - 2]);
  pixels[2 * columns - 1] = nodes[columns - 1];
}

inline void pixelRow(const Nodes& n, const float* field, int y, int width, float* scratch,
                     float* __restrict row) {
  const int near = y / 2 < n.rows ? y / 2 : n.rows - 1;
  int far = near + (y % 2 ? 1 : -1);
  far = far < 0 ? 0 : (far >= n.rows ? n.rows - 1 : far);
  const float* __restrict a = field + std::int64_t(near) * n.stride;
  const float* __restrict b = field + std::int64_t(far) * n.stride;
  float* __restrict mixed = scratch;
  float* __restrict spread = scratch + n.columns;
  for (int i = 0; i < n.columns; ++i) mixed[i] = interpolated(a[i], b[i]);
  spreadRow(mixed, n.columns, spread);
  for (int x = 0; x < width; ++x) row[x] = spread[x];
}

// Right row at x - d + shift with its derivative, by cubic B-spline; valid: 1 or 0.
inline void warpRow(const ImageRows& im, int y, const float* __restrict d, float* __restrict taps,
                    float* __restrict value, float* __restrict gradient, float* __restrict valid) {
  const float* right = im.right + std::int64_t(y) * im.right_stride;
  const int width = im.width;
  const float low = float(im.right_first[y] > 1 ? im.right_first[y] : 1);
  const float high = float((im.right_end[y] < im.right_width - 2 ? im.right_end[y] : im.right_width - 2) - 1);
  const float highest = high > low ? high : low;
  const int left_first = im.left_first[y], left_end = im.left_end[y];
  float* __restrict t0 = taps;
  float* __restrict t1 = taps + width;
  float* __restrict t2 = taps + 2 * width;
  float* __restrict t3 = taps + 3 * width;
  float* __restrict place = taps + 4 * width;  // whole columns, which fit a float exactly
  float* __restrict fraction = taps + 5 * width;
  for (int x = 0; x < width; ++x) {
    const float wanted = float(x + im.right_shift) - d[x];
    const float at = between(wanted, low, highest);  // d that is no number: `low`
    const int whole = int(at);
    place[x] = float(whole);
    fraction[x] = at - float(whole);
    const bool is_in = wanted >= low && wanted <= high && x >= left_first && x < left_end;
    valid[x] = is_in ? 1.0f : 0.0f;
  }
  for (int x = 0; x < width; ++x) {
    const float* at = right + int(place[x]);
    t0[x] = at[-1];
    t1[x] = at[0];
    t2[x] = at[1];
    t3[x] = at[2];
  }
  for (int x = 0; x < width; ++x) {
    const float t = fraction[x], u = 1.0f - t;
    const float a = u * u, b = t * t;
    const float w0 = a * u * (1.0f / 6), w3 = b * t * (1.0f / 6);
    const float w1 = (2.0f / 3) - b + 0.5f * b * t, w2 = (2.0f / 3) - a + 0.5f * a * u;
    value[x] = w0 * t0[x] + w1 * t1[x] + w2 * t2[x] + w3 * t3[x];
    const float g1 = 1.5f * b - 2.0f * t, g2 = 2.0f * u - 1.5f * a;
    gradient[x] = g1 * t1[x] + g2 * t2[x] + 0.5f * (b * t3[x] - a * t0[x]);
  }
}

// Adds one pixel row's products to the node row's sums (channels side by side, `columns` apart).
inline void addProducts(const ImageRows& im, int y, int columns, const float* __restrict right,
                        const float* __restrict gradient, const float* __restrict valid,
                        float* __restrict product, float* __restrict sums) {
  const float* __restrict left = im.left + std::int64_t(y) * im.left_stride;
  const int width = im.width, padded = 2 * columns;
  float* __restrict m = product;
  float* __restrict r = product + padded;
  float* __restrict g = product + 2 * padded;
  float* __restrict l = product + 3 * padded;
  float* __restrict rr = product + 4 * padded;
  float* __restrict rg = product + 5 * padded;
  float* __restrict gg = product + 6 * padded;
  float* __restrict lr = product + 7 * padded;
  float* __restrict lg = product + 8 * padded;
  float* __restrict ll = product + 9 * padded;
  for (int x = 0; x < width; ++x) {
    const float w = valid[x], rw = w * right[x], gw = w * gradient[x], level = left[x] - kMiddle_grey,
                lw = w * level;
    m[x] = w;
    r[x] = rw;
    g[x] = gw;
    l[x] = lw;
    rr[x] = rw * right[x];
    rg[x] = rw * gradient[x];
    gg[x] = gw * gradient[x];
    lr[x] = lw * right[x];
    lg[x] = lw * gradient[x];
    ll[x] = lw * level;
  }
  for (int channel = 0; channel < kChannels; ++channel) {
    const float* __restrict from = product + channel * padded;
    float* __restrict to = sums + channel * columns;
    for (int i = 0; i < columns; ++i) to[i] += from[2 * i] + from[2 * i + 1];
  }
}

inline void smoothAlong(const float* __restrict from, const Window& window, int columns,
                        float* __restrict to) {
  const int r = window.radius;
  for (int i = 0; i < columns; ++i) to[i] = window.weights[0] * from[i];
  for (int k = 1; k <= r; ++k) {
    const float w = window.weights[k];
    for (int i = 0; i < columns; ++i) to[i] += w * (from[i - k] + from[i + k]);
  }
}

// sums: the window's middle row of a ring of rows, each kChannels * columns; to: with margins for
// smoothAlong.
inline void smoothAcross(float* const* rows, const Window& window, int length, float* __restrict to) {
  const int r = window.radius;
  const float* __restrict middle = rows[r];
  for (int i = 0; i < length; ++i) to[i] = window.weights[0] * middle[i];
  for (int k = 1; k <= r; ++k) {
    const float w = window.weights[k];
    const float* __restrict above = rows[r - k], * __restrict below = rows[r + k];
    for (int i = 0; i < length; ++i) to[i] += w * (above[i] + below[i]);
  }
}

inline void solveRow(const float* const* s, float independent, int columns, float* __restrict change,
                     float* __restrict sigma, float* __restrict correlation) {
  for (int i = 0; i < columns; ++i) {
    const float m = s[0][i] + 1e-6f, inverse = 1.0f / m;
    const float r = s[1][i] * inverse, g = s[2][i] * inverse, l = s[3][i] * inverse;
    const float rr = s[4][i] * inverse - r * r + kFlat, rg = s[5][i] * inverse - r * g;
    const float gg = s[6][i] * inverse - g * g + kFlat, lr = s[7][i] * inverse - l * r;
    const float lg = s[8][i] * inverse - l * g, ll = s[9][i] * inverse - l * l;
    const float determinant = rr * gg - rg * rg;
    const float least = 1e-3f * rr * gg;
    const float divisor = 1.0f / (determinant > least ? determinant : least);
    const float raw_gain = (lr * gg - lg * rg) * divisor;
    // The gain is the ratio of the contrasts. A regression's is too small by the noise of the right picture, and a
    // shading that it does not explain moves the disparity.
    const float ratio = lr > 0.0f ? std::sqrt((ll > kFlat ? ll : kFlat) / rr) : kLeastGain;
    const float gain = between(ratio, kLeastGain, kMostGain);
    const float unexplained = lg - gain * rg, slope = unexplained / gg;
    const float residual = ll - 2.0f * gain * lr + gain * gain * rr - slope * unexplained;
    const float uncorrelated = ll - raw_gain * lr - (lg * rr - lr * rg) * divisor * lg;
    const float noise = (residual > 0 ? residual : 0.0f) + kLeastNoise;
    // 2 x 2 pixels a node: m is the share of the window that is valid, in pixels of 4 a node.
    const float count = 0.25f * m * independent;
    change[i] = between(-slope / gain, -kLargestChange_px, kLargestChange_px);
    sigma[i] =
        std::sqrt(noise * rr * divisor / (kNoiseShare * gain * gain * (count > 1e-3f ? count : 1e-3f)));
    correlation[i] = raw_gain > kLeastGain && raw_gain < kMostGain && m > 2.0f
                         ? 1.0f - uncorrelated / (ll + kLeastNoise)
                         : 0.0f;
  }
}

inline void step(const ImageRows& im, const Nodes& n, const float* field, const Window& window, int first,
                 int last, float* scratch, const Step& out) {
  const int columns = n.columns, r = window.radius, length = kChannels * columns, padded = 2 * columns;
  // Row arrays, then the ring of node rows, then the window's sums with margins.
  float* d = scratch;
  float* spread = d + padded;               // pixelRow's own: columns + padded
  float* taps = spread + columns + padded;  // 6 rows
  float* value = taps + 6 * padded;
  float *gradient = value + padded, *valid = gradient + padded;
  float* product = valid + padded;  // kChannels rows
  float* ring = product + kChannels * padded;
  float* across = ring + std::int64_t(2 * kLargestRadius + 1) * length;  // margins between channels
  float* along = across + kChannels * (columns + 2 * kLargestRadius) + 2 * kLargestRadius;
  const int turns = 2 * r + 1;
  for (int i = 0; i < kChannels * padded; ++i) product[i] = 0;  // the pixel beyond an odd width
  float* rows[2 * kLargestRadius + 1];
  const float* sums[kChannels];
  for (int row = first - r; row < last + r; ++row) {
    const int slot = (row - first + r) % turns;
    float* node_row = ring + std::int64_t(slot) * length;
    for (int i = 0; i < length; ++i) node_row[i] = 0;
    if (row >= 0 && row < n.rows)
      for (int y = 2 * row; y < 2 * row + 2 && y < im.height; ++y) {
        pixelRow(n, field, y, im.width, spread, d);
        warpRow(im, y, d, taps, value, gradient, valid);
        addProducts(im, y, columns, value, gradient, valid, product, node_row);
      }
    const int middle = row - r;
    if (middle < first) continue;
    for (int k = 0; k < turns; ++k) rows[k] = ring + std::int64_t((middle - first + k) % turns) * length;
    smoothAcross(rows, window, length, along);
    // Spread the channels apart so that the window reads zeros beyond both ends of a row.
    const int pitch = columns + 2 * kLargestRadius;
    for (int channel = 0; channel < kChannels; ++channel) {
      float* to = across + channel * pitch + kLargestRadius;
      for (int k = 0; k < kLargestRadius; ++k) to[-1 - k] = to[columns + k] = 0;
      for (int i = 0; i < columns; ++i) to[i] = along[channel * columns + i];
    }
    for (int channel = 0; channel < kChannels; ++channel) {
      smoothAlong(across + channel * pitch + kLargestRadius, window, columns, along + channel * columns);
      sums[channel] = along + channel * columns;
    }
    const std::int64_t at = std::int64_t(middle) * n.stride;
    solveRow(sums, window.independent, columns, out.change + at, out.sigma + at, out.correlation + at);
  }
}
