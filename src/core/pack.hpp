#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace eisph {

// Single-precision numbers that one instruction handles: sixteen with AVX-512, else eight. Operators on pairs
// of particles are templates on their number type: with Pack they treat a pack of neighbours at a time, with
// float or double one.

#if defined(__AVX512F__)
inline constexpr std::size_t kPackWidth = 16;
#else
inline constexpr std::size_t kPackWidth = 8;
#endif
using Pack = float __attribute__((vector_size(kPackWidth * sizeof(float))));

/// A row of the arrays that are gathered by neighbour index: three components and a fourth value.
struct alignas(16) Float4 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float w = 0.0F;
};

template <class Real>
inline Real splat(double value) {
  return static_cast<Real>(value);
}
template <>
inline Pack splat<Pack>(double value) {
  return static_cast<float>(value) - Pack{};
}

/// max(value, 0)
template <class Real>
inline Real positive_part(Real value) {
  return value > Real(0) ? value : Real(0);
}
template <>
inline Pack positive_part<Pack>(Pack value) {
#if defined(__AVX512F__)
  return (Pack)_mm512_max_ps((__m512)value, _mm512_setzero_ps());
#elif defined(__AVX2__)
  return (Pack)_mm256_max_ps((__m256)value, _mm256_setzero_ps());
#else
  for (std::size_t k = 0; k < kPackWidth; ++k) value[k] = positive_part(value[k]);
  return value;
#endif
}

/// The lesser of two values, lane by lane.
template <class Real>
inline Real lesser(Real a, Real b) {
  return a < b ? a : b;
}
template <>
inline Pack lesser<Pack>(Pack a, Pack b) {
#if defined(__AVX512F__)
  return (Pack)_mm512_min_ps((__m512)a, (__m512)b);
#elif defined(__AVX2__)
  return (Pack)_mm256_min_ps((__m256)a, (__m256)b);
#else
  for (std::size_t k = 0; k < kPackWidth; ++k) a[k] = lesser(a[k], b[k]);
  return a;
#endif
}

/// 1/sqrt(value) to the accuracy of the type (Pack: about 2e-7 relative).
template <class Real>
inline Real reciprocal_sqrt(Real value) {
  return Real(1) / std::sqrt(value);
}
template <>
inline Pack reciprocal_sqrt<Pack>(Pack value) {
#if defined(__AVX512F__)
  const Pack estimate = (Pack)_mm512_rsqrt14_ps((__m512)value);
  return estimate * (splat<Pack>(1.5) - splat<Pack>(0.5) * value * estimate * estimate);
#elif defined(__AVX2__)
  const Pack estimate = (Pack)_mm256_rsqrt_ps((__m256)value);
  return estimate * (splat<Pack>(1.5) - splat<Pack>(0.5) * value * estimate * estimate);
#else
  for (std::size_t k = 0; k < kPackWidth; ++k) value[k] = 1.0F / std::sqrt(value[k]);
  return value;
#endif
}

template <class Real>
inline double horizontal_sum(Real value) {
  return value;
}
template <>
inline double horizontal_sum<Pack>(Pack value) {
#if defined(__AVX512F__)
  const __m512 all = (__m512)value;
  const __m256 half = _mm256_add_ps(_mm512_castps512_ps256(all),
                                    _mm256_castpd_ps(_mm512_extractf64x4_pd(_mm512_castps_pd(all), 1)));
  const __m128 quarter = _mm_add_ps(_mm256_castps256_ps128(half), _mm256_extractf128_ps(half, 1));
  const __m128 eighth = _mm_add_ps(quarter, _mm_movehl_ps(quarter, quarter));
  return _mm_cvtss_f32(_mm_add_ss(eighth, _mm_movehdup_ps(eighth)));
#elif defined(__AVX2__)
  const __m128 half =
      _mm_add_ps(_mm256_castps256_ps128((__m256)value), _mm256_extractf128_ps((__m256)value, 1));
  const __m128 quarter = _mm_add_ps(half, _mm_movehl_ps(half, half));
  return _mm_cvtss_f32(_mm_add_ss(quarter, _mm_movehdup_ps(quarter)));
#else
  const float low = (value[0] + value[4]) + (value[2] + value[6]);
  const float high = (value[1] + value[5]) + (value[3] + value[7]);
  return low + high;
#endif
}

/// Four arrays of a pack's width from as many rows of a table.
struct PackRows {
  Pack x, y, z, w;
};

#if defined(__AVX512F__)
/// Rows 0, 4, 8 and 12 of `index` one behind the other. A load that is spread and masked needs no shuffle, of
/// which a processor makes one or two at a time.
[[gnu::always_inline]] inline __m512 gather_four_rows(const Float4* table, const std::uint32_t* index) {
  __m512 rows = _mm512_castps128_ps512(_mm_load_ps(&table[index[0]].x));
  rows = _mm512_mask_broadcast_f32x4(rows, 0x00F0, _mm_load_ps(&table[index[4]].x));
  rows = _mm512_mask_broadcast_f32x4(rows, 0x0F00, _mm_load_ps(&table[index[8]].x));
  return _mm512_mask_broadcast_f32x4(rows, 0xF000, _mm_load_ps(&table[index[12]].x));
}
#elif defined(__AVX2__)
/// Rows 0 and 4 of `index` one behind the other.
[[gnu::always_inline]] inline __m256 gather_two_rows(const Float4* table, const std::uint32_t* index) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(&table[index[0]].x)),
                              _mm_load_ps(&table[index[4]].x), 1);
}
#endif

/// Always inline: four packs returned by a call go through memory, which takes half as long again.
[[gnu::always_inline]] inline PackRows gather_rows(const Float4* table, const std::uint32_t* index) {
  PackRows rows;
#if defined(__AVX512F__)
  // Four rows to a register, then four by four transposes within its quarters.
  const __m512 r0 = gather_four_rows(table, index + 0);
  const __m512 r1 = gather_four_rows(table, index + 1);
  const __m512 r2 = gather_four_rows(table, index + 2);
  const __m512 r3 = gather_four_rows(table, index + 3);
  const __m512 t0 = _mm512_unpacklo_ps(r0, r1);
  const __m512 t1 = _mm512_unpackhi_ps(r0, r1);
  const __m512 t2 = _mm512_unpacklo_ps(r2, r3);
  const __m512 t3 = _mm512_unpackhi_ps(r2, r3);
  rows.x = (Pack)_mm512_shuffle_ps(t0, t2, 0x44);
  rows.y = (Pack)_mm512_shuffle_ps(t0, t2, 0xEE);
  rows.z = (Pack)_mm512_shuffle_ps(t1, t3, 0x44);
  rows.w = (Pack)_mm512_shuffle_ps(t1, t3, 0xEE);
#elif defined(__AVX2__)
  const __m256 r0 = gather_two_rows(table, index + 0);
  const __m256 r1 = gather_two_rows(table, index + 1);
  const __m256 r2 = gather_two_rows(table, index + 2);
  const __m256 r3 = gather_two_rows(table, index + 3);
  const __m256 t0 = _mm256_unpacklo_ps(r0, r1);
  const __m256 t1 = _mm256_unpackhi_ps(r0, r1);
  const __m256 t2 = _mm256_unpacklo_ps(r2, r3);
  const __m256 t3 = _mm256_unpackhi_ps(r2, r3);
  rows.x = (Pack)_mm256_shuffle_ps(t0, t2, 0x44);
  rows.y = (Pack)_mm256_shuffle_ps(t0, t2, 0xEE);
  rows.z = (Pack)_mm256_shuffle_ps(t1, t3, 0x44);
  rows.w = (Pack)_mm256_shuffle_ps(t1, t3, 0xEE);
#else
  for (std::size_t k = 0; k < kPackWidth; ++k) {
    const Float4& row = table[index[k]];
    rows.x[k] = row.x;
    rows.y[k] = row.y;
    rows.z[k] = row.z;
    rows.w[k] = row.w;
  }
#endif
  return rows;
}

/// 1 where an index of a pack is below `limit`, 0 elsewhere. Both below 2^31.
inline Pack ones_below(const std::uint32_t* index, std::uint32_t limit) {
#if defined(__AVX512F__)
  const __mmask16 below =
      _mm512_cmplt_epu32_mask(_mm512_loadu_si512(index), _mm512_set1_epi32(static_cast<int>(limit)));
  return (Pack)_mm512_maskz_mov_ps(below, _mm512_set1_ps(1.0F));
#elif defined(__AVX2__)
  const __m256i entries = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
  const __m256i below = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(limit)), entries);
  return (Pack)_mm256_and_ps(_mm256_castsi256_ps(below), _mm256_set1_ps(1.0F));
#else
  Pack ones{};
  for (std::size_t k = 0; k < kPackWidth; ++k) ones[k] = index[k] < limit ? 1.0F : 0.0F;
  return ones;
#endif
}

/// 1 where an index of a pack is `value`, 0 elsewhere.
inline Pack ones_at(const std::uint32_t* index, std::uint32_t value) {
#if defined(__AVX512F__)
  const __mmask16 equal =
      _mm512_cmpeq_epi32_mask(_mm512_loadu_si512(index), _mm512_set1_epi32(static_cast<int>(value)));
  return (Pack)_mm512_maskz_mov_ps(equal, _mm512_set1_ps(1.0F));
#elif defined(__AVX2__)
  const __m256i entries = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
  const __m256i equal = _mm256_cmpeq_epi32(_mm256_set1_epi32(static_cast<int>(value)), entries);
  return (Pack)_mm256_and_ps(_mm256_castsi256_ps(equal), _mm256_set1_ps(1.0F));
#else
  Pack ones{};
  for (std::size_t k = 0; k < kPackWidth; ++k) ones[k] = index[k] == value ? 1.0F : 0.0F;
  return ones;
#endif
}

/// Some of the lanes of a pack, in order.
struct LaneSelection {
#if defined(__AVX512F__)
  __mmask16 lanes;
#elif defined(__AVX2__)
  __m256i lanes;
#else
  std::uint32_t lanes[kPackWidth];
#endif
  std::size_t count = 0;
};

/// The lanes below `valid` whose value is below `limit`.
inline LaneSelection select_below(Pack value, float limit, std::size_t valid = kPackWidth) {
  LaneSelection selection;
#if defined(__AVX512F__)
  selection.lanes = _mm512_cmp_ps_mask((__m512)value, _mm512_set1_ps(limit), _CMP_LT_OQ);
  if (valid < kPackWidth) selection.lanes &= static_cast<__mmask16>((1U << valid) - 1U);
  selection.count = static_cast<std::size_t>(__builtin_popcount(selection.lanes));
#elif defined(__AVX2__)
  struct Table {
    alignas(64) std::uint8_t lane[256][8];
    constexpr Table() : lane{} {
      for (int mask = 0; mask < 256; ++mask) {
        int count = 0;
        for (int bit = 0; bit < 8; ++bit) {
          if ((mask >> bit & 1) != 0) lane[mask][count++] = static_cast<std::uint8_t>(bit);
        }
      }
    }
  };
  static constexpr Table kTable;
  unsigned mask = static_cast<unsigned>(
      _mm256_movemask_ps(_mm256_cmp_ps((__m256)value, _mm256_set1_ps(limit), _CMP_LT_OQ)));
  if (valid < kPackWidth) mask &= (1U << valid) - 1U;
  selection.lanes =
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kTable.lane[mask])));
  selection.count = static_cast<std::size_t>(__builtin_popcount(mask));
#else
  for (std::size_t k = 0; k < kPackWidth; ++k) {
    selection.lanes[selection.count] = static_cast<std::uint32_t>(k);
    selection.count += k < valid && value[k] < limit ? 1 : 0;
  }
#endif
  return selection;
}

/// Stores the selected lanes one after the other. A pack of entries of `out` may be written whatever the
/// count.
inline void store_selected(Pack value, const LaneSelection& selection, float* out) {
#if defined(__AVX512F__)
  _mm512_storeu_ps(out, _mm512_maskz_compress_ps(selection.lanes, (__m512)value));
#elif defined(__AVX2__)
  _mm256_storeu_ps(out, _mm256_permutevar8x32_ps((__m256)value, selection.lanes));
#else
  for (std::size_t k = 0; k < selection.count; ++k) out[k] = value[selection.lanes[k]];
#endif
}
inline void store_selected(const std::uint32_t* value, const LaneSelection& selection, std::uint32_t* out) {
#if defined(__AVX512F__)
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(selection.lanes, _mm512_loadu_si512(value)));
#elif defined(__AVX2__)
  const __m256i entries = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(value));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_permutevar8x32_epi32(entries, selection.lanes));
#else
  for (std::size_t k = 0; k < selection.count; ++k) out[k] = value[selection.lanes[k]];
#endif
}

/// Stores first + lane for the selected lanes.
inline void store_selected_rows(std::uint32_t first, const LaneSelection& selection, std::uint32_t* out) {
#if defined(__AVX512F__)
  const __m512i lanes = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m512i rows = _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)), lanes);
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(selection.lanes, rows));
#elif defined(__AVX2__)
  const __m256i rows = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)), selection.lanes);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), rows);
#else
  for (std::size_t k = 0; k < selection.count; ++k) out[k] = first + selection.lanes[k];
#endif
}

/// Appends to `out` the entries of a pack of indices whose `squared` is below `limit`, in order; returns how
/// many. A pack of entries may be written whatever the count.
inline std::size_t append_below(Pack squared, float limit, const std::uint32_t* index, std::uint32_t* out) {
  const LaneSelection selection = select_below(squared, limit);
  store_selected(index, selection, out);
  return selection.count;
}

}  // namespace eisph
