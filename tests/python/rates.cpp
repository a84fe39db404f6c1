// For measure.py, which loads this library into its own process: does in C++ what measure.py does in Python.
#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "tumble/distance.hpp"
#include "tumble/world.hpp"

namespace {

using namespace tumble;

// Pairs of boxes on a circle about each other: pair i at 2.4 m, at angles that differ.
struct Batch {
    static constexpr std::size_t kPairs = 1'000'000, kChunk = 256;
    Shape a = make_box({2.0f, 1.0f}), b = make_box({1.0f, 1.0f}, 0.1f);
    std::vector<Pose> at;
    std::vector<DistanceResult> results;

    Batch() : results(kPairs) {
        for (std::size_t i = 0; i < kPairs; ++i) {
            const DVec2 direction(rotate(make_rotation(1e-3 * double(i)), Vec2{1.0f, 0.0f}));
            at.push_back({2.4 * direction, make_rotation(7e-4 * double(i))});
        }
    }

    void run() {
        std::vector<PosedPair> pairs(kChunk);
        for (std::size_t begin = 0; begin < kPairs; begin += kChunk) {
            const std::size_t size = std::min(kChunk, kPairs - begin);
            for (std::size_t k = 0; k < size; ++k) pairs[k] = {&a, Pose{}, &b, at[begin + k]};
            distance_batch(std::span(pairs).first(size), std::span(results).subspan(begin, size));
        }
    }
};

struct Work {
    World world;  // to be stepped, or to be reset to `start`
    World start;
    std::vector<DVec2> positions;
    std::vector<double> angles;
};

}  // namespace

// The world of a snapshot, for run(). It stays until the process ends.
extern "C" [[gnu::visibility("default")]] void* load(const char* snapshot, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(snapshot, size));
    auto* const work = new Work{World::load(bytes), World::load(bytes), {}, {}};
    work->positions.resize(work->world.bodies().size());
    work->angles.resize(work->world.bodies().size());
    return work;
}

extern "C" [[gnu::visibility("default")]] void run(void* loaded, const char* name, int repetitions) {
    static Batch batch;
    Work& work = *static_cast<Work*>(loaded);
    const std::string_view what(name);
    for (int i = 0; i < repetitions; ++i) {
        if (what == "step") work.world.step();
        if (what == "poses") work.world.read_states({.positions = work.positions, .angles = work.angles});
        if (what == "distances") batch.run();
        if (what == "reset") work.world.assign(work.start);
    }
}
