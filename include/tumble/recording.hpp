// Recordings of a run: a video of its frames, a replay, which is one HTML page that plays the run in any browser
// without a network, and labels of its frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tumble/render.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

enum class VideoFormat { mp4, webm, gif, apng };

// By the extension, in any case: .mp4 (H.264), .webm (VP9), .gif, .apng. Nothing for others.
std::optional<VideoFormat> video_format_of(const std::filesystem::path& file);

struct VideoSettings {
    VideoFormat format = VideoFormat::mp4;
    int width = 0;  // pixels; even for mp4 and webm, whose colours have half the resolution
    int height = 0;
    double frames_per_second = 60.0;  // > 0; a GIF has at most 50, and leaves out frames above that
};

// Throws RenderError if the program ffmpeg is missing. A VideoWriter throws the same.
void require_encoder();

// A video that the program ffmpeg encodes while the frames are drawn, with a constant frame rate: n frames last n /
// frames_per_second. The colours of mp4 and webm are yuv420p, BT.709. The same frames and the same ffmpeg give the same
// bytes, whatever the number of processors.
//
// All functions throw RenderError if ffmpeg is missing, fails or is ended, with its last line of error text, and
// FileError if the file cannot be written, such as on a full disk.
class VideoWriter {
public:
    // Starts ffmpeg, which writes to the temporary file of an OutputFile, or to standard output for /dev/stdout: an MP4
    // is then a series of fragments, which players read as they come; an APNG throws FileError. For a GIF, ffmpeg keeps
    // all frames until finish(), because one palette serves all: four bytes a pixel, which the caller has to limit.
    VideoWriter(std::filesystem::path file, const VideoSettings& settings);
    ~VideoWriter();  // without finish(): ends ffmpeg and removes the temporary file
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;

    // Appends a frame. Throws std::invalid_argument if it does not have the size of the video. Waits for ffmpeg if that
    // is several frames behind.
    void write(const Image& image);

    // Waits for ffmpeg and renames the file. Returns its size in bytes. To be called once, last, after a frame. After
    // an error of write() it throws the same error.
    std::uint64_t finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Limits of the memory that a replay takes. A browser unpacks 12 bytes for each pose and 16 for each contact point. The
// recorder packs them into about 4 bytes each, at most 15 and 20; page() takes three times that for a moment. A contact
// that begins counts as ten points more.
inline constexpr std::size_t kMostReplayPoses = 30'000'000;
inline constexpr std::size_t kMostReplayContactPoints = 60'000'000;

// A claim of the scene as the page shows it: a mark at the step that decided it, green or red, and the regions and
// bodies of the marking. The page has no caption.
struct ReplayClaim {
    ExpectationResult result;
    Marking marking{};
};

struct ReplaySettings {
    double aspect_ratio = 16.0 / 9.0;  // width of the frames over their height
    bool contacts = true;              // record the contact points, which doubles the size of the page
    std::optional<Theme> theme{};      // of the first view; default: that of the scene's style if it is not light,
                                       // else light or dark as the reader's system is
    std::size_t most_poses = kMostReplayPoses;
    std::size_t most_contact_points = kMostReplayContactPoints;
};

// Records the states of a run. Positions are kept to half a quantum: 0.5 mm, or less in a world whose
// WorldDef::scale is below 1; angles to 1/8192 turn. The same run gives the same page.
class ReplayRecorder {
public:
    // Copies what it needs of the scene.
    ReplayRecorder(const Scene& scene, const ReplaySettings& settings);
    ~ReplayRecorder();
    ReplayRecorder(ReplayRecorder&&) noexcept;
    ReplayRecorder& operator=(ReplayRecorder&&) noexcept;

    // To be called for the initial state and after each step, with the camera of its frame: see move_camera(). From the
    // step on with which the replay would have more poses or contact points than the settings allow, nothing is
    // recorded.
    void record(const SceneWorld& built, const Camera& camera);

    // The same for a world that another engine moves: it has made `step` steps, whatever World::step_count() says.
    void record_as(std::uint64_t step, const SceneWorld& built, const Camera& camera);

    // True if every state so far is recorded.
    bool is_whole() const noexcept;

    // The page of the states so far, of which there must be one. `complete` is false for a run that ended early, which
    // the page says.
    std::string page(std::span<const ReplayClaim> claims, bool complete) const;

private:
    friend std::string pair_page(const struct ReplayPair& pair);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Two recorded runs with the same steps, and how far they are apart. The references must be valid until the page is
// made. Texts never become markup.
struct ReplayPair {
    const ReplayRecorder& a;
    const ReplayRecorder& b;
    std::string title;
    std::string name_a, name_b;
    std::optional<std::uint64_t> first_difference{};  // its step
    std::vector<double> distances{};                  // [step], m: the largest in x or y of a body in both
    std::vector<double> energies_a{}, energies_b{};   // [step], J; NaN where they are not known
};

// One HTML page that plays both runs side by side or over each other, with the view of A, above plots of their distance
// and their energies. It has no contact points. Each recorder must have a state.
std::string pair_page(const ReplayPair& pair);

// ---- Labels ----
//
// Labels of frames, for learning: which body each pixel shows, what covers what, and the outlines of shapes. They are
// computed on the CPU from the shapes and the camera, not read from a drawn frame: edges are exact, the bits are the
// same on every machine, and no OpenGL is needed. The order in which bodies cover one another is that of the frames of
// a Renderer.

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

// The bytes of a mask as a PNG file of one channel with 16 bits. The same mask gives the same bytes.
std::string to_png(const Mask& mask);

// Writes them. Throws FileError. Returns the size in bytes.
std::uint64_t write_mask_png(const Mask& mask, const std::filesystem::path& file);

}  // namespace tumble
