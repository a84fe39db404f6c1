// Numbers and blocks of bytes with a hash at their end: how the states of runs and of watched claims are saved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

// Numbers are little-endian; a block is its size and its bytes.
class SaveWriter {
public:
    void number(std::uint64_t value);
    void block(std::span<const std::byte> bytes);
    void text(std::string_view text) { block(std::as_bytes(std::span(text))); }
    std::vector<std::byte> finish();  // with the hash

private:
    std::vector<std::byte> bytes_;
};

// Reads what SaveWriter wrote. All functions throw SnapshotError for bytes that end early; `what` names what was saved.
class SaveReader {
public:
    // Checks the hash.
    SaveReader(std::span<const std::byte> bytes, const char* what);

    std::uint64_t number();
    std::span<const std::byte> block();
    std::string text();
    std::size_t count(std::size_t size);  // of the entries that follow, each of at least `size` bytes
    void finish() const;                  // throws unless all is read

private:
    [[noreturn]] void fail(const char* problem) const;
    std::span<const std::byte> take(std::uint64_t size);

    std::span<const std::byte> rest_;
    const char* what_;
};

}  // namespace tumble::scene
