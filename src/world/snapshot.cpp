#include "world/snapshot.hpp"

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "world/audit.hpp"
#include "world/visit_members.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tumble {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

constexpr char kMagic[8] = {'t', 'u', 'm', 'b', 'l', 'e', 'W', '\n'};

// To be raised with every change of the saved members, anywhere in the state.
constexpr std::uint32_t kVersion = 17;

constexpr std::size_t kHeaderBytes = sizeof kMagic + sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);

// Calls visit(parts...) with all saved parts, in the order of their bytes.
template <class Visit>
void visit_saved(const SnapshotParts& parts, Visit&& visit) {
    SimulationState& state = parts.simulation;
    visit(parts.def, parts.step_count, parts.diverged_body, state);
}

class Writer {
public:
    template <class T>
    void leaf(T value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof value);
        std::memcpy(bytes_.data() + at, &value, sizeof value);
    }

    template <class T>
    void list(const std::vector<T>& values) {
        leaf(std::uint64_t{values.size()});
        for (const T& value : values) visit_value(*this, value);
    }

    template <class T>
    void optional(const std::optional<T>& value) {
        leaf(value.has_value());
        if (value) visit_value(*this, *value);
    }

    template <class... T>
    void variant(const std::variant<T...>& value) {
        leaf(static_cast<std::uint8_t>(value.index()));
        std::visit([&](const auto& alternative) { visit_value(*this, alternative); }, value);
    }

    void shape(const Shape& shape) {
        leaf(std::int32_t{shape.vertex_count()});
        leaf(shape.radius());
        for (int i = 0; i < shape.vertex_count(); ++i) {
            leaf(shape.vertex(i).x);
            leaf(shape.vertex(i).y);
        }
    }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class T>
    void leaf(T& value) {
        take(sizeof value);
        if constexpr (std::is_same_v<T, bool>) {
            const auto byte = std::to_integer<unsigned>(bytes_[at_ - 1]);
            require(byte <= 1, "a bool is neither 0 nor 1");
            value = byte == 1;
        } else {
            std::memcpy(&value, bytes_.data() + at_ - sizeof value, sizeof value);
        }
    }

    template <class T>
    void list(std::vector<T>& values) {
        std::uint64_t size = 0;
        leaf(size);
        // Every element has at least one byte, so that a damaged size cannot allocate much more than the snapshot's
        // size.
        require(std::is_empty_v<T> || size <= bytes_.size() - at_, "a list is longer than the snapshot");
        values.assign(static_cast<std::size_t>(size), T{});
        for (T& value : values) visit_value(*this, value);
    }

    template <class T>
    void optional(std::optional<T>& value) {
        bool has_value = false;
        leaf(has_value);
        value.reset();
        if (has_value) visit_value(*this, value.emplace());
    }

    template <class... T>
    void variant(std::variant<T...>& value) {
        std::uint8_t index = 0;
        leaf(index);
        require(index < sizeof...(T), "a joint has an unknown kind");
        emplace(value, index, std::index_sequence_for<T...>{});
        std::visit([&](auto& alternative) { visit_value(*this, alternative); }, value);
    }

    void shape(Shape& shape) {
        std::int32_t count = 0;
        float radius = 0.0f;
        leaf(count);
        leaf(radius);
        require(count >= 0 && count <= Shape::kMaxVertices, "a shape has too many vertices");
        std::vector<Vec2> vertices(static_cast<std::size_t>(count));
        for (Vec2& vertex : vertices) {
            leaf(vertex.x);
            leaf(vertex.y);
        }
        shape = Shape::from_raw(vertices, radius);
    }

    bool is_at_end() const { return at_ == bytes_.size(); }

    static void require(bool holds, const char* problem) {
        if (!holds) throw SnapshotError(std::string("snapshot: ") + problem);
    }

private:
    void take(std::size_t size) {
        require(size <= bytes_.size() - at_, "it ends early");
        at_ += size;
    }

    template <class Variant, std::size_t... index>
    static void emplace(Variant& value, std::uint8_t wanted, std::index_sequence<index...>) {
        (void)((index == wanted && (value.template emplace<index>(), true)) || ...);
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<std::byte> write_snapshot(const SnapshotParts& parts) {
    Writer payload;
    visit_saved(parts, [&](const auto&... part) { (visit_value(payload, part), ...); });
    const std::vector<std::byte> state = payload.take();
    Writer snapshot;
    for (const char letter : kMagic) snapshot.leaf(letter);
    snapshot.leaf(kVersion);
    snapshot.leaf(std::uint64_t{state.size()});
    snapshot.leaf(std::uint64_t{XXH64(state.data(), state.size(), 0)});
    std::vector<std::byte> bytes = snapshot.take();
    bytes.insert(bytes.end(), state.begin(), state.end());
    return bytes;
}

void read_snapshot(std::span<const std::byte> bytes, const SnapshotParts& parts) {
    Reader header(bytes);
    char magic[sizeof kMagic];
    for (char& letter : magic) header.leaf(letter);
    Reader::require(std::memcmp(magic, kMagic, sizeof kMagic) == 0, "these bytes are not a snapshot");
    std::uint32_t version = 0;
    header.leaf(version);
    if (version != kVersion)
        throw SnapshotError("snapshot: it has version " + std::to_string(version) + ", this build reads version " +
                            std::to_string(kVersion));
    std::uint64_t size = 0, hash = 0;
    header.leaf(size);
    header.leaf(hash);
    const std::span<const std::byte> state = bytes.subspan(kHeaderBytes);
    if (size != state.size())
        throw SnapshotError("snapshot: it has " + std::to_string(state.size()) +
                            " bytes of state, but its header states " + std::to_string(size));
    Reader::require(hash == XXH64(state.data(), state.size(), 0), "it is damaged: the checksum does not match");

    Reader payload(state);
    visit_saved(parts, [&](auto&... part) { (visit_value(payload, part), ...); });
    Reader::require(payload.is_at_end(), "bytes remain after its state");
    try {
        audit(parts.simulation);
    } catch (const std::logic_error& broken) {
        throw SnapshotError(std::string("snapshot: its state breaks an invariant: ") + broken.what());
    }
}

}  // namespace tumble
