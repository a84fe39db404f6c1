#include "sweep/store/tar.hpp"

#include <array>
#include <cstdio>
#include <numeric>
#include <stdexcept>

namespace tumble::sweep {

namespace {

constexpr std::size_t kBlock = 512, kRecord = 20 * kBlock;
constexpr std::uint64_t kLargest = (std::uint64_t{1} << 33) - 1;  // bytes: 11 octal digits

// The offsets of the header's fields.
constexpr std::size_t kName = 0, kMode = 100, kOwner = 108, kGroup = 116, kSize = 124, kTime = 136, kSum = 148,
                      kType = 156, kMagic = 257, kDevice = 329, kMinor = 337;

void put_octal(std::string& header, std::size_t at, std::uint64_t number, int digits) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%0*llo", digits, static_cast<unsigned long long>(number));
    header.replace(at, static_cast<std::size_t>(digits), text.data());
}

std::string header_of(std::string_view name, std::uint64_t size) {
    std::string header(kBlock, '\0');
    header.replace(kName, name.size(), name);
    put_octal(header, kMode, 0644, 7);
    put_octal(header, kOwner, 0, 7);
    put_octal(header, kGroup, 0, 7);
    put_octal(header, kSize, size, 11);
    put_octal(header, kTime, 0, 11);
    header[kType] = '0';
    header.replace(kMagic, 8, std::string_view("ustar\00000", 8));
    put_octal(header, kDevice, 0, 7);
    put_octal(header, kMinor, 0, 7);
    header.replace(kSum, 8, 8, ' ');
    const auto add = [](unsigned sum, char byte) { return sum + static_cast<unsigned char>(byte); };
    put_octal(header, kSum, std::accumulate(header.begin(), header.end(), 0u, add), 6);
    header[kSum + 6] = '\0';
    return header;
}

}  // namespace

std::string tar_member(std::string_view name, std::string_view bytes) {
    if (name.empty() || name.size() > 100) throw std::invalid_argument("the name of a tar member has 1 to 100 bytes");
    if (bytes.size() > kLargest) throw std::invalid_argument("a tar member has at most 8 GiB");
    std::string member = header_of(name, bytes.size());
    member += bytes;
    member.append((kBlock - bytes.size() % kBlock) % kBlock, '\0');
    return member;
}

std::string tar_end(std::uint64_t size) {
    const std::uint64_t whole = (size + 2 * kBlock + kRecord - 1) / kRecord * kRecord;
    return std::string(static_cast<std::size_t>(whole - size), '\0');
}

}  // namespace tumble::sweep
