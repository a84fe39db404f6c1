// Frames without a display: cameras, an off-screen renderer, and picture files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/drawing.hpp"
#include "tumble/math.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// There is no off-screen context, no font for a text, or a shader does not compile. The message names what was tried.
class RenderError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A picture file that is damaged or too large. The message is its path and the reason.
class PictureError : public std::runtime_error {
public:
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
    BodyId follows{};     // the body that the camera follows; default: none
    DVec2 offset{};       // of the center from that body's position
};

// The camera of the scene; what the scene leaves open is fitted to the world with a margin. In view are: the first pose
// of every dynamic and kinematic body, including those that the timeline spawns; their motions, except of bodies that
// leave a frame three times as high; the ground below them; and all static shapes, or those nearby if all would need
// too large a frame. The motions come from a run of the scene of about 0.1 s of wall time, which is left out if it has
// thousands of bodies. If half of the moving bodies leave that frame sideways, and the scene states no centre, the
// camera follows the largest of them. The frame of a camera that follows a body is five times as high as the body's
// larger side. Call it before the first step of the world.
Camera make_camera(const Scene& scene, const SceneWorld& world, double aspect_ratio);

// The camera that shows the present state of a world, with a margin: all bodies that are not static, the ground below
// them, and all static shapes if they do not make the frame too large.
Camera make_camera(const World& world, double aspect_ratio);

// The camera moved with the body that it follows. A body that the timeline spawns is followed from the first state that
// contains it. When the body is destroyed, the camera stays. Call it after every step, drawn or not, so that frames do
// not depend on how many are drawn.
Camera move_camera(Camera camera, const Scene& scene, const SceneWorld& world);

// The camera as the key frames of the scene have it at the present time of the world; without key frames the camera
// itself. Draw with the result, and move the camera itself.
Camera apply_camera_keys(const Camera& camera, const Scene& scene, const SceneWorld& world, double aspect_ratio);

// The path of a body so far: its centre of mass after every `stride` steps.
struct Trail {
    BodyId body;
    std::uint64_t stride = 1;
    std::vector<DVec2> points{};
};

// At most this many points are kept of a trail: when it is full, every second point goes and the stride doubles.
inline constexpr std::size_t kMostTrailPoints = 4096;

// Appends the present position of each body of the scene that has a trail. Call it after every step, and once before
// the first.
void record_trails(std::vector<Trail>& trails, const Scene& scene, const SceneWorld& world);

// Highlights of a frame: strong outlines of regions and bodies, and arrows at the edge of the frame towards those out
// of view.
struct Marking {
    std::vector<std::array<DVec2, 4>> regions{};  // corners in order, world coordinates
    std::vector<BodyId> bodies{};
    std::vector<std::string> caption{};  // lines below the time
    std::vector<Trail> trails{};         // lines below the bodies; only in frames of a scene
};

// The camera with the frame grown to contain the marking. Regions and bodies that need a frame more than three times as
// high stay out of view.
Camera widen_camera(Camera camera, const World& world, const Marking& marking, double aspect_ratio);

// State of the simulation that a frame shows over the shapes, each with a line in the legend.
struct Overlay {
    bool contacts = false;  // contact points, in one colour if the surfaces overlap and in another if not
    bool normals = false;   // from A to B at each contact point
    bool aabbs = false;     // the bounding box of each shape
    bool islands = false;   // one colour per island, pale if the island sleeps
    bool velocity = false;  // of each centre of mass
    bool joints = false;    // lines from the centres of mass to the anchors
    bool forces = false;    // of contacts on bodies that are not static, the mean over a step

    // Parts of every frame, which can be left out.
    bool title = true;
    bool time = true;
    bool scale_bar = true;
    bool grid = true;
    bool notes = true;  // of the scene, and its title card

    // The colours; without it those of the scene's style, of a world without a scene Theme::light.
    std::optional<Theme> theme{};
};

struct OverlayPart {
    std::string_view name;
    bool Overlay::*member;
};
inline constexpr std::array<OverlayPart, 7> kOverlayParts{{{"contacts", &Overlay::contacts},
                                                           {"normals", &Overlay::normals},
                                                           {"aabbs", &Overlay::aabbs},
                                                           {"islands", &Overlay::islands},
                                                           {"velocity", &Overlay::velocity},
                                                           {"joints", &Overlay::joints},
                                                           {"forces", &Overlay::forces}}};

// Those of every frame.
inline constexpr std::array<OverlayPart, 5> kFrameParts{{{"title", &Overlay::title},
                                                         {"time", &Overlay::time},
                                                         {"scale", &Overlay::scale_bar},
                                                         {"grid", &Overlay::grid},
                                                         {"notes", &Overlay::notes}}};

// True for themes with a dark background.
bool is_dark(Theme theme);

// Frames with less width or height have no text: it would hide their bodies.
inline constexpr int kSmallestTextWidth = 400, kSmallestTextHeight = 225;  // pixels

inline constexpr int kSmallestFrame = 16, kLargestFrame = 8192;  // pixels per side

// The libraries that offer OpenGL without a display. Each is loaded when it is first used; none is needed for anything
// but frames and other pictures. Frames of two back ends differ by 2/255 at most.
enum class RenderBackend {
    automatic,  // OSMesa, or EGL if it is missing
    osmesa,     // Mesa's software rasteriser; Mesa has it until version 25.0
    egl         // EGL without a surface: the driver of a graphics card, or Mesa's software rasteriser
};

struct BackendName {
    std::string_view name;
    RenderBackend backend;
};
inline constexpr std::array<BackendName, 3> kBackends{
    {{"auto", RenderBackend::automatic}, {"osmesa", RenderBackend::osmesa}, {"egl", RenderBackend::egl}}};

// Draws one triangle and looks at its pixels.
struct BackendCheck {
    bool works = false;
    std::string version{};   // of OpenGL, as the library states it
    std::string renderer{};  // what draws: the rasteriser or the card
    std::string error{};     // empty if it works
};
BackendCheck check_backend(RenderBackend backend);

// The font of the text in frames, and one that has the characters of many scripts, Chinese ones too. Empty if missing:
// frames with text need the first.
struct FontFiles {
    std::string text;
    std::string wide;
};
FontFiles find_font_files();

// Draws frames of one size. Owns an off-screen context: use it on the thread that made it.
class Renderer {
public:
    // Loads the back end; the first text loads the font. Throws RenderError, or std::invalid_argument for a side
    // outside kSmallestFrame to kLargestFrame.
    Renderer(int width, int height, RenderBackend backend = RenderBackend::automatic);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Draws the present state of the world, with the scene's name and `time` (s) as text, into `image`, which is
    // resized. Images of bodies are read when they are first drawn; where a file is missing, the outline is drawn.
    // Throws PictureError if they are damaged or have more than 64 million pixels, FileError if they cannot be read.
    // Bodies and joints that a program added to the run's world are drawn after the scene's own. Throws
    // std::invalid_argument for a camera that is not finite or without height.
    void draw(const Scene& scene, const SceneWorld& world, const Camera& camera, double time, Image& image,
              const Overlay& overlay = {}, const Marking& marking = {});

    // The same for a world without a scene, with its time as text. Colours follow from types and ids of the bodies.
    void draw(const World& world, const Camera& camera, Image& image, const Overlay& overlay = {},
              const Marking& marking = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The drawing as an image, clipped to its size. Throws RenderError.
Image draw_image(const Drawing& drawing, RenderBackend backend = RenderBackend::automatic);

// Reads a PNG file. Throws FileError, or PictureError for a file that is damaged, no PNG, or has a side of more than
// kLargestFrame pixels.
Image read_png(const std::filesystem::path& file);

// The same for a PNG, JPEG or BMP file, whatever its name is.
Image read_picture(const std::filesystem::path& file);

// Writes to a temporary name beside `file`, then renames. Throws FileError. The same image gives the same bytes.
void write_png(const Image& image, const std::filesystem::path& file);

// The bytes of that file.
std::string to_png(const Image& image);

// Those bytes as the address of a picture in a page: "data:image/png;base64,...".
std::string png_data_url(const Image& image);

// Encodes and writes PNG files on threads of its own. The number of queued images is bounded.
class FrameWriter {
public:
    explicit FrameWriter(int threads);  // 1 to 256, else std::invalid_argument
    ~FrameWriter();                     // waits for the queued frames and drops errors: call finish() to get them
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // An image to draw into: the buffer of a written frame if one is free, else a new one.
    Image take_image();

    // Queues the image; waits while the queue is full. Throws the first FileError of earlier frames.
    void submit(Image image, std::filesystem::path file);

    struct Written {
        std::uint64_t files = 0;
        std::uint64_t bytes = 0;
        double encode_seconds = 0.0;  // summed over the threads
    };

    // Waits for all frames. Throws the first FileError.
    Written finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
