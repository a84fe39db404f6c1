#include "scene/run/saved_run.hpp"

#ifndef __clang_analyzer__  // it assumes null pointers that a span of some size does not have
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <bit>
#include <cstring>
#include <string>

#include "tumble/world.hpp"

namespace tumble::scene {

namespace {

constexpr std::uint64_t kMagic = 0x31'4e'55'52'4c'42'4d'54;  // "TMBLRUN1"

static_assert(std::endian::native == std::endian::little);

class Writer {
public:
    void number(std::uint64_t value) { bytes(std::as_bytes(std::span(&value, 1))); }
    void bytes(std::span<const std::byte> more) { bytes_.insert(bytes_.end(), more.begin(), more.end()); }
    void block(std::span<const std::byte> more) {
        number(more.size());
        bytes(more);
    }
    std::vector<std::byte> finish() {
        number(XXH64(bytes_.data(), bytes_.size(), 0));
        return std::move(bytes_);
    }

private:
    std::vector<std::byte> bytes_;
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

    std::span<const std::byte> block() { return take(number()); }

    // The number of entries that follow, each of at least `size` bytes.
    std::size_t count(std::size_t size) {
        const std::uint64_t entries = number();
        if (entries > rest_.size() / size) throw SnapshotError("the saved run is incomplete");
        return entries;
    }

    bool is_at_end() const { return rest_.empty(); }

private:
    std::span<const std::byte> take(std::uint64_t size) {
        if (size > rest_.size()) throw SnapshotError("the saved run is incomplete");
        const std::span<const std::byte> taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }

    std::span<const std::byte> rest_;
};

// Without the hash at the end.
std::span<const std::byte> verified(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(std::uint64_t)) throw SnapshotError("the saved run is incomplete");
    const std::span<const std::byte> content = bytes.first(bytes.size() - sizeof(std::uint64_t));
    if (Reader(bytes.last(sizeof(std::uint64_t))).number() != XXH64(content.data(), content.size(), 0))
        throw SnapshotError("the saved run is damaged, incomplete or of another version");
    return content;
}

}  // namespace

std::vector<std::byte> to_bytes(const SavedRun& run) {
    Writer writer;
    writer.number(kMagic);
    writer.number(run.scene_hash);
    writer.number(run.bodies.size());
    for (const SceneInstance& body : run.bodies) {
        writer.number(body.id.index);
        writer.number(body.id.generation);
        writer.number(body.source);
        writer.block(std::as_bytes(std::span(body.name)));
    }
    writer.number(run.events.size());
    for (const SavedEvent& event : run.events) {
        writer.number(event.count);
        writer.number(event.spawned);
    }
    writer.block(run.world);
    return writer.finish();
}

SavedRun read_saved_run(std::span<const std::byte> bytes) {
    Reader reader(verified(bytes));
    SavedRun run;
    if (reader.number() != kMagic) throw SnapshotError("these bytes are no saved run of this version");
    run.scene_hash = reader.number();
    for (std::size_t left = reader.count(4 * sizeof(std::uint64_t)); left > 0; --left) {
        SceneInstance& body = run.bodies.emplace_back();
        body.id.index = static_cast<std::uint32_t>(reader.number());
        body.id.generation = static_cast<std::uint32_t>(reader.number());
        body.source = reader.number();
        const std::span<const std::byte> name = reader.block();
        body.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
    }
    for (std::size_t left = reader.count(2 * sizeof(std::uint64_t)); left > 0; --left) {
        const std::uint64_t count = reader.number();
        run.events.push_back({count, reader.number()});
    }
    const std::span<const std::byte> world = reader.block();
    run.world.assign(world.begin(), world.end());
    if (!reader.is_at_end()) throw SnapshotError("the saved run is damaged");
    return run;
}

}  // namespace tumble::scene
