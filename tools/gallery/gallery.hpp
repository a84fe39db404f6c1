// Many scenes at a glance: a picture, the claims and the timings of each.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/run_options.hpp"
#include "tools/scene/scene_check.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// Beside the page.
inline const std::filesystem::path kLoopFolder = "loops";

struct GalleryOptions {
    CheckOptions check{};          // its threads also draw
    FrameSize size{480, 270};      // of a picture
    std::optional<double> time{};  // s, of the pictures; without it the half of each scene's duration
    Overlay overlay{};
    std::optional<double> loop{};   // s: also a loop of each scene of this length, from `time` on
    std::filesystem::path loops{};  // the folder of the loops
};

struct GalleryEntry {
    SceneCheck check;
    std::string title, description;  // the scene's; the title is the file if it cannot be read
    double time = 0.0;               // s, of the picture
    std::optional<Image> picture;
    std::filesystem::path loop;  // a GIF; empty: none
    std::string picture_error;   // why there is none, if the scene itself has no error
};

// The threads of the options, or fewer if the memory for loops allows fewer at a time.
int affordable_threads(const GalleryOptions& options);

// Throws RenderError without an encoder, and CLI::ValidationError if the loops of so many scenes, as many at a time as
// there are threads, would need too much memory. To be called once before make_gallery(), if there are loops.
void require_loops(const GalleryOptions& options, std::size_t scenes);

// Checks and draws each scene, and writes its loop. Errors of a scene are part of its entry. The entries are in the
// order of the files.
std::vector<GalleryEntry> make_gallery(const std::vector<std::string>& files, const GalleryOptions& options);

// One HTML page, with the pictures in it, or with addresses of the loops in the folder `loops` beside it.
std::string gallery_page(const std::vector<GalleryEntry>& entries);

// The pictures of all entries that have one, `columns` in a row; nothing without any. A sheet is at most
// kLargestFrame px wide and high: pictures that do not fit are left out.
std::optional<Image> contact_sheet(const std::vector<GalleryEntry>& entries, int columns);

}  // namespace tumble::tools
