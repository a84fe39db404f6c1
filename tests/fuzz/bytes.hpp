// Turns a fuzzer's bytes into values; zeros once they run out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tumble/distance.hpp"

namespace tumble::fuzz {

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    // Any bit pattern of T: for floats also NaN, infinity and denormals.
    template <class T>
    T take() {
        T value{};
        const std::size_t count = size_ < sizeof(T) ? size_ : sizeof(T);
        if (count > 0) std::memcpy(&value, data_, count);
        data_ += count;
        size_ -= count;
        return value;
    }

    // A float that is often a small multiple of 1/4, which makes equal distances and exact contacts frequent; else any
    // bit pattern.
    float take_coordinate() {
        const std::uint8_t kind = take<std::uint8_t>();
        return kind < 200 ? static_cast<float>(static_cast<int>(kind) - 100) * 0.25f : take<float>();
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

struct FuzzedShape {
    Shape shape;
    bool is_convex = false;  // made by the factory: what distance() promises must hold
};

// Either the hull of the points, or the points as they are, which need not be convex nor finite.
inline FuzzedShape take_shape(Bytes& bytes) {
    const std::uint8_t kind = bytes.take<std::uint8_t>();
    const std::size_t count = (kind >> 1) % 12;
    Vec2 vertices[12];
    bool is_finite_shape = count > 0;
    for (std::size_t i = 0; i < count; ++i) {
        vertices[i] = {bytes.take_coordinate(), bytes.take_coordinate()};
        is_finite_shape = is_finite_shape && is_finite(vertices[i]);
    }
    const float radius = bytes.take_coordinate();
    const bool hull = (kind & 1) != 0 && is_finite_shape && std::isfinite(radius) && radius >= 0.0f;
    if (hull) return {make_polygon({vertices, count}, radius), true};
    return {Shape::from_raw({vertices, count}, radius), false};
}

inline Pose take_pose(Bytes& bytes) {
    const std::uint8_t kind = bytes.take<std::uint8_t>();
    const DVec2 position = kind & 1 ? DVec2{bytes.take<double>(), bytes.take<double>()}
                                    : DVec2{bytes.take_coordinate(), bytes.take_coordinate()};
    if (kind & 2) return {position, {bytes.take<float>(), bytes.take<float>()}};
    return {position, make_rotation_degrees(45.0 * (kind >> 2))};
}

}  // namespace tumble::fuzz
