// Pictures of two runs in the same step, side by side or one over the other.
#pragma once

#include <cstdint>
#include <functional>

#include "tools/compare/compared_runs.hpp"
#include "tools/run/run_options.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

struct PairPicture {
    std::uint64_t step = 0;
    double time = 0.0;  // s
    Image image;
};

struct PairPictures {
    FrameSize size;            // of one of two pictures
    bool is_overlaid = false;  // one over the other, each half transparent
    Overlay overlay;
    RenderBackend renderer = RenderBackend::automatic;
};

// The theme of both pictures: that of the scene A if none is chosen.
Theme theme_of(const Scene& a, const PairPictures& pictures);

// The size of a picture of both.
FrameSize pair_size(const PairPictures& pictures);

// Simulates both runs again and draws the steps that are wanted, in their order. The camera is that of A. Draws nothing
// if one of the runs is a table, which has no shapes, and nothing more after an interrupt. Throws as
// StateSource::next(), RenderError.
void draw_pairs(const CompareInputs& inputs, const PairPictures& pictures,
                const std::function<bool(std::uint64_t step)>& is_wanted, const std::function<void(PairPicture)>& take);

}  // namespace tumble::tools
