#include "sweep/plan/written_reader.hpp"

#include <cmath>

namespace tumble::sweep {

namespace {

using scene::Diagnostics;
using scene::Json;

constexpr std::uint64_t kMostSteps = 1000000;
constexpr double kSmallestSide = 16.0, kLargestSide = 4096.0;  // pixels

void read_trajectory(PlanObject& object, Diagnostics& diagnostics, Written& written) {
    const Json* const json = object.find("trajectory");
    if (json == nullptr) return;
    PlanObject trajectory(*json, object.pointer_to("trajectory"), diagnostics);
    written.trajectory_every = trajectory.whole("every", 1, kMostSteps, 1);
    written.trajectory_in_tar = trajectory.word("as", {"hdf5", "npy"}) == "npy";
    written.trajectory_bits = static_cast<int>(trajectory.whole("bits", 32, 64, 32));
    if (written.trajectory_bits % 32 != 0) trajectory.error("bits", "must be 32 or 64");
    trajectory.finish();
}

bool is_side(double pixels) {
    return pixels >= kSmallestSide && pixels <= kLargestSide && std::floor(pixels) == pixels;
}

// How frames look, and as which files.
void read_look(PlanObject& frames, Pictures& pictures) {
    pictures.is_plain = frames.flag("plain", false);
    pictures.is_video = frames.word("as", {"png", "mp4"}) == "mp4";
    if (pictures.is_video && (pictures.width % 2 != 0 || pictures.height % 2 != 0))
        frames.error("size", "must have even sides for an MP4, whose colours have half the resolution");
}

// `otherwise` has the size of pictures that do not state one.
Pictures read_pictures(PlanObject& object, const char* key, const Pictures& otherwise, Diagnostics& diagnostics) {
    Pictures pictures = otherwise;
    pictures.every = 0;
    pictures.is_video = false;
    const Json* const json = object.find(key);
    if (json == nullptr) return pictures;
    PlanObject inner(*json, object.pointer_to(key), diagnostics);
    pictures.every = inner.whole("every", 1, kMostSteps, otherwise.every > 0 ? otherwise.every : 1);
    if (const auto size = inner.pair("size")) {
        if (is_side(size->first) && is_side(size->second)) {
            pictures.width = static_cast<int>(size->first);
            pictures.height = static_cast<int>(size->second);
        } else {
            inner.error("size", "must be [width, height], whole numbers from 16 to 4096");
        }
    }
    if (std::string_view(key) == "frames") read_look(inner, pictures);
    inner.finish();
    return pictures;
}

}  // namespace

Written read_written(PlanObject& plan, Diagnostics& diagnostics) {
    Written written;
    const Json* const json = plan.find("write");
    if (json == nullptr) return written;
    PlanObject object(*json, plan.pointer_to("write"), diagnostics);
    read_trajectory(object, diagnostics, written);
    written.frames = read_pictures(object, "frames", {}, diagnostics);
    written.masks = read_pictures(object, "masks", written.frames, diagnostics);
    written.events = object.flag("events", false);
    written.contacts = object.flag("contacts", false);
    written.final_state = object.flag("final_state", false);
    written.summary = object.flag("summary", false);
    object.finish();
    return written;
}

}  // namespace tumble::sweep
