// Imports SVG drawings: one body for each figure that is drawn, in the order of the file.
//
// The drawing is mirrored so that y points upwards and its lower left corner is the origin. The scene states
// no camera: frames show where its bodies move.
// Parsed by pugixml, without entities or external files.
#include <algorithm>
#include <cmath>
#include <set>

#include "import/svg/svg_body.hpp"
#include "import/svg/svg_page.hpp"
#include "import/svg/svg_text.hpp"
#include "scene/format/field.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/input.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/problem_codes.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_import.hpp"

namespace tumble {

namespace scene {

namespace {

constexpr int kMostDepth = 100;                    // of groups and references; ends a cycle of references
constexpr int kMostElements = 200000;              // visited, references followed
constexpr std::size_t kMostPointsOfAll = 4000000;  // of all figures
constexpr std::size_t kLongestName =
    200;  // bytes; longer names are left out. Leaves room for a number within the limit of scene files

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

// Replaces bytes that are not UTF-8, which a scene file cannot contain.
std::string as_utf8(const std::string& text) { return Json::parse(quoted(text)).get<std::string>(); }

// The offset at which pugixml found a node or an error; it reports -1 if there is none.
std::size_t offset_of(std::ptrdiff_t offset) { return static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)); }

class SvgImport {
public:
    SvgImport(std::string_view text, const std::string& file_name, const SvgOptions& options)
        : options_(options), diagnostics_(file_name, text) {
        result_.scene.name = as_utf8(std::filesystem::path(file_name).stem().string());
        const pugi::xml_parse_result parsed = document_.load_buffer(text.data(), text.size());
        if (!parsed) error(parsed.offset, parsed.description());
    }

    ImportedScene run() {
        const pugi::xml_node root = document_.document_element();
        if (!diagnostics_.has_errors() && std::string_view(root.name()) != "svg")
            error(0, "expected an <svg> element, got " + quoted(root.name()));
        diagnostics_.finish(nullptr);
        index(root, 0);
        at_element(root, [&] { read_page(root); });
        SvgStyle style;
        at_element(root, [&] { style = read_style(root, sheet_, {}, result_notes_["gradients and patterns"]); });
        visit_children(root, page_, style, 0);
        diagnostics_.finish(nullptr);
        for (const auto& [feature, count] : result_notes_)
            if (count > 0) result_.notes.push_back({feature, count});
        return std::move(result_);
    }

private:
    void error(std::ptrdiff_t offset, const std::string& message) {
        diagnostics_.error_at_offset(offset_of(offset), message, "", codes::drawing);
    }

    // Runs `action` and reports an SvgError as an error at the element.
    template <class Action>
    void at_element(const pugi::xml_node& element, const Action& action) {
        try {
            action();
        } catch (const SvgError& found) {
            error(element.offset_debug(), '<' + std::string(element.name()) + ">: " + found.what());
            if (++errors_ == static_cast<int>(kMaxDiagnostics)) diagnostics_.finish(nullptr);
        }
    }

    // Collects the elements by id, and the style sheets.
    void index(const pugi::xml_node& element, int depth) {
        if (depth > kMostDepth) {
            error(element.offset_debug(), "elements are nested deeper than " + std::to_string(kMostDepth));
            diagnostics_.finish(nullptr);
        }
        if (const std::string_view id = element.attribute("id").value(); !id.empty()) by_id_.emplace(id, element);
        if (std::string_view(element.name()) == "style")
            result_notes_["style rules with other selectors than a tag, class or id"] +=
                sheet_.add(element.text().get());
        for (const pugi::xml_node child : element.children())
            if (child.type() == pugi::node_element) index(child, depth + 1);
    }

    // Places the page, whose lower left corner is the origin.
    void read_page(const pugi::xml_node& root) {
        const SvgPage page = read_svg_page(root);
        viewport_.size = page.size;
        const double metres = options_.metres_per_pixel;
        page_ = {{metres * page.pixels_per_unit.x, 0.0}, {0.0, -metres * page.pixels_per_unit.y}, {}};
        const DVec2 size = metres * DVec2{page.pixels_per_unit.x * page.size.x, page.pixels_per_unit.y * page.size.y};
        if (!(size.x > 0.0 && size.y > 0.0 && std::max(size.x, size.y) <= kLargest)) return;
        page_.origin = {-page_.x_axis.x * page.corner.x, -page_.y_axis.y * (page.corner.y + page.size.y)};
    }

    void visit_children(const pugi::xml_node& element, const Affine& map, const SvgStyle& style, int depth) {
        for (const pugi::xml_node child : element.children())
            if (child.type() == pugi::node_element) at_element(child, [&] { visit(child, map, style, depth + 1); });
    }

    void visit(const pugi::xml_node& element, const Affine& around, const SvgStyle& style_around, int depth) {
        if (depth > kMostDepth)
            throw SvgError("references are nested deeper than " + std::to_string(kMostDepth) + ", or form a cycle");
        if (++elements_ > kMostElements)
            throw SvgError("the drawing has more than " + std::to_string(kMostElements) + " elements");
        const std::string_view tag = element.name();
        if (!is_drawn(tag)) return note(tag);
        if (find_property(element, sheet_, "display") == "none") return count("hidden elements");
        note_effects(element);
        const SvgStyle style = read_style(element, sheet_, style_around, result_notes_["gradients and patterns"]);
        const Affine map = compose(around, parse_transform(element.attribute("transform").value()));
        if (tag == "use")
            follow(element, map, style, depth);
        else if (is_figure(tag))
            add_body(element, map,
                     with_opacity(style, result_notes_["transparent colours, made opaque as on white paper"]));
        else
            visit_children(element, tag == "svg" ? shifted(element, map) : map, style, depth);
    }

    static bool is_drawn(std::string_view tag) {
        return is_figure(tag) || is_one_of(tag, {"g", "a", "svg", "switch", "use"});
    }

    void note(std::string_view tag) {
        if (tag == "text") count("texts");
        if (tag == "image") count("images");
        if (tag == "foreignObject") count("foreign objects");
        if (tag == "script") count("scripts");
        if (is_one_of(tag, {"animate", "animateMotion", "animateTransform", "set"})) count("animations");
    }

    void note_effects(const pugi::xml_node& element) {
        const auto note_if = [&](std::string_view property, const char* feature) {
            const std::string_view value = find_property(element, sheet_, property);
            if (!value.empty() && value != "none") count(feature);
        };
        note_if("clip-path", "clip paths");
        note_if("mask", "masks");
        note_if("filter", "filters");
        for (const char* marker : {"marker-start", "marker-mid", "marker-end"}) note_if(marker, "markers");
        for (const pugi::xml_node child : element.children())
            if (is_figure(element.name())) note(child.name());
    }

    void count(const char* feature) { ++result_notes_[feature]; }

    Affine shifted(const pugi::xml_node& element, const Affine& map) {
        const auto length_of = [&](const char* name, double whole) {
            const pugi::xml_attribute attribute = element.attribute(name);
            return attribute ? parse_length(attribute.value(), whole) : 0.0;
        };
        if (element.attribute("viewBox")) count("viewBoxes of inner drawings");
        return compose(map,
                       {{1.0, 0.0}, {0.0, 1.0}, {length_of("x", viewport_.size.x), length_of("y", viewport_.size.y)}});
    }

    void follow(const pugi::xml_node& use, const Affine& map, const SvgStyle& style, int depth) {
        std::string_view target = use.attribute("href").value();
        if (target.empty()) target = use.attribute("xlink:href").value();
        const auto found = target.starts_with('#') ? by_id_.find(target.substr(1)) : by_id_.end();
        if (found == by_id_.end()) return count("references to elements that are not in the file");
        const Affine shift = shifted(use, map);
        if (std::string_view(found->second.name()) == "symbol")
            visit_children(found->second, shift, style, depth + 1);
        else
            visit(found->second, shift, style, depth + 1);
    }

    void add_body(const pugi::xml_node& element, const Affine& map, const SvgStyle& style) {
        const SvgFigure figure = read_figure(element, map, viewport_, options_.tolerance);
        const bool is_painted = style.visible && (style.fill.visible || style.stroke.visible);
        if (!is_painted && !style.type) return count("hidden elements");
        if (figure.contours.empty()) return count("elements without extent");
        for (const Contour& contour : figure.contours) points_ += contour.points.size();
        if (points_ > kMostPointsOfAll)
            throw SvgError("the drawing has more than " + std::to_string(kMostPointsOfAll) + " points");
        const double scale = std::sqrt(std::abs(cross(map.x_axis, map.y_axis)));
        SceneBody body = make_svg_body(figure, style, scale, result_notes_);
        if (body.shapes.empty()) return;
        const bool is_line = std::holds_alternative<ChainGeometry>(body.shapes.front().geometry);
        const std::string material = add_material(is_line || !style.fill.visible ? style.stroke : style.fill);
        for (SceneShape& shape : body.shapes) shape.material = material;
        body.name = make_name(std::string(label_of(element)));
        result_.scene.bodies.push_back(std::move(body));
    }

    // The name of the material of this colour, which is the colour.
    std::string add_material(const SvgPaint& paint) {
        if (!paint.visible || paint.color.empty()) return "";
        if (colors_.contains(paint.color)) return paint.color;
        if (colors_.size() == kMaxKeysInObject) {
            count("colours beyond the number of materials that a file may have");
            return "";
        }
        colors_.insert(paint.color);
        SceneMaterial& material = result_.scene.materials.emplace_back();
        material.name = material.color = paint.color;
        return paint.color;
    }

    // The label or id; further elements with the same one get a number.
    std::string make_name(const std::string& label) {
        const std::string name = as_utf8(label);
        if (name.empty() || name.size() > kLongestName) return "";
        std::string unique = name;
        while (!names_.insert(unique).second) unique = name + '-' + std::to_string(++copies_[name] + 1);
        return unique;
    }

    SvgOptions options_;
    Diagnostics diagnostics_;
    pugi::xml_document document_;
    std::map<std::string, pugi::xml_node, std::less<>> by_id_;
    SvgSheet sheet_;
    SvgViewport viewport_;
    Affine page_;
    SvgNotes result_notes_;
    std::set<std::string> colors_;
    std::set<std::string> names_;
    std::map<std::string, int> copies_;
    int elements_ = 0;
    std::size_t points_ = 0;
    int errors_ = 0;
    ImportedScene result_;
};

void require_positive(const char* what, double value) {
    if (!(std::isfinite(value) && value > 0.0))
        throw std::invalid_argument(std::string(what) + " must be finite and greater than 0, got " +
                                    std::to_string(value));
}

}  // namespace

}  // namespace scene

ImportedScene parse_svg(std::string_view text, const std::string& file_name, const SvgOptions& options) {
    scene::require_positive("metres_per_pixel", options.metres_per_pixel);
    scene::require_positive("tolerance", options.tolerance);
    text = scene::without_byte_order_mark(text);
    if (text.size() > scene::kMaxFileBytes)
        throw FileError(file_name, "is larger than " + std::to_string(scene::kMaxFileBytes >> 20) + " MiB");
    return scene::SvgImport(text, file_name, options).run();
}

ImportedScene import_svg(const std::filesystem::path& file, const SvgOptions& options) {
    return parse_svg(read_file(file, scene::kMaxFileBytes), file.string(), options);
}

}  // namespace tumble
