#include "sweep/store/trajectory_array.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

namespace tumble::sweep {

namespace {

static_assert(std::endian::native == std::endian::little, "the numbers are copied as they are in memory");

template <class Number>
void append_numbers(std::string& bytes, const std::vector<double>& numbers) {
    const std::vector<Number> converted(numbers.begin(), numbers.end());
    const std::size_t at = bytes.size();
    bytes.resize(at + converted.size() * sizeof(Number));
    if (!converted.empty()) std::memcpy(bytes.data() + at, converted.data(), converted.size() * sizeof(Number));
}

}  // namespace

std::string to_npy(const TrajectoryArray& trajectory, int bits) {
    std::string header = std::string("{'descr': '") + (bits == 64 ? "<f8" : "<f4") +
                         "', 'fortran_order': False, 'shape': (" + std::to_string(trajectory.steps) + ", " +
                         std::to_string(trajectory.bodies) + ", 6), }";
    // Magic text, version, length and header end at a multiple of 64 bytes.
    constexpr std::size_t kStart = 10, kAlignment = 64;
    header.append((kAlignment - (kStart + header.size() + 1) % kAlignment) % kAlignment, ' ');
    header += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() & 0xff);
    bytes += static_cast<char>(header.size() >> 8);
    bytes += header;
    if (bits == 64)
        append_numbers<double>(bytes, trajectory.numbers);
    else
        append_numbers<float>(bytes, trajectory.numbers);
    return bytes;
}

}  // namespace tumble::sweep
