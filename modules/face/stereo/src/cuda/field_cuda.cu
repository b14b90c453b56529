#include <cuda_runtime.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "cuda/field_cuda.h"

namespace facenav::stereo::cuda {
namespace {

void check(cudaError_t status) {
  if (status != cudaSuccess) throw std::runtime_error(std::string("CUDA: ") + cudaGetErrorString(status));
}

// Memory of the device, freed with its owner.
template <class T>
class DeviceArray {
 public:
  explicit DeviceArray(std::size_t count) : count_(count) { check(cudaMalloc(&data_, count * sizeof(T))); }
  DeviceArray(const T* from, std::size_t count) : DeviceArray(count) {
    check(cudaMemcpy(data_, from, count * sizeof(T), cudaMemcpyHostToDevice));
  }
  ~DeviceArray() { cudaFree(data_); }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  void copyTo(T* to) const { check(cudaMemcpy(to, data_, count_ * sizeof(T), cudaMemcpyDeviceToHost)); }
  T* get() const { return data_; }

 private:
  T* data_ = nullptr;
  std::size_t count_ = 0;
};

// --- Block search: a thread for each disparity of a block. The same whole numbers as on the processor.

struct BlockImages {
  const std::uint8_t *left, *right;
  int left_stride, right_stride, columns, rows, width, disparities, lead;
};

__device__ int clampTo(int value, int count) { return min(max(value, 0), count - 1); }

__global__ void searchBlock(BlockImages im, int uniqueness, float* disparity, int stride) {
  extern __shared__ std::uint16_t costs[];
  const int column = blockIdx.x, row = blockIdx.y;
  for (int d = threadIdx.x; d < im.disparities; d += blockDim.x) {
    int sum = 0;
    for (int j = row - 1; j <= row + 1; ++j)
      for (int i = column - 1; i <= column + 1; ++i) {
        const int y0 = clampTo(j, im.rows) * block::kBlock, x0 = clampTo(i, im.columns) * block::kBlock;
        for (int v = 0; v < block::kBlock; v += block::kRowStep)
          for (int u = 0; u < block::kBlock; ++u) {
            const int l = im.left[(y0 + v) * im.left_stride + x0 + u];
            const int r = im.right[(y0 + v) * im.right_stride + im.lead + im.width - 1 - x0 - u + d];
            sum += min(abs(l - r), block::kLargestDifference);
          }
      }
    costs[d] = std::uint16_t(sum);
  }
  __syncthreads();
  if (threadIdx.x != 0) return;
  int best = 0, least = 65535, second = 65535;
  for (int d = 0; d < im.disparities; ++d)
    if (costs[d] < least) least = costs[best = d];
  for (int d = 0; d < im.disparities; ++d)
    if (abs(d - best) > 2) second = min(second, int(costs[d]));
  float found = -1.0f;
  if ((second - least) * 256 > uniqueness * least) {
    found = float(best);
    if (best > 0 && best + 1 < im.disparities) {
      const int before = costs[best - 1], after = costs[best + 1], bend = before + after - 2 * least;
      if (bend > 0) found += 0.5f * float(before - after) / float(bend);
    }
  }
  disparity[row * stride + column] = found;
}

void search(const block::Images& im, int first, int last, int uniqueness, std::uint8_t*, float* disparity,
            int stride) {
  if (first != 0 || last != im.rows) throw std::runtime_error("CUDA: rows are done in one strip");
  const int height = im.rows * block::kBlock, lead = im.columns * block::kBlock - im.width;
  const DeviceArray<std::uint8_t> left(im.left, std::size_t(height) * im.left_stride);
  const DeviceArray<std::uint8_t> right(im.right_mirrored - lead, std::size_t(height) * im.right_stride);
  const DeviceArray<float> found(std::size_t(im.rows) * stride);
  const BlockImages images{left.get(),      right.get(),    im.left_stride,
                           im.right_stride, im.columns,     im.rows,
                           im.width,        im.disparities, lead};
  searchBlock<<<dim3(im.columns, im.rows), 128, im.disparities * sizeof(std::uint16_t)>>>(
      images, uniqueness, found.get(), stride);
  check(cudaGetLastError());
  found.copyTo(disparity);
}

// --- Plane step: a thread for each block. The formulas are those of plane_kernel.inl, which says why.

using planes::kBlock;
constexpr float kLeastNoise = 0.3f, kLeastGain = 0.2f, kMostGain = 5.0f, kLargestChange_px = 1.0f,
                kSteepest = 2.0f;
constexpr float kSlopePrior = 0.25f, kJump_px = 2.5f, kFlat = 0.05f, kNoiseShare = 0.6f;
enum { kH, kHu, kHuu, kHv, kHuv, kHvv, kY, kYu, kYv, kEe, kM, kR, kL, kRr, kLr, kLl };

__device__ float between(float value, float low, float high) {
  value = value > low ? value : low;
  return value < high ? value : high;
}

__device__ float planeAt(const planes::Field& f, int column, int row, float x, float y) {
  const int i = row * f.stride + column;
  return f.d[i] + f.a[i] * (x - float(kBlock * column) - 1.5f) + f.b[i] * (y - float(kBlock * row) - 1.5f);
}

__device__ float slopeAt(const planes::Field& f, int column, int row) { return f.a[row * f.stride + column]; }

// Disparity and slope along x at row y of one column of blocks, blended across rows of blocks.
__device__ void valueAt(const planes::Field& f, int column, int row, int other, float share, float y,
                        float& value, float& slope) {
  const float middle = float(kBlock * column) + 1.5f;
  const float near = planeAt(f, column, row, middle, y), far = planeAt(f, column, other, middle, y);
  const bool is_one = fabsf(far - near) < kJump_px;
  value = is_one ? near + share * (far - near) : near;
  slope = slopeAt(f, column, row);
  if (is_one) slope += share * (slopeAt(f, column, other) - slope);
}

__device__ float disparityAt(const planes::Field& f, int x, int y) {
  const int row = min(y / kBlock, f.rows - 1), column = min(x / kBlock, f.columns - 1);
  const float v = float(y - row * kBlock) - 1.5f, u = float(x - column * kBlock) - 1.5f;
  int other = row + (v < 0 ? -1 : 1);
  if (other < 0 || other >= f.rows) other = row;
  const float share = fabsf(v) / kBlock;
  float here, slope, there, slope_there;
  valueAt(f, column, row, other, share, float(y), here, slope);
  const int beside = column + (u < 0 ? -1 : 1);
  const float near = here + u * slope;
  if (beside < 0 || beside >= f.columns) return near;
  valueAt(f, beside, row, other, share, float(y), there, slope_there);
  const float far = there + (u + (u < 0 ? kBlock : -kBlock)) * slope_there;
  return fabsf(far - near) < kJump_px ? near + fabsf(u) / kBlock * (far - near) : near;
}

__global__ void sumBlocks(ImageRows im, planes::Field f, bool is_fit, float* sums) {
  const int column = blockIdx.x * blockDim.x + threadIdx.x, row = blockIdx.y * blockDim.y + threadIdx.y;
  if (column >= f.columns || row >= f.rows) return;
  float s[planes::kSums] = {};
  const float offset = f.offset[row * f.stride + column], gain = f.gain[row * f.stride + column];
  for (int k = is_fit ? 0 : 1; k < (is_fit ? kBlock : 2); ++k)
    for (int q = 0; q < kBlock; ++q) {
      const int x = column * kBlock + q, y = row * kBlock + k;
      if (x >= im.width || y >= im.height) continue;
      const float d = disparityAt(f, x, y), u = float(q) - 1.5f, v = float(k) - 1.5f;
      const float low = float(max(im.right_first[y], 1));
      const float high = fmaxf(float(min(im.right_end[y], im.right_width - 2) - 1), low);
      const float wanted = float(x) + float(im.right_shift) - d, at = between(wanted, low, high);
      if (wanted != at || x < im.left_first[y] || x >= im.left_end[y]) continue;
      const int whole = int(at);
      const float t = at - float(whole), w = 1.0f - t, b = t * t, a = w * w;
      const float* c = im.right + std::int64_t(y) * im.right_stride + whole;
      const float right = a * w / 6 * c[-1] + (2.0f / 3 - b + 0.5f * b * t) * c[0] +
                          (2.0f / 3 - a + 0.5f * a * w) * c[1] + b * t / 6 * c[2];
      const float gradient =
          (1.5f * b - 2 * t) * c[0] + (2 * w - 1.5f * a) * c[1] + 0.5f * (b * c[2] - a * c[-1]);
      const float l = im.left[std::int64_t(y) * im.left_stride + x] - kMiddle_grey;
      const float e = l - offset - gain * right, g = gain * gradient, h = g * g, wish = h * d - g * e;
      const float terms[planes::kSums] = {h,    u * h,         u * u * h, v * h, u * v * h, v * v * h,
                                          wish, u * wish,      v * wish,  e * e, 1.0f,      right,
                                          l,    right * right, l * right, l * l};
      for (int i = 0; i < planes::kSums; ++i) s[i] += terms[i];
    }
  for (int i = 0; i < planes::kSums; ++i)
    sums[(std::int64_t(row) * f.columns + column) * planes::kSums + i] = s[i];
}

// Sums over the window, moments about this block's middle.
__device__ void windowSums(const float* sums, const planes::Field& f, const planes::Window& window,
                           int column, int row, float* s) {
  for (int j = -window.radius; j <= window.radius; ++j)
    for (int i = -window.radius; i <= window.radius; ++i) {
      if (column + i < 0 || column + i >= f.columns || row + j < 0 || row + j >= f.rows) continue;
      const float* o = sums + (std::int64_t(row + j) * f.columns + column + i) * planes::kSums;
      const float w = window.weights[abs(i)] * window.weights[abs(j)], u = float(kBlock * i),
                  v = float(kBlock * j);
      s[kH] += w * o[kH];
      s[kHu] += w * (o[kHu] + u * o[kH]);
      s[kHuu] += w * (o[kHuu] + 2 * u * o[kHu] + u * u * o[kH]);
      s[kHv] += w * (o[kHv] + v * o[kH]);
      s[kHuv] += w * (o[kHuv] + u * o[kHv] + v * o[kHu] + u * v * o[kH]);
      s[kHvv] += w * (o[kHvv] + 2 * v * o[kHv] + v * v * o[kH]);
      s[kY] += w * o[kY];
      s[kYu] += w * (o[kYu] + u * o[kY]);
      s[kYv] += w * (o[kYv] + v * o[kY]);
      for (int k = kEe; k < planes::kSums; ++k) s[k] += w * o[k];
    }
}

__global__ void solve(const float* sums, planes::Field from, planes::Window window, float full, bool is_fit,
                      planes::Field to) {
  const int column = blockIdx.x * blockDim.x + threadIdx.x, row = blockIdx.y * blockDim.y + threadIdx.y;
  if (column >= from.columns || row >= from.rows) return;
  float s[planes::kSums] = {};
  windowSums(sums, from, window, column, row, s);
  const int at = row * from.stride + column;
  const float m = s[kM] + 1e-6f, inverse = 1.0f / m, r = s[kR] * inverse, l = s[kL] * inverse;
  to.gain[at] =
      between((s[kLr] * inverse - l * r) / (s[kRr] * inverse - r * r + kFlat), kLeastGain, kMostGain);
  to.offset[at] = l - to.gain[at] * r;
  if (!is_fit) return;
  const float ll = s[kLl] * inverse - l * l, residual = s[kEe] * inverse, noise = residual + kLeastNoise;
  const float prior = noise / (kSlopePrior * kSlopePrior), d0 = from.d[at], a0 = from.a[at], b0 = from.b[at];
  const float h = s[kH] + 1e-3f * noise, hu = s[kHu], hv = s[kHv], huu = s[kHuu] + prior, huv = s[kHuv],
              hvv = s[kHvv] + prior;
  const float y = s[kY] + 1e-3f * noise * d0, yu = s[kYu] + prior * from.a_prior[at],
              yv = s[kYv] + prior * from.b_prior[at];
  const float m00 = huu * hvv - huv * huv, m01 = hv * huv - hu * hvv, m02 = hu * huv - hv * huu;
  const float determinant = h * m00 + hu * m01 + hv * m02, least = 1e-6f * h * huu * hvv;
  const float divisor = 1.0f / (determinant > least ? determinant : least);
  const float m11 = h * hvv - hv * hv, m12 = hu * hv - h * huv, m22 = h * huu - hu * hu;
  const float z = y - h * d0 - hu * a0 - hv * b0, zu = yu - hu * d0 - huu * a0 - huv * b0,
              zv = yv - hv * d0 - huv * a0 - hvv * b0;
  to.d[at] = d0 + between((m00 * z + m01 * zu + m02 * zv) * divisor, -kLargestChange_px, kLargestChange_px);
  to.a[at] = between(a0 + (m01 * z + m11 * zu + m12 * zv) * divisor, -kSteepest, kSteepest);
  to.b[at] = between(b0 + (m02 * z + m12 * zu + m22 * zv) * divisor, -kSteepest, kSteepest);
  to.sigma[at] = sqrtf(noise / kNoiseShare * window.noise_factor * m00 * divisor);
  to.correlation[at] = m > 0.5f * full ? 1.0f - residual / (ll + kLeastNoise) : 0.0f;
}

// The planes of a field on the device.
class DeviceField {
 public:
  explicit DeviceField(const planes::Field& f)
      : size_(std::size_t(f.rows) * f.stride), memory_(kPlanes * size_), view_(f) {
    const float* from[] = {f.d, f.a, f.b, f.a_prior, f.b_prior, f.offset, f.gain, f.sigma, f.correlation};
    float** to[] = {&view_.d,      &view_.a,    &view_.b,     &view_.a_prior,    &view_.b_prior,
                    &view_.offset, &view_.gain, &view_.sigma, &view_.correlation};
    for (int i = 0; i < kPlanes; ++i) {
      *to[i] = memory_.get() + i * size_;
      check(cudaMemcpy(*to[i], from[i], size_ * sizeof(float), cudaMemcpyHostToDevice));
    }
  }
  const planes::Field& view() const { return view_; }
  void copyTo(const planes::Field& host) const {
    const float* from[] = {view_.d,    view_.a,     view_.b,          view_.offset,
                           view_.gain, view_.sigma, view_.correlation};
    float* to[] = {host.d, host.a, host.b, host.offset, host.gain, host.sigma, host.correlation};
    for (int i = 0; i < 7; ++i)
      check(cudaMemcpy(to[i], from[i], size_ * sizeof(float), cudaMemcpyDeviceToHost));
  }

 private:
  static constexpr int kPlanes = 9;
  std::size_t size_;
  DeviceArray<float> memory_;
  planes::Field view_;
};

void step(const ImageRows& im, const planes::Field& from, const planes::Window& window, bool is_fit,
          int first, int last, float*, const planes::Field& to) {
  if (first != 0 || last != from.rows) throw std::runtime_error("CUDA: rows are done in one strip");
  const DeviceArray<float> left(im.left, std::size_t(im.height) * im.left_stride),
      right(im.right, std::size_t(im.height) * im.right_stride),
      sums(std::size_t(from.rows) * from.columns * planes::kSums);
  const std::size_t rows = std::size_t(im.height);
  const DeviceArray<std::int32_t> left_first(im.left_first, rows), left_end(im.left_end, rows),
      right_first(im.right_first, rows), right_end(im.right_end, rows);
  ImageRows on_device = im;
  on_device.left = left.get();
  on_device.right = right.get();
  on_device.left_first = left_first.get();
  on_device.left_end = left_end.get();
  on_device.right_first = right_first.get();
  on_device.right_end = right_end.get();
  const DeviceField before(from), after(to);
  float full = 0;
  for (int j = -window.radius; j <= window.radius; ++j)
    for (int i = -window.radius; i <= window.radius; ++i)
      full += float(kBlock * kBlock) * window.weights[abs(i)] * window.weights[abs(j)];
  const dim3 threads(16, 8), blocks((from.columns + 15) / 16, (from.rows + 7) / 8);
  sumBlocks<<<blocks, threads>>>(on_device, before.view(), is_fit, sums.get());
  check(cudaGetLastError());
  solve<<<blocks, threads>>>(sums.get(), before.view(), window, full, is_fit, after.view());
  check(cudaGetLastError());
  after.copyTo(to);
}

}  // namespace

bool hasDevice() {
  int count = 0;
  return cudaGetDeviceCount(&count) == cudaSuccess && count > 0;
}

block::Kernel blockKernel(const block::Kernel& on_processor) {
  block::Kernel kernel = on_processor;
  kernel.search = search;
  kernel.needs_one_strip = true;
  return kernel;
}

planes::Kernel planeKernel(const planes::Kernel& on_processor) {
  planes::Kernel kernel = on_processor;
  kernel.step = step;
  kernel.needs_one_strip = true;
  return kernel;
}

}  // namespace facenav::stereo::cuda
