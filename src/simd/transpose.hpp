// Transposes eight records in memory into lanes, one array of lanes for each field, and back.
//
// Four floats of a record are read or written at once. A register of AVX holds those of two records: its halves are
// transposed at the same time, and no floats cross between them, which is slower. Values are only moved, so that any
// bits (flags, NaN) stay as they are.
#pragma once

#include <cstddef>

#include "simd/lanes.hpp"

namespace tumble {

namespace simd {

// Four floats of rows[0]; with AVX also four of rows[4], in the upper half.
TUMBLE_LANE_FUNCTION Packet load_fours(const float* const* rows, int first_float) {
#if defined(__AVX__)
    return _mm256_loadu2_m128(rows[4] + first_float, rows[0] + first_float);
#else
    return Eigen::internal::ploadu<Packet>(rows[0] + first_float);
#endif
}

TUMBLE_LANE_FUNCTION void store_fours(const Packet& fours, float* const* rows) {
#if defined(__AVX__)
    _mm256_storeu2_m128(rows[4], rows[0], fours);
#else
    Eigen::internal::pstoreu(rows[0], fours);
#endif
}

// Transposes each 4 x 4 tile of four registers in place.
TUMBLE_LANE_FUNCTION void transpose_tiles(Eigen::internal::PacketBlock<Packet, 4>& tiles) {
#if defined(__AVX__)
    Packet(&row)[4] = tiles.packet;
    const Packet low01 = _mm256_unpacklo_ps(row[0], row[1]), high01 = _mm256_unpackhi_ps(row[0], row[1]);
    const Packet low23 = _mm256_unpacklo_ps(row[2], row[3]), high23 = _mm256_unpackhi_ps(row[2], row[3]);
    row[0] = _mm256_shuffle_ps(low01, low23, 0x44);
    row[1] = _mm256_shuffle_ps(low01, low23, 0xee);
    row[2] = _mm256_shuffle_ps(high01, high23, 0x44);
    row[3] = _mm256_shuffle_ps(high01, high23, 0xee);
#else
    Eigen::internal::ptranspose(tiles);
#endif
}

}  // namespace simd

// Reads 8 consecutive floats at each of rows[kLaneCount]: lane r of fields[f] is float f of row r. Fields that the
// caller does not use cost nothing after inlining.
TUMBLE_LANE_FUNCTION void gather_rows(const float* const rows[kLaneCount], Lanes fields[8]) {
    for (int lane = 0; lane < kLaneCount; lane += simd::kPacketSize) {
        for (int field = 0; field < 8; field += 4) {
            Eigen::internal::PacketBlock<simd::Packet, 4> tiles;
            for (int i = 0; i < 4; ++i) tiles.packet[i] = simd::load_fours(rows + lane + i, field);
            simd::transpose_tiles(tiles);
            for (int i = 0; i < 4; ++i) Eigen::internal::pstoreu(fields[field + i].data() + lane, tiles.packet[i]);
        }
    }
}

// Reads 8 consecutive floats of each record, from the member at `offset` (bytes) on: they must be within the record.
template <class Record>
TUMBLE_LANE_FUNCTION void gather_members(const Record* const records[kLaneCount], std::size_t offset, Lanes fields[8]) {
    const float* rows[kLaneCount];
    for (int lane = 0; lane < kLaneCount; ++lane)
        rows[lane] = reinterpret_cast<const float*>(reinterpret_cast<const char*>(records[lane]) + offset);
    gather_rows(rows, fields);
}

// Writes 4 consecutive floats to each of rows[kLaneCount]: row r gets lane r of each field. Rows may be the same memory
// if they get equal values, or if nothing reads it.
TUMBLE_LANE_FUNCTION void scatter_rows(const Lanes& first, const Lanes& second, const Lanes& third, const Lanes& fourth,
                                       float* const rows[kLaneCount]) {
    using simd::Packet;
    for (int lane = 0; lane < kLaneCount; lane += simd::kPacketSize) {
        Eigen::internal::PacketBlock<Packet, 4> tiles;
        tiles.packet[0] = Eigen::internal::ploadu<Packet>(first.data() + lane);
        tiles.packet[1] = Eigen::internal::ploadu<Packet>(second.data() + lane);
        tiles.packet[2] = Eigen::internal::ploadu<Packet>(third.data() + lane);
        tiles.packet[3] = Eigen::internal::ploadu<Packet>(fourth.data() + lane);
        simd::transpose_tiles(tiles);
        for (int i = 0; i < 4; ++i) simd::store_fours(tiles.packet[i], rows + lane + i);
    }
}

}  // namespace tumble
