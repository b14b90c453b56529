// Body of fitRow..., included by subpixel_kernel_base.cpp and subpixel_kernel_avx2.cpp inside an anonymous
// namespace.

// Not unrolled: GCC unrolls short loops before it looks for SIMD in them, and then finds none.
#define FACENAV_LANES(u) _Pragma("GCC unroll 1") for (int u = 0; u < kLanes; ++u)

constexpr int kMostIterations = 6;
constexpr float kConverged_px = 0.01f, kConvergedSlope = 0.004f;
constexpr float kFarthestFromStart_px = 1.6f;
constexpr float kLeastNoise_grey = 0.5f;  // quantisation to 8 bits and interpolation
constexpr float kSlopePrior = 1.0f;       // standard deviation of a slope before anything is seen
constexpr float kSameSurface_px = 1.5f;
constexpr int kFine = 4;  // = kFineSteps

struct Window {
  float left[kLargestWindow][kLanes], right[kLargestWindow][kLanes], gradient[kLargestWindow][kLanes];
  float shape[kLargestWindow][kLanes];  // what the surface's disparity has beyond the plane
};

inline float sum(const float* lanes, int n) {
  float total = 0;
  for (int i = 0; i < n; ++i) total += lanes[i];
  return total;
}

inline void loadLeft(const Images& im, int x, int y, Window& w) {
  const int half = im.window / 2;
  for (int v = 0; v < im.window; ++v) {
    const float* row = im.left + (y + v - half) * im.left_stride + x - half;
    FACENAV_LANES(u) w.left[v][u] = u < im.window ? row[u] : 0.0f;
  }
}

inline void loadRight(const Images& im, int x, int y, const Plane& plane, Window& w) {
  const int half = im.window / 2;
  const float last = float(im.right_width * kFine - 2);
  for (int v = 0; v < im.window; ++v) {
    const float* row = im.right_fine + (y + v - half) * im.right_stride;
    const float start = float(x + im.right_shift) - plane.d - plane.b * float(v - half);
    // Three loops, since only the middle one cannot be SIMD without a gather.
    int index[kLanes];
    float fraction[kLanes], here[kLanes], next[kLanes];
    FACENAV_LANES(u) {
      float at = float(kFine) * (start + (1.0f - plane.a) * float(u - half) - w.shape[v][u]);
      at = at < 0.0f ? 0.0f : at;
      at = at > last ? last : at;
      index[u] = int(at);
      fraction[u] = at - float(index[u]);
    }
    for (int u = 0; u < kLanes; ++u) {
      here[u] = row[index[u]];
      next[u] = row[index[u] + 1];
    }
    FACENAV_LANES(u) {
      const float step = next[u] - here[u];
      w.right[v][u] = here[u] + fraction[u] * step;
      w.gradient[v][u] = float(kFine) * step;
    }
  }
}

struct Moments {
  float mean = 0, variance = 0;
};

inline Moments leftMoments(const Window& w, int n) {
  float s[kLanes] = {}, ss[kLanes] = {};
  for (int v = 0; v < n; ++v) FACENAV_LANES(u) {
      s[u] += w.left[v][u];
      ss[u] += w.left[v][u] * w.left[v][u];
    }
  const float count = float(n * n), mean = sum(s, n) / count;
  return {mean, sum(ss, n) / count - mean * mean};
}

struct Photometry {
  float gain, offset, correlation;
};

inline Photometry fitPhotometry(const Window& w, int n, const Moments& left) {
  float s[kLanes] = {}, ss[kLanes] = {}, sl[kLanes] = {};
  for (int v = 0; v < n; ++v) FACENAV_LANES(u) {
      s[u] += w.right[v][u];
      ss[u] += w.right[v][u] * w.right[v][u];
      sl[u] += w.right[v][u] * w.left[v][u];
    }
  const float count = float(n * n), mean = sum(s, n) / count;
  const float variance = sum(ss, n) / count - mean * mean, covariance = sum(sl, n) / count - mean * left.mean;
  if (!(variance > 1e-3f) || !(left.variance > 1e-3f) || !(covariance > 0)) return {0, 0, 0};
  const float gain = covariance / variance;
  return {gain, left.mean - gain * mean, covariance / std::sqrt(variance * left.variance)};
}

struct Normal {
  float h[6];  // dd, da, db, aa, ab, bb
  float g[3];
  float residual;        // sum of squares
  float centre_texture;  // mean squared gradient of the middle 5 x 5
};

inline Normal normalEquations(const Window& w, int n, const Photometry& photometry) {
  float c0[kLanes] = {}, c1[kLanes] = {}, c2[kLanes] = {}, e0[kLanes] = {}, e1[kLanes] = {}, rr[kLanes] = {};
  const int half = n / 2;
  for (int v = 0; v < n; ++v) {
    const float fv = float(v - half);
    FACENAV_LANES(u) {
      const float r = w.left[v][u] - photometry.gain * w.right[v][u] - photometry.offset;
      const float g = -photometry.gain * w.gradient[v][u];
      const float gg = g * g, gr = g * r;
      c0[u] += gg;
      c1[u] += fv * gg;
      c2[u] += fv * fv * gg;
      e0[u] += gr;
      e1[u] += fv * gr;
      rr[u] += r * r;
    }
  }
  Normal out = {};
  for (int u = 0; u < n; ++u) {
    const float fu = float(u - half);
    out.h[0] += c0[u];
    out.h[1] += fu * c0[u];
    out.h[2] += c1[u];
    out.h[3] += fu * fu * c0[u];
    out.h[4] += fu * c1[u];
    out.h[5] += c2[u];
    out.g[0] += e0[u];
    out.g[1] += fu * e0[u];
    out.g[2] += e1[u];
  }
  out.residual = sum(rr, n);
  for (int v = half - 2; v <= half + 2; ++v)
    for (int u = half - 2; u <= half + 2; ++u)
      out.centre_texture += w.gradient[v][u] * w.gradient[v][u] * photometry.gain * photometry.gain / 25;
  return out;
}

// Solves the 3 x 3 system; also the variance factor of d. False when it is singular.
inline bool solve(const Normal& q, Plane& step, float& variance_factor) {
  const float a = q.h[0], b = q.h[1], c = q.h[2], d = q.h[3], e = q.h[4], f = q.h[5];
  const float m00 = d * f - e * e, m01 = c * e - b * f, m02 = b * e - c * d;
  const float determinant = a * m00 + b * m01 + c * m02;
  if (!(determinant > 1e-6f * a * d * f)) return false;
  const float m11 = a * f - c * c, m12 = b * c - a * e, m22 = a * d - b * b, inverse = 1.0f / determinant;
  step.d = inverse * (m00 * q.g[0] + m01 * q.g[1] + m02 * q.g[2]);
  step.a = inverse * (m01 * q.g[0] + m11 * q.g[1] + m12 * q.g[2]);
  step.b = inverse * (m02 * q.g[0] + m12 * q.g[1] + m22 * q.g[2]);
  variance_factor = m00 * inverse;
  return true;
}

inline float limited(float value, float bound) {
  return value > bound ? bound : (value < -bound ? -bound : value);
}
inline float magnitude(float value) { return value < 0 ? -value : value; }

inline void clearShape(Window& w) {
  for (int v = 0; v < kLargestWindow; ++v) FACENAV_LANES(u) w.shape[v][u] = 0;
}

// Does the fit rest on texture round the pixel itself? Beside a silhouette it rests on the object next to the
// pixel, and the disparity found is that object's: its texture lies to one side, the middle of the window is
// bare.
inline bool isSupported(const Normal& q, int n, const Limits& limits) {
  const float x = q.h[1] / q.h[0], y = q.h[2] / q.h[0], mean_texture = q.h[0] / float(n * n);
  return x * x + y * y <= limits.largest_lever_px * limits.largest_lever_px &&
         q.centre_texture >= limits.least_centre_texture * mean_texture;
}

// `w` holds the shape; the rest of it is filled here.
inline Fit fitWindow(const Images& im, const Limits& limits, int x, int y, Plane plane, Window& w) {
  Fit fit = {plane, 0, 0, false};
  const int n = im.window;
  const float start = plane.d;
  loadLeft(im, x, y, w);
  const Moments left = leftMoments(w, n);
  bool is_supported = false;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    loadRight(im, x, y, plane, w);
    const Photometry photometry = fitPhotometry(w, n, left);
    if (!(photometry.correlation > 0.2f)) return fit;
    Normal q = normalEquations(w, n, photometry);
    is_supported = isSupported(q, n, limits);
    const float noise = q.residual / float(n * n - 5) + kLeastNoise_grey * kLeastNoise_grey;
    const float prior = noise / (kSlopePrior * kSlopePrior);
    q.h[3] += prior;
    q.h[5] += prior;
    q.g[1] -= prior * plane.a;
    q.g[2] -= prior * plane.b;
    Plane step;
    float variance_factor;
    if (!solve(q, step, variance_factor)) return fit;
    fit.sigma = std::sqrt(noise * variance_factor);
    fit.correlation = photometry.correlation;
    plane.d += limited(step.d, 0.7f);
    plane.a += limited(step.a, 0.2f);
    plane.b += limited(step.b, 0.2f);
    if (magnitude(plane.d - start) > kFarthestFromStart_px) return fit;
    if (magnitude(plane.a) > limits.largest_slope || magnitude(plane.b) > limits.largest_slope) return fit;
    if (magnitude(step.d) < kConverged_px && magnitude(step.a) < kConvergedSlope &&
        magnitude(step.b) < kConvergedSlope)
      break;
    if (iteration == kMostIterations - 1 && magnitude(step.d) > 0.1f) return fit;
  }
  fit.plane = plane;
  fit.is_good =
      is_supported && fit.sigma <= limits.largest_sigma_px && fit.correlation >= limits.least_correlation;
  return fit;
}

// The window must lie inside both images: its corners and, in the right one, its ends at the disparity asked
// for.
inline bool isInside(const Images& im, int x, int y, float disparity) {
  const int half = im.window / 2;
  if (x < half || y < half || x >= im.width - half || y >= im.height - half) return false;
  const int right = int(float(x + im.right_shift) - disparity + 0.5f);
  if (right < half || right >= im.right_width - half) return false;
  for (int v = -half; v <= half; v += half)
    for (int u = -half; u <= half; u += half)
      if (!im.left_mask[(y + v) * im.left_mask_stride + x + u] ||
          !im.right_mask[(y + v) * im.right_mask_stride + right + u])
        return false;
  return true;
}

inline Fit fitAt(const Images& im, const Limits& limits, int x, int y, Plane start) {
  if (!isInside(im, x, y, start.d)) return {start, 0, 0, false};
  Window w;
  clearShape(w);
  return fitWindow(im, limits, x, y, start, w);
}

inline void store(const Field& field, int x, int y, const Fit& fit) {
  const int i = y * field.stride + x;
  field.disparity[i] = fit.is_good ? fit.plane.d : __builtin_nanf("");
  field.slope_x[i] = fit.plane.a;
  field.slope_y[i] = fit.plane.b;
  field.sigma[i] = fit.sigma;
}

inline void fitRow(const Images& im, const Limits& limits, int y, const std::int16_t* start,
                   const Field& field) {
  Fit last = {{0, 0, 0}, 0, 0, false};
  for (int x = 0; x < im.width; ++x) {
    const float whole = float(start[x]);
    Fit fit = {{0, 0, 0}, 0, 0, false};
    if (start[x] >= 0) {
      // The neighbour's plane carried over is the better start, as long as the search agrees with it.
      const float carried = last.plane.d + last.plane.a;
      if (last.is_good && magnitude(carried - whole) < 1.2f)
        fit = fitAt(im, limits, x, y, {carried, last.plane.a, last.plane.b});
      if (!fit.is_good) fit = fitAt(im, limits, x, y, {whole, 0, 0});
    }
    store(field, x, y, fit);
    last = fit;
  }
}

inline void loadShape(const Images& im, int x, int y, const Plane& plane, const Field& seen, Window& w) {
  const int half = im.window / 2;
  clearShape(w);
  for (int v = -half; v <= half; ++v)
    for (int u = -half; u <= half; ++u) {
      const float beyond =
          seen.disparity[(y + v) * seen.stride + x + u] - plane.d - plane.a * float(u) - plane.b * float(v);
      // NaN (unseen) and another surface: the plane is all that is known there.
      if (magnitude(beyond) < kSameSurface_px) w.shape[v + half][u + half] = beyond;
    }
}

inline void refineRow(const Images& im, const Limits& limits, int y, const Field& seen,
                      const Field& refined) {
  for (int x = 0; x < im.width; ++x) {
    const int i = y * seen.stride + x;
    const Plane plane = {seen.disparity[i], seen.slope_x[i], seen.slope_y[i]};
    Fit fit = {plane, seen.sigma[i], 0, false};
    if (plane.d == plane.d && isInside(im, x, y, plane.d)) {
      Window w;
      loadShape(im, x, y, plane, seen, w);
      fit = fitWindow(im, limits, x, y, plane, w);
      // Where window and plane do not suit the surface (creases, edges) both fits disagree by more than
      // noise: said in the deviation, and refused where it grows too large.
      const float change = fit.plane.d - plane.d;
      fit.sigma = std::sqrt(fit.sigma * fit.sigma + change * change);
      fit.is_good = fit.is_good && fit.sigma <= limits.largest_sigma_px;
    }
    store(refined, x, y, fit);
  }
}
