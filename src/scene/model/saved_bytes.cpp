#include "scene/model/saved_bytes.hpp"

#ifndef __clang_analyzer__  // it assumes null pointers that a span of some size does not have
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <bit>
#include <cstring>

#include "tumble/world.hpp"

namespace tumble::scene {

static_assert(std::endian::native == std::endian::little);

void SaveWriter::number(std::uint64_t value) {
    const std::span bytes = std::as_bytes(std::span(&value, 1));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void SaveWriter::block(std::span<const std::byte> bytes) {
    number(bytes.size());
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::vector<std::byte> SaveWriter::finish() {
    number(XXH64(bytes_.data(), bytes_.size(), 0));
    return std::move(bytes_);
}

SaveReader::SaveReader(std::span<const std::byte> bytes, const char* what) : rest_(bytes), what_(what) {
    if (bytes.size() < sizeof(std::uint64_t)) fail("incomplete");
    const std::span<const std::byte> content = bytes.first(bytes.size() - sizeof(std::uint64_t));
    rest_ = bytes.last(sizeof(std::uint64_t));
    if (number() != XXH64(content.data(), content.size(), 0)) fail("damaged, incomplete or of another version");
    rest_ = content;
}

std::uint64_t SaveReader::number() {
    std::uint64_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
}

std::span<const std::byte> SaveReader::block() { return take(number()); }

std::string SaveReader::text() {
    const std::span<const std::byte> bytes = block();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::size_t SaveReader::count(std::size_t size) {
    const std::uint64_t entries = number();
    if (entries > rest_.size() / size) fail("incomplete");
    return entries;
}

void SaveReader::finish() const {
    if (!rest_.empty()) fail("damaged");
}

void SaveReader::fail(const char* problem) const {
    throw SnapshotError(std::string("the saved ") + what_ + " is " + problem);
}

std::span<const std::byte> SaveReader::take(std::uint64_t size) {
    if (size > rest_.size()) fail("incomplete");
    const std::span<const std::byte> taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
}

}  // namespace tumble::scene
