// Measures how the time and the memory of a world grow with its number of bodies.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace tumble::tools {

// What the bodies do. All are boxes of 1 m, on a floor of one static body for each 999 boxes.
enum class GrowthWorld {
    pile,  // columns of nine boxes that stand side by side and do not sleep
    rain,  // the same with gaps of 0.3 m between the boxes, which fall on each other while they are timed
    city   // the pile asleep, with nine boxes awake for each 990
};

struct GrowthName {
    GrowthWorld world;
    const char* name;
};
inline constexpr std::array<GrowthName, 3> kGrowthWorlds{
    {{GrowthWorld::pile, "pile"}, {GrowthWorld::rain, "rain"}, {GrowthWorld::city, "sleeping city"}}};

inline constexpr int kSmallestGrowth = 1000, kLargestGrowth = 1000000;  // bodies

struct GrowthOptions {
    int runs = 3;
    int threads = 1;  // of a step
};

// Wall-clock times: the medians of the runs.
struct GrowthResult {
    std::string world;
    int bodies = 0;
    int awake = 0;          // dynamic bodies that the last step moved
    double load_us = 0.0;   // to read the scene, a body
    double build_us = 0.0;  // to make its world, a body
    double step_us = 0.0;   // a body
    double bytes = 0.0;     // of the world after the last step, a body
    double frame_ms = 0.0;  // to draw all bodies in 1280 x 720 pixels and write the PNG file
};

// The mean of 20 steps, after 20 others. A frame is drawn after the last one. `bodies` is a multiple of
// kSmallestGrowth.
GrowthResult bench_growth(const GrowthName& world, int bodies, const GrowthOptions& options);

// kSmallestGrowth and its multiples by powers of ten, up to `most`.
std::vector<int> growth_sizes(int most);

}  // namespace tumble::tools
