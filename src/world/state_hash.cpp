#include "world/state_hash.hpp"

#include <array>
#include <bit>
#include <type_traits>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tumble {

namespace {

// The bytes of one body, little-endian on every machine.
class BodyBytes {
public:
    template <class Value>
    void add(Value value) {
        using Bits = std::conditional_t<sizeof(Value) == 8, std::uint64_t,
                                        std::conditional_t<sizeof(Value) == 4, std::uint32_t, std::uint8_t>>;
        const Bits bits = std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof(Value); ++i) bytes_[size_++] = static_cast<unsigned char>(bits >> (8 * i));
    }

    void update(XXH64_state_t& state) const { XXH64_update(&state, bytes_.data(), bytes_.size()); }

private:
    // Position, rotation, velocity, angular velocity, sleep flag.
    static constexpr std::size_t kBytes = 2 * sizeof(double) + 5 * sizeof(float) + 1;
    std::array<unsigned char, kBytes> bytes_{};
    std::size_t size_ = 0;
};

}  // namespace

std::uint64_t hash_bodies(const BodyStore& bodies) {
    XXH64_state_t state;
    XXH64_reset(&state, 0);
    for (const BodyId id : bodies.ids.live()) {
        const BodyFrame& frame = bodies.frames[id.index];
        const SolverBody& body = bodies.solver_bodies[frame.solver_body];
        BodyBytes bytes;
        bytes.add(frame.pose.position.x);
        bytes.add(frame.pose.position.y);
        bytes.add(frame.pose.rotation.c);
        bytes.add(frame.pose.rotation.s);
        bytes.add(body.velocity.x);
        bytes.add(body.velocity.y);
        bytes.add(body.angular_velocity);
        bytes.add(static_cast<std::uint8_t>(bodies.is_asleep(id.index) ? 1 : 0));
        bytes.update(state);
    }
    return XXH64_digest(&state);
}

}  // namespace tumble
