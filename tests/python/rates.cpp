// For measure.py: does in C++ what it does in Python. rates PYRAMID BODIES START reads three snapshots, then lines from
// the standard input, "step 10": the work and its repetitions. It prints the seconds of CPU time that each has taken.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "tumble/distance.hpp"
#include "tumble/world.hpp"

namespace {

using namespace tumble;

World load(const char* file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return World::load(std::as_bytes(std::span(bytes)));
}

// Of this process.
double cpu_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Pairs of boxes on a circle about each other: pair i at 2.4 m, at angles that differ.
struct Batch {
    static constexpr std::size_t kPairs = 1'000'000, kChunk = 256;
    Shape a = make_box({2.0f, 1.0f}), b = make_box({1.0f, 1.0f}, 0.1f);
    std::vector<Pose> at;
    std::vector<DistanceResult> results;

    Batch() : results(kPairs) {
        for (std::size_t i = 0; i < kPairs; ++i) {
            const Rotation turn = make_rotation(1e-3 * double(i));
            at.push_back({{2.4 * double{turn.c}, 2.4 * double{turn.s}}, make_rotation(7e-4 * double(i))});
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

}  // namespace

int main(int count, char** files) {
    if (count != 4) return EXIT_FAILURE;
    World pyramid = load(files[1]), worn = load(files[3]);
    const World bodies = load(files[2]), start = load(files[3]);
    std::vector<DVec2> positions(bodies.bodies().size());
    std::vector<double> angles(bodies.bodies().size());
    Batch batch;
    std::string work;
    for (int repetitions = 0; std::cin >> work >> repetitions;) {
        const double begin = cpu_seconds();
        for (int i = 0; i < repetitions; ++i) {
            if (work == "step") pyramid.step();
            if (work == "poses") bodies.read_states({.positions = positions, .angles = angles});
            if (work == "distances") batch.run();
            if (work == "reset") worn.assign(start);
        }
        std::printf("%.9f\n", cpu_seconds() - begin);
        std::fflush(stdout);
    }
}
