// Body of the plane kernels, included by plane_kernel_base.cpp and plane_kernel_avx2.cpp inside an anonymous
// namespace.

constexpr float kLeastNoise = 0.3f;  // grey levels squared: quantisation of both images
constexpr float kLeastGain = 0.2f, kMostGain = 5.0f;
constexpr float kLargestChange_px = 1.0f, kSteepest = 2.0f;
constexpr float kSlopePrior =
    0.25f;                        // standard deviation of a slope about its neighbourhood's, before the fit
constexpr float kJump_px = 2.5f;  // planes that disagree by more between them are different surfaces
constexpr float kFlat = 0.05f;    // variance (grey levels squared) that carries nothing
// Interpolating the images smooths their noise: what is left at single pixels is this share of what counts
// over a window (cubic B-splines at a random phase, both images and both axes).
constexpr float kNoiseShare = 0.6f;

inline float between(float value, float low, float high) {
  value = value > low ? value : low;  // no number: low
  return value < high ? value : high;
}
inline float magnitude(float value) { return value < 0 ? -value : value; }

// near and far planes, both taken at one pixel; `share` of the far one, 0 across a jump.
inline float blended(float near, float far, float share) {
  return magnitude(far - near) < kJump_px ? near + share * (far - near) : near;
}

inline void pixelRow(const Field& f, int y, float* __restrict scratch, float* __restrict d) {
  const int columns = f.columns;
  const int row = y / kBlock < f.rows ? y / kBlock : f.rows - 1, k = y - row * kBlock;
  int other = row + (k < 2 ? -1 : 1);
  other = other < 0 || other >= f.rows ? row : other;
  const float v = float(k) - 1.5f, v_other = v + float(kBlock * (row - other));
  const float share = magnitude(v) / float(kBlock);
  const float* __restrict d0 = f.d + std::int64_t(row) * f.stride;
  const float* __restrict b0 = f.b + std::int64_t(row) * f.stride;
  const float* __restrict a0 = f.a + std::int64_t(row) * f.stride;
  const float* __restrict d1 = f.d + std::int64_t(other) * f.stride;
  const float* __restrict b1 = f.b + std::int64_t(other) * f.stride;
  const float* __restrict a1 = f.a + std::int64_t(other) * f.stride;
  float* __restrict value = scratch + 1;  // one column more at either end
  float* __restrict slope = scratch + columns + 3;
#pragma GCC ivdep
  for (int i = 0; i < columns; ++i) {
    const float near = d0[i] + b0[i] * v, far = d1[i] + b1[i] * v_other;
    const bool is_one = magnitude(far - near) < kJump_px;
    value[i] = is_one ? near + share * (far - near) : near;
    slope[i] = is_one ? a0[i] + share * (a1[i] - a0[i]) : a0[i];
  }
  value[-1] = value[0] - kBlock * slope[0];
  slope[-1] = slope[0];
  value[columns] = value[columns - 1] + kBlock * slope[columns - 1];
  slope[columns] = slope[columns - 1];
  for (int i = 0; i < columns; ++i) {
    const float here = value[i], a = slope[i];
    d[4 * i] = blended(here - 1.5f * a, value[i - 1] + 2.5f * slope[i - 1], 0.375f);
    d[4 * i + 1] = blended(here - 0.5f * a, value[i - 1] + 3.5f * slope[i - 1], 0.125f);
    d[4 * i + 2] = blended(here + 0.5f * a, value[i + 1] - 3.5f * slope[i + 1], 0.125f);
    d[4 * i + 3] = blended(here + 1.5f * a, value[i + 1] - 2.5f * slope[i + 1], 0.375f);
  }
}

inline void repeated(const float* __restrict blocks, int columns, float* __restrict pixels) {
  for (int i = 0; i < columns; ++i) {
    pixels[4 * i] = blocks[i];
    pixels[4 * i + 1] = blocks[i];
    pixels[4 * i + 2] = blocks[i];
    pixels[4 * i + 3] = blocks[i];
  }
}

inline void splineRow(const float* __restrict row, const float* __restrict weights, int width,
                      float* __restrict out) {
  static_assert(kSplineRadius == 6, "written out below, in one pass");
  const float w0 = weights[0], w1 = weights[1], w2 = weights[2], w3 = weights[3], w4 = weights[4],
              w5 = weights[5], w6 = weights[6];
  for (int x = 0; x < width; ++x)
    out[x] = w0 * row[x] + w1 * (row[x - 1] + row[x + 1]) + w2 * (row[x - 2] + row[x + 2]) +
             w3 * (row[x - 3] + row[x + 3]) + w4 * (row[x - 4] + row[x + 4]) +
             w5 * (row[x - 5] + row[x + 5]) + w6 * (row[x - 6] + row[x + 6]) - kMiddle_grey;
}

inline void mapRow(const Field& f, const float* __restrict accepted, int y, int first, int end, int width,
                   const float* __restrict disparity, const Output& out) {
  const int whole = width / kBlock;
  const std::int64_t at = std::int64_t(y / kBlock) * f.stride;
  const auto spread = [&](const float* __restrict from, float* __restrict to) {
    for (int i = 0; i < whole; ++i) to[4 * i] = to[4 * i + 1] = to[4 * i + 2] = to[4 * i + 3] = from[i];
    for (int x = kBlock * whole; x < width; ++x) to[x] = from[x / kBlock];
  };
  spread(f.a + at, out.slope_x);
  spread(f.b + at, out.slope_y);
  spread(f.sigma + at, out.sigma);
  spread(accepted, out.disparity);
  float* __restrict d = out.disparity;
  for (int x = 0; x < width; ++x) {
    const bool is_in = (x >= first) & (x < end) & (disparity[x] >= 0.0f) & (d[x] == d[x]);
    d[x] = is_in ? disparity[x] : __builtin_nanf("");
  }
}

struct WarpedRow {
  float *taps, *fraction, *valid;  // four taps of each pixel side by side
};

// The four B-spline coefficients round x - d + shift of each pixel; valid: 1 or 0.
inline void gatherRow(const ImageRows& im, int y, const float* __restrict d, float* __restrict place,
                      const WarpedRow& w) {
  const float* __restrict right = im.right + std::int64_t(y) * im.right_stride;
  const int width = im.width, left_first = im.left_first[y], left_end = im.left_end[y];
  const float low = float(im.right_first[y] > 1 ? im.right_first[y] : 1);
  const float end = float((im.right_end[y] < im.right_width - 2 ? im.right_end[y] : im.right_width - 2) - 1);
  const float high = end > low ? end : low;
  float* __restrict fraction = w.fraction;
  float* __restrict valid = w.valid;
  const float shift = float(im.right_shift);
  for (int x = 0; x < width; ++x) {
    const float wanted = float(x) + shift - d[x];
    const float at = between(wanted, low, high);
    const float whole = float(int(at));
    place[x] = whole;
    fraction[x] = at - whole;
    valid[x] = (wanted == at) & (x >= left_first) & (x < left_end) ? 1.0f : 0.0f;
  }
  float* __restrict taps = w.taps;
  for (int x = 0; x < width; ++x)
    __builtin_memcpy(taps + 4 * x, right + int(place[x]) - 1, 4 * sizeof(float));
}

// Column sums over the block's rows: h, hv, hvv, y, yv, ee, then the photometric ones; `pitch` apart.
constexpr int kColumnSums = 12;

inline void addRow(const ImageRows& im, int y, float v, const WarpedRow& w, const float* __restrict d,
                   const float* __restrict offset, const float* __restrict gain, float* __restrict sums,
                   int pitch) {
  const float* __restrict left = im.left + std::int64_t(y) * im.left_stride;
  const float* __restrict taps = w.taps;
  const float* __restrict fraction = w.fraction;
  const float* __restrict valid = w.valid;
  float* __restrict h0 = sums;
  float* __restrict h1 = sums + pitch;
  float* __restrict h2 = sums + 2 * pitch;
  float* __restrict y0 = sums + 3 * pitch;
  float* __restrict y1 = sums + 4 * pitch;
  float* __restrict ee = sums + 5 * pitch;
  float* __restrict m0 = sums + 6 * pitch;
  float* __restrict sr = sums + 7 * pitch;
  float* __restrict sl = sums + 8 * pitch;
  float* __restrict rr = sums + 9 * pitch;
  float* __restrict lr = sums + 10 * pitch;
  float* __restrict ll = sums + 11 * pitch;
  const int width = im.width;
// The arrays do not overlap, which is more than the compiler can check at run time.
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    const float t = fraction[x], u = 1.0f - t, b = t * t, a = u * u, m = valid[x];
    const float w0 = a * u * (1.0f / 6), w3 = b * t * (1.0f / 6);
    const float w1 = (2.0f / 3) - b + 0.5f * b * t, w2 = (2.0f / 3) - a + 0.5f * a * u;
    const float right = w0 * taps[4 * x] + w1 * taps[4 * x + 1] + w2 * taps[4 * x + 2] + w3 * taps[4 * x + 3];
    const float g1 = 1.5f * b - 2.0f * t, g2 = 2.0f * u - 1.5f * a;
    const float gradient =
        g1 * taps[4 * x + 1] + g2 * taps[4 * x + 2] + 0.5f * (b * taps[4 * x + 3] - a * taps[4 * x]);
    const float l = left[x] - kMiddle_grey, e = m * (l - offset[x] - gain[x] * right),
                g = m * gain[x] * gradient;
    const float h = g * g, wish = h * d[x] - g * e;
    h0[x] += h;
    h1[x] += v * h;
    h2[x] += v * v * h;
    y0[x] += wish;
    y1[x] += v * wish;
    ee[x] += e * e;
    const float mr = m * right, ml = m * l;
    m0[x] += m;
    sr[x] += mr;
    sl[x] += ml;
    rr[x] += mr * right;
    lr[x] += ml * right;
    ll[x] += ml * l;
  }
}

// 4 columns -> one block: plain sum, and with u = -1.5 .. 1.5 and its square.
inline void blockSums(const float* __restrict c, int columns, float* __restrict plain) {
  for (int i = 0; i < columns; ++i) plain[i] = (c[4 * i] + c[4 * i + 3]) + (c[4 * i + 1] + c[4 * i + 2]);
}
inline void blockMoments(const float* __restrict c, int columns, float* __restrict plain,
                         float* __restrict first) {
  for (int i = 0; i < columns; ++i) {
    const float p = c[4 * i], q = c[4 * i + 1], r = c[4 * i + 2], s = c[4 * i + 3];
    plain[i] = (p + s) + (q + r);
    first[i] = 1.5f * (s - p) + 0.5f * (r - q);
  }
}
inline void blockMoments(const float* __restrict c, int columns, float* __restrict plain,
                         float* __restrict first, float* __restrict second) {
  for (int i = 0; i < columns; ++i) {
    const float p = c[4 * i], q = c[4 * i + 1], r = c[4 * i + 2], s = c[4 * i + 3];
    plain[i] = (p + s) + (q + r);
    first[i] = 1.5f * (s - p) + 0.5f * (r - q);
    second[i] = 2.25f * (p + s) + 0.25f * (q + r);
  }
}

// Order of a block's sums: h, hu, huu, hv, huv, hvv, y, yu, yv, ee, then the photometric ones.
enum { kH, kHu, kHuu, kHv, kHuv, kHvv, kY, kYu, kYv, kEe, kM, kR, kL, kRr, kLr, kLl };

// Gain and offset alone (`is_fit` false) are had from one row of each block.
inline void blockRow(const ImageRows& im, const Field& f, int row, bool is_fit, float* scratch, float* out,
                     int out_pitch) {
  const int columns = f.columns, pitch = kBlock * columns + 16;
  float* d = scratch;
  float* offset = d + pitch;
  float* gain = offset + pitch;
  float* place = gain + pitch;
  float* sums = place + pitch;
  float* taps = sums + kColumnSums * pitch;
  const WarpedRow w{taps, taps + 4 * pitch, taps + 5 * pitch};
  for (int i = 0; i < kColumnSums * pitch; ++i) sums[i] = 0;
  repeated(f.offset + std::int64_t(row) * f.stride, columns, offset);
  repeated(f.gain + std::int64_t(row) * f.stride, columns, gain);
  const int first = is_fit ? 0 : 1, end = is_fit ? kBlock : 2;
  for (int k = first; k < end && row * kBlock + k < im.height; ++k) {
    const int y = row * kBlock + k;
    pixelRow(f, y, taps, d);
    gatherRow(im, y, d, place, w);
    addRow(im, y, float(k) - 1.5f, w, d, offset, gain, sums, pitch);
  }
  const auto to = [&](int i) { return out + i * out_pitch; };
  blockMoments(sums, columns, to(kH), to(kHu), to(kHuu));
  blockMoments(sums + pitch, columns, to(kHv), to(kHuv));
  blockSums(sums + 2 * pitch, columns, to(kHvv));
  blockMoments(sums + 3 * pitch, columns, to(kY), to(kYu));
  blockSums(sums + 4 * pitch, columns, to(kYv));
  for (int i = 0; i <= kPhotometric; ++i) blockSums(sums + (5 + i) * pitch, columns, to(kEe + i));
}

// to += w * from, moments shifted by `by` pixels along v.
inline void addAcross(const float* __restrict from, int pitch, int columns, float w, float by,
                      float* __restrict to) {
  const float* __restrict h = from + kH * pitch;
  const float* __restrict hu = from + kHu * pitch;
  const float* __restrict hv = from + kHv * pitch;
  const float* __restrict y = from + kY * pitch;
  for (int s = 0; s < kSums; ++s) {
    const float* __restrict in = from + s * pitch;
    float* __restrict out = to + s * pitch;
    if (s == kHv)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * h[i]);
    else if (s == kHuv)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * hu[i]);
    else if (s == kHvv)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + 2 * by * hv[i] + by * by * h[i]);
    else if (s == kYv)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * y[i]);
    else
      for (int i = 0; i < columns; ++i) out[i] += w * in[i];
  }
}

// The same along u; `from` has kLargestRadius columns of zeros at both ends.
inline void addAlong(const float* __restrict from, int pitch, int columns, float w, int step,
                     float* __restrict to) {
  const float by = float(kBlock * step);
  const float* __restrict h = from + kH * pitch + step;
  const float* __restrict hu = from + kHu * pitch + step;
  const float* __restrict hv = from + kHv * pitch + step;
  const float* __restrict y = from + kY * pitch + step;
  for (int s = 0; s < kSums; ++s) {
    const float* __restrict in = from + s * pitch + step;
    float* __restrict out = to + s * pitch;
    if (s == kHu)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * h[i]);
    else if (s == kHuv)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * hv[i]);
    else if (s == kHuu)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + 2 * by * hu[i] + by * by * h[i]);
    else if (s == kYu)
      for (int i = 0; i < columns; ++i) out[i] += w * (in[i] + by * y[i]);
    else
      for (int i = 0; i < columns; ++i) out[i] += w * in[i];
  }
}

// Gain and offset. Before the first fit (`is_fit` false) by regression, since pictures that do not lie on each other
// yet differ by more than noise. Later by the ratio of the contrasts: a regression's gain is too small by the noise
// of the right picture, and a shading that it does not explain moves the disparity.
inline void solvePhotometry(const float* __restrict s, int pitch, int columns, bool is_fit, float* __restrict offset,
                            float* __restrict gain) {
  for (int i = 0; i < columns; ++i) {
    const float inverse = 1.0f / (s[kM * pitch + i] + 1e-6f);
    const float r = s[kR * pitch + i] * inverse, l = s[kL * pitch + i] * inverse;
    const float rr = s[kRr * pitch + i] * inverse - r * r + kFlat, lr = s[kLr * pitch + i] * inverse - l * r;
    const float ll = s[kLl * pitch + i] * inverse - l * l + kFlat;
    const float ratio = lr > 0.0f ? std::sqrt((ll > kFlat ? ll : kFlat) / rr) : kLeastGain;
    const float k = between(is_fit ? ratio : lr / rr, kLeastGain, kMostGain);
    gain[i] = k;
    offset[i] = l - k * r;
  }
}

inline void solvePlanes(const float* __restrict s, int pitch, int columns, float noise_factor, float full,
                        const float* __restrict d_from, const float* __restrict a_from,
                        const float* __restrict b_from, const float* __restrict a_prior,
                        const float* __restrict b_prior, float* __restrict d_to, float* __restrict a_to,
                        float* __restrict b_to, float* __restrict sigma, float* __restrict correlation) {
  for (int i = 0; i < columns; ++i) {
    const float m = s[kM * pitch + i] + 1e-6f, inverse = 1.0f / m;
    const float l = s[kL * pitch + i] * inverse, ll = s[kLl * pitch + i] * inverse - l * l;
    const float residual = s[kEe * pitch + i] * inverse, noise = residual + kLeastNoise;
    const float prior = noise * (1.0f / (kSlopePrior * kSlopePrior));
    const float d0 = d_from[i], a0 = a_from[i], b0 = b_from[i];
    const float h = s[kH * pitch + i] + 1e-3f * noise, hu = s[kHu * pitch + i], hv = s[kHv * pitch + i];
    const float huu = s[kHuu * pitch + i] + prior, huv = s[kHuv * pitch + i],
                hvv = s[kHvv * pitch + i] + prior;
    const float y = s[kY * pitch + i] + 1e-3f * noise * d0, yu = s[kYu * pitch + i] + prior * a_prior[i],
                yv = s[kYv * pitch + i] + prior * b_prior[i];
    const float m00 = huu * hvv - huv * huv, m01 = hv * huv - hu * hvv, m02 = hu * huv - hv * huu;
    const float determinant = h * m00 + hu * m01 + hv * m02;
    const float least = 1e-6f * h * huu * hvv;
    const float divisor = 1.0f / (determinant > least ? determinant : least);
    const float m11 = h * hvv - hv * hv, m12 = hu * hv - h * huv, m22 = h * huu - hu * hu;
    // Relative to the plane there was: rounding then counts for little.
    const float z = y - h * d0 - hu * a0 - hv * b0, zu = yu - hu * d0 - huu * a0 - huv * b0,
                zv = yv - hv * d0 - huv * a0 - hvv * b0;
    d_to[i] = d0 + between((m00 * z + m01 * zu + m02 * zv) * divisor, -kLargestChange_px, kLargestChange_px);
    a_to[i] = between(a0 + (m01 * z + m11 * zu + m12 * zv) * divisor, -kSteepest, kSteepest);
    b_to[i] = between(b0 + (m02 * z + m12 * zu + m22 * zv) * divisor, -kSteepest, kSteepest);
    sigma[i] = std::sqrt(noise * (1.0f / kNoiseShare) * noise_factor * m00 * divisor);
    const float r = s[kR * pitch + i] * inverse, rr = s[kRr * pitch + i] * inverse - r * r;
    const float lr = s[kLr * pitch + i] * inverse - l * r;
    correlation[i] = m > 0.5f * full && lr > 0.0f ? lr * lr / ((ll + kLeastNoise) * (rr + kLeastNoise)) : 0.0f;
  }
}

inline void step(const ImageRows& im, const Field& from, const Window& window, bool is_fit, int first,
                 int last, float* scratch, const Field& to) {
  const int columns = from.columns, r = window.radius, turns = 2 * r + 1;
  const int pitch = columns + 16;  // with room for zeros at both ends
  float* ring = scratch + 24 * (std::int64_t(kBlock) * columns + 64);
  const std::int64_t size = std::int64_t(kSums) * pitch;
  float* across = ring + (2 * kLargestRadius + 1) * size;
  float* total = across + size;
  float full = 0;  // pixels of a window wholly valid, weighted
  for (int j = -r; j <= r; ++j)
    for (int i = -r; i <= r; ++i)
      full += float(kBlock * kBlock) * window.weights[i < 0 ? -i : i] * window.weights[j < 0 ? -j : j];
  for (int row = first - r; row < last + r; ++row) {
    if (row >= 0 && row < from.rows)
      blockRow(im, from, row, is_fit, scratch, ring + ((row + turns) % turns) * size, pitch);
    const int middle = row - r;
    if (middle < first) continue;
    for (int i = 0; i < size; ++i) across[i] = total[i] = 0;
    for (int j = -r; j <= r; ++j)
      if (middle + j >= 0 && middle + j < from.rows)
        addAcross(ring + ((middle + j + turns) % turns) * size, pitch, columns,
                  window.weights[j < 0 ? -j : j], float(kBlock * j), across + 8);
    for (int i = -r; i <= r; ++i)
      addAlong(across + 8, pitch, columns, window.weights[i < 0 ? -i : i], i, total);
    const std::int64_t at = std::int64_t(middle) * to.stride;
    solvePhotometry(total, pitch, columns, is_fit, to.offset + at, to.gain + at);
    if (is_fit)
      solvePlanes(total, pitch, columns, window.noise_factor, full, from.d + at, from.a + at, from.b + at,
                  from.a_prior + at, from.b_prior + at, to.d + at, to.a + at, to.b + at, to.sigma + at,
                  to.correlation + at);
  }
}
