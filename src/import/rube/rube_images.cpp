#include "import/rube/rube_images.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include "scene/model/degrees.hpp"

namespace tumble::scene {

namespace {

// The corners are lower left, lower right, upper right and upper left, without the flip. An export without them has the
// proportions of the file.
void read_size(RubeObject& json, SceneImage& image, const std::string& owner, RubeNotes& notes) {
    image.height = json.number("scale", 1.0);
    const double stretch = json.number("aspectScale", 1.0);
    std::vector<DVec2> corners;
    if (json.has("corners")) corners = json.points("corners");
    if (corners.size() != 4) {
        if (stretch != 1.0)
            notes.add_of(owner, "stretched images without corners, shown in the proportions of their files");
        return;
    }
    image.width = length(corners[1] - corners[0]);
    image.height = length(corners[3] - corners[0]);
}

// By its extension: frames read these formats.
bool is_picture(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".bmp";
}

bool has_size(const SceneImage& image) { return image.height > 0.0 && image.width.value_or(1.0) > 0.0; }

}  // namespace

std::vector<RubeImage> read_rube_images(std::vector<RubeObject> list, std::size_t body_count, RubeNotes& notes) {
    std::vector<RubeImage> all;
    std::vector<double> orders;
    for (RubeObject& json : list) {
        RubeImage read;
        read.image.file = json.text("file");
        std::ranges::replace(read.image.file, '\\', '/');  // of an editor on Windows
        const std::string owner = "'" + read.image.file + "'";
        if (json.number("body", -1.0) >= 0.0) {
            const int index = json.index("body", body_count, "bodies");
            if (index < 0) continue;
            read.body = static_cast<std::size_t>(index);
        }
        read.image.center = json.vector("center");
        read.image.angle = json.number("angle") * kDegrees;
        read.image.opacity = std::clamp(json.number("opacity", 1.0), 0.0, 1.0);
        read.image.flip = json.flag("flip");
        read_size(json, read.image, owner, notes);
        const double order = json.number("renderOrder");
        if (json.has("colorTint")) notes.add_of(owner, "tints of images");
        if (json.has("customProperties")) notes.add_of(owner, "custom properties of images");
        json.skip({"name", "filter", "colorTint", "customProperties", "glVertexPointer", "glTexCoordPointer",
                   "glDrawElements"});
        json.note_unread("image", notes);
        if (read.image.file.empty() || !has_size(read.image)) {
            notes.add_of(owner, "images without a file or a size, left out");
            continue;
        }
        if (!is_picture(read.image.file)) {
            notes.add_of(owner, "images that are not PNG, JPEG or BMP files, left out");
            continue;
        }
        all.push_back(std::move(read));
        orders.push_back(order);
    }
    std::vector<double> ranks = orders;
    std::ranges::sort(ranks);
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto rank = static_cast<int>(std::ranges::lower_bound(ranks, orders[i]) - ranks.begin());
        all[i].image.order = all[i].body ? rank : rank - static_cast<int>(ranks.size());
    }
    return all;
}

}  // namespace tumble::scene
