#include "render/frame/notes.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "render/frame/text_plates.hpp"
#include "render/style/style.hpp"
#include "render/view/box.hpp"
#include "render/view/named_body.hpp"

namespace tumble::render {
namespace {

// Pixels at 720 rows.
constexpr double kNoteSize = 14.0;
constexpr double kNoteGap = 7.0;  // from the point to the plate
constexpr double kCardTitle = 32.0;
constexpr double kCardText = 17.0;
constexpr double kCardGap = 4.0;  // between title and text
constexpr double kCardPadding = 28.0;
constexpr double kCardEdge = 1.0;

constexpr std::size_t kMostLines = 40;  // of a note or a card: more would not fit in a frame

void add_lines(std::vector<TextLine>& lines, const Captions& captions, const std::string& text, double size,
               double room, Color color) {
    std::istringstream in(text);
    for (std::string line; lines.size() < kMostLines && std::getline(in, line);)
        lines.push_back({captions.fitted(line, size, room), size, color});
}

// Each line in the middle.
void add_centered(Captions& captions, const std::vector<TextLine>& lines, const TextBox& box) {
    double top = box.top;
    for (const TextLine& line : lines)
        captions.line(line, box.left + 0.5 * (box.width - captions.width(line.text, line.size)), top);
}

void add_note(Captions& captions, const View& view, const std::string& text, DVec2 point, Color color) {
    const double edge = captions.pixels(style::kMargin), pad = captions.pixels(Captions::kPadding);
    std::vector<TextLine> lines;
    add_lines(lines, captions, text, captions.pixels(kNoteSize), view.width - 2.0 * edge, color);
    if (lines.empty()) return;
    const DVec2 size = captions.size_of(lines);
    const double left = 0.5 * view.width + point.x - 0.5 * size.x;
    const double top = 0.5 * view.height - point.y - captions.pixels(kNoteGap) - pad - size.y;
    const TextBox box{std::clamp(left, edge, std::max(edge, view.width - edge - size.x)),
                      std::clamp(top, edge, std::max(edge, view.height - edge - size.y)), size.x, size.y};
    captions.plate(box);
    add_centered(captions, lines, box);
}

TextBox grown(const TextBox& box, double by) {
    return {box.left - by, box.top - by, box.width + 2.0 * by, box.height + 2.0 * by};
}

// An opaque plate with a thin edge.
void add_card(Captions& captions, const View& view, const SceneCard& card, const Colors& colors) {
    const double room = view.width - 2.0 * captions.pixels(style::kMargin + kCardPadding);
    std::vector<TextLine> lines;
    add_lines(lines, captions, card.title, captions.pixels(kCardTitle), room, colors.text);
    if (!card.text.empty()) lines.push_back({"", captions.pixels(kCardGap), colors.text});
    add_lines(lines, captions, card.text, captions.pixels(kCardText), room, colors.faint_text);
    const DVec2 size = captions.size_of(lines);
    const TextBox box{0.5 * (view.width - size.x), 0.5 * (view.height - size.y), size.x, size.y};
    const double padding = captions.pixels(kCardPadding), edge = captions.pixels(kCardEdge);
    captions.box(grown(box, padding + edge), captions.pixels(Captions::kPadding) + edge, colors.faint_text);
    captions.box(grown(box, padding), captions.pixels(Captions::kPadding), colors.background);
    add_centered(captions, lines, box);
}

}  // namespace

std::optional<DVec2> position_of(const SceneNote& note, const SceneWorld& world, double time) {
    if (time < note.from || (note.until && time >= *note.until)) return std::nullopt;
    if (note.position) return note.position;
    const SceneInstance* const body = find_body(world, note.above);
    const Box box = body ? box_of(world.world, body->id) : Box{};
    if (box.is_empty()) return std::nullopt;
    return DVec2{box.center().x, box.upper.y};
}

void add_notes(DrawList& list, GlyphAtlas& atlas, const View& view, const SceneCamera& camera, const SceneWorld& world,
               double time, const Colors& colors) {
    if (!has_text(view)) return;
    if (camera.card && time < camera.card->until) {
        Captions card(list.card, atlas, view, colors.background);
        return add_card(card, view, *camera.card, colors);
    }
    Captions captions(list.notes, atlas, view, colors.background);
    for (const SceneNote& note : camera.notes) {
        const std::optional<DVec2> position = position_of(note, world, time);
        if (!position) continue;
        const DVec2 point = view.to_pixels(*position);
        if (view.is_in_view(point, 0.0)) add_note(captions, view, note.text, point, colors.text);
    }
}

}  // namespace tumble::render
