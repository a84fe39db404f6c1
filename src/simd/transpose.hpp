// Transposes eight records in memory into lanes, one array of lanes for each field, and back.
//
// This is one 8 x 8 transposition with registers of 8 floats, and 4 x 4 tiles with registers of 4. Values are only
// moved, so that any bits (flags, NaN) stay as they are.
#pragma once

#include "simd/lanes.hpp"

namespace tumble {

// Reads 8 consecutive floats at each of rows[kLaneCount]: lane r of fields[f] is float f of row r. Fields that the
// caller does not use cost nothing after inlining.
TUMBLE_LANE_FUNCTION void gather_rows(const float* const rows[kLaneCount], Lanes fields[8]) {
    using namespace Eigen::internal;
    constexpr int kTile = simd::kPacketSize;
    for (int row = 0; row < kLaneCount; row += kTile) {
        for (int field = 0; field < 8; field += kTile) {
            PacketBlock<simd::Packet, kTile> tile;
            for (int i = 0; i < kTile; ++i) tile.packet[i] = ploadu<simd::Packet>(rows[row + i] + field);
            ptranspose(tile);
            for (int i = 0; i < kTile; ++i) pstoreu(fields[field + i].data() + row, tile.packet[i]);
        }
    }
}

// Writes 4 consecutive floats to each of rows[kLaneCount]: row r gets lane r of fields[0..3]. Two rows may be the same
// memory if they get equal values.
TUMBLE_LANE_FUNCTION void scatter_rows(const Lanes fields[4], float* const rows[kLaneCount]) {
    using namespace Eigen::internal;
    alignas(32) float table[kLaneCount][4];
    PacketBlock<simd::Packet, 4> tile;
    for (int lane = 0; lane < kLaneCount; lane += simd::kPacketSize) {
        for (int i = 0; i < 4; ++i) tile.packet[i] = ploadu<simd::Packet>(fields[i].data() + lane);
        ptranspose(tile);  // for 8 floats a packet: two rows of four in each packet
        float* target = table[lane];
        for (int i = 0; i < 4; ++i, target += simd::kPacketSize) pstoreu(target, tile.packet[i]);
    }
    for (int row = 0; row < kLaneCount; ++row) pstoreu(rows[row], ploadu<Packet4f>(table[row]));
}

}  // namespace tumble
