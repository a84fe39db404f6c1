// Labels of frames, for learning: which body each pixel shows, what covers what, and the outlines of shapes.
//
// They are computed on the CPU from the shapes and the camera, not read from a drawn frame: edges are exact, the bits
// are the same on every machine, and no OpenGL is needed. The order in which bodies cover one another is that of the
// frames of a Renderer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "tumble/render.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// The label of a body; 0: no body.
using BodyLabel = std::uint16_t;

// Bodies after this number have no label: masks leave them out.
inline constexpr std::size_t kMostLabels = 65535;

// The body that each pixel of a frame shows: the topmost whose shape contains the pixel's centre. Sensors are left out,
// and so is what is drawn over the bodies. A shape without area has the width of its line in the frame.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<BodyLabel> labels;  // [height][width], top row first
};

// A body that has pixels in the frame.
struct LabelledBody {
    BodyLabel label = 0;
    BodyId body{};
    std::size_t pixels = 0;   // of the frame that its shapes contain
    std::size_t visible = 0;  // of them, those that show it
    // The visible pixels are in these columns and rows, both ends included. Empty (last < first) if there are none.
    int first_column = 0, last_column = -1;
    int first_row = 0, last_row = -1;
};

// Pixels of `below` that show `above`.
struct CoveredPixels {
    BodyLabel above = 0;
    BodyLabel below = 0;
    std::size_t pixels = 0;
};

// A shape in view.
struct LabelledShape {
    BodyLabel label = 0;
    ShapeId shape{};
};

struct FrameLabels {
    Mask mask;
    std::vector<LabelledBody> bodies;    // in the order of their labels
    std::vector<CoveredPixels> covered;  // in the order of `above`, then of `below`
    std::vector<LabelledShape> order;    // of drawing: each shape covers those before it
};

// Labels frames of one size.
class Labeller {
public:
    // Throws std::invalid_argument for a side outside kSmallestFrame to kLargestFrame.
    Labeller(int width, int height);
    ~Labeller();
    Labeller(Labeller&&) noexcept;
    Labeller& operator=(Labeller&&) noexcept;

    // Of the frame that Renderer::draw() draws. The label of SceneWorld::bodies[i] is i + 1, which no later body gets;
    // bodies that a program added have the labels after them, in the order of their ids. The result is valid until the
    // next call. Throws std::invalid_argument for a camera that is not finite or without height.
    const FrameLabels& label(const Scene& scene, const SceneWorld& world, const Camera& camera);

    // The same for a world without a scene. The label of a body is BodyId::index + 1.
    const FrameLabels& label(const World& world, const Camera& camera);

    // The mask alone, which takes a fraction of the time.
    const Mask& mask(const World& world, const Camera& camera);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The outline of a shape in a frame, clipped to it: columns and rows from the upper left corner (pixels), clockwise as
// seen in the frame. Arcs are chords at most 1/20 pixel off. Empty if the shape is out of view.
std::vector<DVec2> frame_outline(const Shape& shape, const Pose& pose, const Camera& camera, int width, int height);

// Writes a mask as a PNG file of one channel with 16 bits. Throws FileError. Returns the size in bytes.
std::uint64_t write_mask_png(const Mask& mask, const std::filesystem::path& file);

}  // namespace tumble
