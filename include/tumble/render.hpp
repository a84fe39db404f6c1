// Frames without a display: a draw list made from a scene's world, drawn off-screen, written as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/drawing.hpp"
#include "tumble/math.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// No off-screen context, no font, a shader that does not compile: what was tried and why it failed.
class RenderError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // [height][width][4], top row first
};

struct Camera {
    DVec2 center;         // world point in the middle of the frame
    double height = 1.0;  // m of the world from the lower to the upper edge
    BodyId follows{};     // the body it moves with; default: none yet
    DVec2 offset{};       // then: the center seen from that body's position
};

// The scene's own camera. What it leaves open is chosen so that there is in view, with a margin: every body that moves
// where it begins, also those that the timeline makes; their ways, but for bodies that go farther than a frame three
// times as high; the ground below them; and of what never moves all, or as far as it is near. To know the ways the
// scene is run ahead, for some 0.1 s at most, unless it has thousands of bodies. A camera that follows a body is five
// times as high as the body's larger side. To be made from a world that was not stepped yet.
Camera make_camera(const Scene& scene, const SceneWorld& world, double aspect_ratio);

// The camera where the body it follows is now: it begins to follow a body that the timeline makes in the first state
// that has it, and stays where it is once that is gone. To be called after each step, so that a run shows the same
// however many of its steps are drawn.
Camera move_camera(Camera camera, const Scene& scene, const SceneWorld& world);

// What a frame points at, and says about it: the edges of regions and bodies are drawn strongly, and an arrow at the
// edge of the frame points at what is out of view.
struct Marking {
    std::vector<std::array<DVec2, 4>> regions{};  // corners in order, world coordinates
    std::vector<BodyId> bodies{};
    std::vector<std::string> caption{};  // lines below the time
};

// The camera with what is marked in view too, as far as a frame three times as high can show it.
Camera widen_camera(Camera camera, const World& world, const Marking& marking, double aspect_ratio);

// What a frame shows beside the shapes, each with a line in the legend.
struct Overlay {
    bool contacts = false;  // points, by whether the surfaces overlap
    bool normals = false;   // from A to B at each point
    bool aabbs = false;     // the box around each shape
    bool islands = false;   // a colour an island, pale if it sleeps
    bool velocity = false;  // of each centre of mass
    bool joints = false;    // from each body to its anchor
};

struct OverlayPart {
    std::string_view name;
    bool Overlay::*member;
};
inline constexpr std::array<OverlayPart, 6> kOverlayParts{{{"contacts", &Overlay::contacts},
                                                           {"normals", &Overlay::normals},
                                                           {"aabbs", &Overlay::aabbs},
                                                           {"islands", &Overlay::islands},
                                                           {"velocity", &Overlay::velocity},
                                                           {"joints", &Overlay::joints}}};

inline constexpr int kSmallestFrame = 16, kLargestFrame = 8192;  // pixels a side

// Draws frames of one size. Holds the off-screen context: use it from the thread that made it.
class Renderer {
public:
    // kSmallestFrame to kLargestFrame each, else std::invalid_argument. Loads OSMesa and the font; throws RenderError.
    Renderer(int width, int height);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Draws the world as it is now, with the scene's name and `time` (s) as text, into `image`, resized as needed.
    void draw(const Scene& scene, const SceneWorld& world, const Camera& camera, double time, Image& image,
              const Overlay& overlay = {}, const Marking& marking = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// An explanatory drawing as an image; what lies beyond its edges is cut off. Throws RenderError.
Image draw_image(const Drawing& drawing);

// Writes to a temporary name beside `file`, then renames. Throws FileError. The same image gives the same bytes.
void write_png(const Image& image, const std::filesystem::path& file);

// Encodes and writes PNG files on threads of its own, a bounded number in flight.
class FrameWriter {
public:
    explicit FrameWriter(int threads);
    ~FrameWriter();  // waits for what was submitted; errors are lost: call finish()
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // An image to draw into: one that was written already if there is one.
    Image take_image();

    // Queues the image; waits while too many are queued. Throws the first FileError of earlier frames.
    void submit(Image image, std::filesystem::path file);

    // Waits for all; throws the first FileError. Returns the number of files and bytes written.
    struct Written {
        std::uint64_t files = 0;
        std::uint64_t bytes = 0;
        double encode_seconds = 0.0;  // summed over the threads
    };
    Written finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
