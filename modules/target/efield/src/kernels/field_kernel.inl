// Included by one translation unit per instruction set.

using Lanes = float __attribute__((vector_size(32)));
using Shorts = std::int16_t __attribute__((vector_size(16)));

/// Eight floats from any address.
inline Lanes eightOf(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline Lanes eightOf(const std::int16_t* from) {
  Shorts shorts;
  __builtin_memcpy(&shorts, from, sizeof shorts);
  return __builtin_convertvector(shorts, Lanes);
}

inline void addTo(float* to, const Lanes& lanes) {
  const Lanes sum = eightOf(to) + lanes;
  __builtin_memcpy(to, &sum, sizeof sum);
}

void tile(const TileTask& task) {
  Lanes upper[kTileColumns] = {}, lower[kTileColumns] = {};
  const float *a = task.a, *b = task.b;
  for (std::ptrdiff_t k = 0; k < task.depth; ++k, a += kTileRows, b += kTileColumns) {
    const Lanes a0 = eightOf(a), a1 = eightOf(a + 8);
    for (int j = 0; j < kTileColumns; ++j) {
      upper[j] += a0 * b[j];
      lower[j] += a1 * b[j];
    }
  }
  if (task.rows == kTileRows && task.columns == kTileColumns) {
    for (int j = 0; j < kTileColumns; ++j) {
      addTo(task.c + j * task.column_step, upper[j]);
      addTo(task.c + j * task.column_step + 8, lower[j]);
    }
    return;
  }
  float whole[kTileColumns][kTileRows];
  __builtin_memset(whole, 0, sizeof whole);
  for (int j = 0; j < kTileColumns; ++j) addTo(whole[j], upper[j]), addTo(whole[j] + 8, lower[j]);
  for (int j = 0; j < task.columns; ++j)
    for (int i = 0; i < task.rows; ++i) task.c[j * task.column_step + i] += whole[j][i];
}

void dipoles(const DipoleTask& task) {
  for (std::ptrdiff_t p = 0; p < task.points.count; p += kLanes) {
    float x[kLanes] = {}, y[kLanes] = {}, z[kLanes] = {};
    for (int d = 0; d < task.dipoles; ++d) {
      const float *q = task.q + 3 * d, *m = task.m + 3 * d;
      for (int l = 0; l < kLanes; ++l) {
        const float dx = task.points.x[p + l] - q[0], dy = task.points.y[p + l] - q[1],
                    dz = task.points.z[p + l] - q[2];
        const float square = dx * dx + dy * dy + dz * dz;
        const float weight = 1.f / (square * __builtin_sqrtf(square));
        x[l] += weight * (m[1] * dz - m[2] * dy);
        y[l] += weight * (m[2] * dx - m[0] * dz);
        z[l] += weight * (m[0] * dy - m[1] * dx);
      }
    }
    __builtin_memcpy(task.x + p, x, sizeof x);
    __builtin_memcpy(task.y + p, y, sizeof y);
    __builtin_memcpy(task.z + p, z, sizeof z);
  }
}

void pull(const PullTask& task) {
  for (std::ptrdiff_t p = 0; p < task.points.count; p += kLanes)
    for (int l = 0; l < kLanes; ++l) {
      const float dx = task.points.x[p + l] - task.r[0], dy = task.points.y[p + l] - task.r[1],
                  dz = task.points.z[p + l] - task.r[2];
      const float square = dx * dx + dy * dy + dz * dz;
      const float weight = 1.f / (square * __builtin_sqrtf(square));
      task.x[p + l] = weight * dx, task.y[p + l] = weight * dy, task.z[p + l] = weight * dz;
    }
}

void far(const FarTask& task) {
  for (std::ptrdiff_t t = 0; t < task.count; ++t) {
    const FarTriangle& triangle = task.triangles[t];
    float is_far[kLanes], to[3][kLanes] = {};
    unsigned near = 0;
    const float limit = triangle.reach_mm * triangle.reach_mm;
    for (int l = 0; l < kLanes; ++l) {
      const float dx = triangle.centre[0] - task.x[l], dy = triangle.centre[1] - task.y[l],
                  dz = triangle.centre[2] - task.z[l];
      is_far[l] = dx * dx + dy * dy + dz * dz >= limit ? 1.f : 0.f;
    }
    for (int l = 0; l < kLanes; ++l) near |= unsigned(is_far[l] == 0.f) << l;
    for (int c = 0; c < kCorners; ++c)
      for (int l = 0; l < kLanes; ++l) {
        const float dx = triangle.at[c][0] - task.x[l], dy = triangle.at[c][1] - task.y[l],
                    dz = triangle.at[c][2] - task.z[l];
        // 1e-6: a near place may be a sampled one; its value is not used.
        const float square = dx * dx + dy * dy + dz * dz + 1e-6f;
        const float angle =
            (dx * triangle.across[0] + dy * triangle.across[1] + dz * triangle.across[2]) * is_far[l] /
            (square * __builtin_sqrtf(square));
        to[0][l] += angle * task.shares[c][0];
        to[1][l] += angle * task.shares[c][1];
        to[2][l] += angle * task.shares[c][2];
      }
    for (int v = 0; v < 3; ++v) {
      float* sums = task.sums + std::ptrdiff_t(triangle.corner[v]) * kLanes;
      for (int l = 0; l < kLanes; ++l) sums[l] += to[v][l];
    }
    task.near[t] = std::uint16_t(near);
  }
}

template <class Value>
void expand(const ExpandTask& task, const Value* matrix) {
  for (std::ptrdiff_t block = 0; block < task.blocks; ++block) {
    Lanes sums[4] = {};
    for (std::ptrdiff_t k = 0; k < task.columns; ++k, matrix += kBlock)
      for (int part = 0; part < 4; ++part) sums[part] += task.in[k] * eightOf(matrix + 8 * part);
    for (int part = 0; part < 4; ++part)
      __builtin_memcpy(task.out + block * kBlock + 8 * part, &sums[part], sizeof sums[part]);
  }
}

void expandFloats(const ExpandTask& task, const float* matrix) { expand(task, matrix); }
void expandShorts(const ExpandTask& task, const std::int16_t* matrix) { expand(task, matrix); }

Kernel allOf() { return {tile, dipoles, pull, far, expandFloats, expandShorts}; }
