// The visitor of the table in fields.hpp that reads. Reader::read is overloaded on the types that a field can have;
// ObjectReader visits the fields of one object and tracks which keys are known and which are missing.
#include "scene/format/reader.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>

#include "scene/format/fields.hpp"
#include "scene/format/foreign_words.hpp"
#include "scene/format/text_forms.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/pointer.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

class Reader {
public:
    Reader(Diagnostics& diagnostics, bool for_query) : diagnostics_(diagnostics), for_query_(for_query) {}
    Reader(Diagnostics& diagnostics, const Json& root, const DrawContext& context)
        : diagnostics_(diagnostics), root_(&root), context_(context) {}

    std::vector<SceneDraw> take_draws() { return std::move(draws_); }

    void error(const Location& location, const std::string& message, const std::string& hint = "",
               Diagnostics::At at = Diagnostics::At::value) {
        diagnostics_.error(pointer_to(location), message, hint, at);
    }

    void wrong(const Location& location, const std::string& wanted, const Json& got, const std::string& hint = "") {
        const std::string_view key = location.key.data() || !location.parent ? location.key : location.parent->key;
        error(location, "must be " + wanted + ", got " + describe(got),
              hint.empty() ? hint_for_wrong_value(key, wanted, got) : hint);
    }

    void read(const Json& value, const Location& location, const Field& field, double& out) {
        if (value.is_object() && root_ != nullptr) return draw(value, location, field, false, out);
        if (!value.is_number()) return wrong(location, "a number", value);
        if (in_range(value, location, field)) out = value.get<double>() + 0.0;  // + 0.0 turns -0 into 0
    }

    template <std::integral Integer>
    void read(const Json& value, const Location& location, const Field& field, Integer& out) {
        const bool can_be_drawn = root_ != nullptr && field.range.max != kSeed.max;
        if (double number = 0.0; value.is_object() && can_be_drawn) {
            draw(value, location, field, true, number);
            out = static_cast<Integer>(number);
            return;
        }
        if (!value.is_number()) return wrong(location, "a whole number", value);
        if (value.is_number_float() && value.get<double>() != std::floor(value.get<double>()))
            return wrong(location, "a whole number", value);
        if (in_range(value, location, field)) out = value.get<Integer>();
    }

    void read(const Json& value, const Location& location, const Field&, bool& out) {
        if (!value.is_boolean()) return wrong(location, "true or false", value);
        out = value.get<bool>();
    }

    void read(const Json& value, const Location& location, const Field& field, std::string& out) {
        if (!value.is_string()) return wrong(location, "a string", value);
        out = value.get<std::string>();
        const bool is_name = field.text == Text::name || field.text == Text::png_file;
        if (is_name && (out.empty() || out.size() > kMaxNameBytes))
            return wrong(location, "a name of 1 to " + std::to_string(kMaxNameBytes) + " bytes", value);
        if (field.text == Text::expression && (out.empty() || out.size() > kMaxExpressionBytes))
            wrong(location, "an expression of 1 to " + std::to_string(kMaxExpressionBytes) + " bytes", value);
        if (field.text == Text::hash && !is_hash(out)) wrong(location, "16 digits 0-9 and a-f", value);
        if (field.text == Text::png_file && !out.ends_with(".png")) wrong(location, "the name of a .png file", value);
        if (field.text == Text::caption && (out.empty() || out.size() > kMaxCaptionBytes))
            wrong(location, "a text of 1 to " + std::to_string(kMaxCaptionBytes) + " bytes", value);
        if (field.text == Text::color && !is_color(out))
            wrong(location, "a colour, \"#rgb\" or \"#rrggbb\"", value, hint_for_color(out));
    }

    template <class Enum>
    requires std::is_enum_v<Enum>
    void read(const Json& value, const Location& location, const Field&, Enum& out) {
        if (!value.is_string()) return wrong(location, "a string", value);
        const std::string& text = value.get_ref<const std::string&>();
        std::vector<std::string_view> names;
        for (const auto& [enumerator, name] : kEnumNames<Enum>) {
            if (name == text) {
                out = enumerator;
                return;
            }
            names.push_back(name);
        }
        error(location, "must be one of " + join_words(names) + ", got " + describe(value),
              hint_for_foreign_word(text, names));
    }

    void read(const Json& value, const Location& location, const Field& field, DVec2& out) {
        read_two(value, location, field, out.x, out.y, "a vector [x, y]");
    }

    void read(const Json& value, const Location& location, const Field& field, SceneInterval& out) {
        read_two(value, location, field, out.lower, out.upper, "[lower, upper]");
        if (out.lower > out.upper)
            error(location, "must be [lower, upper] with lower <= upper, got " + compact_text(value));
    }

    template <class First, class Second>
    void read(const Json& value, const Location& location, const Field& field, std::pair<First, Second>& out) {
        read_two(value, location, field, out.first, out.second, "an array of 2");
    }

    template <class T>
    void read(const Json& value, const Location& location, const Field& field, std::optional<T>& out) {
        read(value, location, field, out.emplace());
    }

    template <class T>
    void read(const Json& value, const Location& location, const Field& field, std::vector<T>& out) {
        if (!value.is_array()) return wrong(location, "an array", value);
        if (value.size() < field.min_items)
            return wrong(location, "an array of at least " + std::to_string(field.min_items), value);
        if (value.size() > field.max_items)
            return wrong(location, "an array of at most " + std::to_string(field.max_items), value);
        out.resize(value.size());
        for (std::size_t i = 0; i < value.size(); ++i) read(value[i], child(location, i), field, out[i]);
    }

    template <class... T>
    void read(const Json& value, const Location& location, const Field&, std::variant<T...>& out);

    template <class T>
    requires std::is_class_v<T>
    void read(const Json& value, const Location& location, const Field&, T& out);

    template <class First, class Second>
    void read_two(const Json& value, const Location& location, const Field& field, First& first, Second& second,
                  const std::string& wanted) {
        if (!value.is_array() || value.size() != 2) return wrong(location, wanted, value);
        read(value[0], child(location, 0), field, first);
        read(value[1], child(location, 1), field, second);
    }

private:
    static bool is_within(double number, const Range& range) {
        return (range.above_min ? number > range.min : number >= range.min) && number <= range.max;
    }

    void draw(const Json& value, const Location& location, const Field& field, bool whole, double& out) {
        const std::string pointer = pointer_to(location);
        const std::string key = draw_key(*root_, pointer, context_);
        try {
            out = draw_number(value, key, context_.seed, whole,
                              [&](double number) { return is_within(number, field.range); });
            draws_.push_back({pointer, key, compact_text(value), out});
        } catch (const WrongDraw& wrong) {
            const std::string place = wrong.key.empty() ? pointer : append_key(pointer, wrong.key);
            diagnostics_.error(place, wrong.message);
        }
    }

    bool in_range(const Json& value, const Location& location, const Field& field) {
        const Range& range = field.range;
        const double number = value.get<double>();
        const bool above_min = range.above_min && !(for_query_ && range.zero_in_queries);
        if (above_min ? number <= range.min : number < range.min) {
            wrong(location, (above_min ? "greater than " : "at least ") + number_text(range.min), value);
            return false;
        }
        // The largest seed, 2^64 - 1, is 2^64 as a double. The parser reads it as an unsigned integer, and any larger
        // number as a float.
        if (number > range.max || (number == range.max && number == 0x1p64 && !value.is_number_unsigned())) {
            wrong(location, "at most " + number_text(range.max), value);
            return false;
        }
        return true;
    }

    Diagnostics& diagnostics_;
    bool for_query_ = false;
    const Json* root_ = nullptr;  // of a file whose numbers may be drawn
    DrawContext context_{};
    std::vector<SceneDraw> draws_;
};

// Visits the fields of `out` with the members of one JSON object.
template <class T>
class ObjectReader {
public:
    ObjectReader(Reader& reader, const Json& value, const Location& location, T& out)
        : reader_(reader), value_(value), location_(location), out_(out) {}

    void field(const Field& field, auto T::*member) {
        if (const Json* found = find(field)) reader_.read(*found, child(location_, field.name), field, out_.*member);
    }

    void pair(const Field& field, std::string T::*first, std::string T::*second) {
        const Json* found = find(field);
        if (found == nullptr) return;
        reader_.read_two(*found, child(location_, field.name), field, out_.*first, out_.*second, "an array of 2 names");
    }

    template <class Element>
    void named(const Field& field, std::vector<Element> T::*member) {
        const Json* found = find(field);
        if (found == nullptr) return;
        const Location location = child(location_, field.name);
        if (!found->is_object()) return reader_.wrong(location, "an object", *found);
        for (const auto& [name, value] : found->items()) {
            Element& element = (out_.*member).emplace_back();
            element.name = name;
            if (name.empty()) reader_.error(location, "has an empty name as a key");
            reader_.read(value, child(location, name), field, element);
        }
    }

    void json(const Field& field, std::string T::*member) {
        if (const Json* found = find(field)) out_.*member = compact_text(*found);
    }

    void constant(const Field& field, int number) {
        const Json* found = find(field, quoted(std::string(field.name)) + ": " + std::to_string(number));
        if (found == nullptr || *found == number) return;
        reader_.wrong(child(location_, field.name), std::to_string(number), *found);
    }

    template <class Variant>
    void one_of(const Field&, Variant T::*member) {
        Alternatives<Variant> alternatives{*this, out_.*member, {}, {}};
        visit_alternatives(alternatives, Type<Variant>{});
        require_one(alternatives.names, alternatives.found);
    }

    void exactly_one(std::initializer_list<std::string_view> names) {
        std::vector<std::string_view> found;
        for (const std::string_view name : names)
            if (value_.contains(name)) found.push_back(name);
        require_one(names, found);
    }

    void at_most_one(std::string_view first, std::string_view second) {
        if (value_.contains(first) && value_.contains(second)) refuse_together({first, second});
    }

    // After all fields: reports unknown keys, and missing ones unless an unknown key is probably a misspelling of them.
    void finish() {
        std::vector<std::string_view> guesses;
        for (const auto& [key, element] : value_.items()) {
            if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
            guesses.push_back(nearest_word(key, known_));
            reader_.error(child(location_, key), "unknown key " + quoted(key), hint_for(key), Diagnostics::At::key);
        }
        for (const Missing& missing : missing_) {
            const bool guessed = std::any_of(missing.names.begin(), missing.names.end(), [&](std::string_view name) {
                return std::find(guesses.begin(), guesses.end(), name) != guesses.end();
            });
            if (!guessed) reader_.error(location_, missing.message, missing.hint);
        }
    }

    // Reads an object that is a variant as a whole, such as a repeater.
    template <class Variant>
    static void read_variant(Reader& reader, const Json& value, const Location& location, Variant& out) {
        struct Holder {
            Variant variant;
        } holder;
        ObjectReader<Holder> object(reader, value, location, holder);
        object.one_of({}, &Holder::variant);
        object.finish();
        out = holder.variant;
    }

private:
    struct Missing {
        std::vector<std::string_view> names;
        std::string message, hint;
    };

    template <class Variant>
    struct Alternatives {
        ObjectReader& object;
        Variant& out;
        std::vector<std::string_view> names;
        std::vector<std::string_view> found;

        template <class Alternative>
        void alternative(std::string_view name, std::string_view) {
            names.push_back(name);
            object.known_.push_back(name);
            const auto value = object.value_.find(name);
            if (value == object.value_.end()) return;
            found.push_back(name);
            object.reader_.read(*value, child(object.location_, name), Field{}, out.template emplace<Alternative>());
        }
    };

    // `hint` is that of a missing key.
    const Json* find(const Field& field, const std::string& hint = "") {
        known_.push_back(field.name);
        const auto found = value_.find(field.name);
        if (found != value_.end()) return &*found;
        if (field.required)
            missing_.push_back({{field.name}, "the key " + quoted(std::string(field.name)) + " is missing", hint});
        return nullptr;
    }

    // The hint for an unknown key: the key that was probably meant, or the object that the key belongs to.
    std::string hint_for(const std::string& key) const {
        if (const std::string_view hint = hint_for_foreign_key(key, known_); !hint.empty()) return std::string(hint);
        if (!nearest_word(key, known_).empty()) return suggestion(key, known_);
        if (has_field<SceneMaterial>(key)) return quoted(key) + " belongs to a material, and the material to a shape";
        if (has_field<SceneBody>(key)) return quoted(key) + " belongs to a body";
        if (has_field<SceneSettings>(key)) return quoted(key) + " belongs to the world";
        return suggestion(key, known_);
    }

    void require_one(const std::vector<std::string_view>& names, const std::vector<std::string_view>& found) {
        if (found.empty()) missing_.push_back({names, "needs one of the keys " + join_words(names), ""});
        if (found.size() > 1) refuse_together(found);
    }

    void refuse_together(const std::vector<std::string_view>& found) {
        reader_.error(child(location_, found[1]), "has the keys " + join_words(found) + ": only one of them is allowed",
                      "", Diagnostics::At::key);
    }

    Reader& reader_;
    const Json& value_;
    const Location& location_;
    T& out_;
    std::vector<std::string_view> known_;
    std::vector<Missing> missing_;
};

template <class... T>
void Reader::read(const Json& value, const Location& location, const Field&, std::variant<T...>& out) {
    if (!value.is_object()) return wrong(location, "an object", value);
    ObjectReader<Scene>::read_variant(*this, value, location, out);
}

template <class T>
requires std::is_class_v<T>
void Reader::read(const Json& value, const Location& location, const Field&, T& out) {
    if (!value.is_object()) return wrong(location, "an object", value);
    ObjectReader<T> object(*this, value, location, out);
    visit_fields(object, Type<T>{});
    object.finish();
}

}  // namespace

Scene read_scene(const Json& value, Diagnostics& diagnostics, const DrawContext& context) {
    Scene scene;
    Reader reader(diagnostics, value, context);
    reader.read(value, Location{}, Field{}, scene);
    scene.draws = reader.take_draws();
    return scene;
}

std::uint64_t seed_of(const Json& scene) {
    const bool has_seed = scene.is_object() && scene.contains("world") && scene["world"].is_object() &&
                          scene["world"].contains("seed") && scene["world"]["seed"].is_number_unsigned();
    return has_seed ? scene["world"]["seed"].get<std::uint64_t>() : SceneSettings{}.seed;
}

ShapeGeometry read_query_geometry(const Json& value, Diagnostics& diagnostics) {
    SceneShape shape;
    Reader(diagnostics, true).read(value, Location{}, Field{}, shape);
    return shape.geometry;
}

}  // namespace tumble::scene
