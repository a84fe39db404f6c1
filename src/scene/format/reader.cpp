// The reading visitor of the table in fields.hpp: Reader::read is overloaded on what a field can be, ObjectReader goes
// through the fields of one object and keeps the books on its keys.
#include "scene/format/reader.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>

#include "scene/format/fields.hpp"
#include "scene/json/json_text.hpp"
#include "scene/json/pointer.hpp"
#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kLongestQuote = 40;

// What other programs write, where this format has another word or form: the hint that says which. It is given where
// `beside` is a key.
struct Habit {
    std::string_view key, beside, hint;
};
constexpr Habit kHabits[] = {
    {"bodyA", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"bodyB", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"body_a", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"body_b", "bodies", R"("bodies": ["a", "b"] names both)"},
    {"x", "position", R"("position": [x, y])"},
    {"y", "position", R"("position": [x, y])"},
    {"rotation", "position", R"("angle", in degrees, counter-clockwise)"},
    {"type", "circle", R"(the kind of a shape is its key: {"circle": {"radius": 1}})"},
    {"radius", "circle", R"({"circle": {"radius": 1}})"},
    {"size", "box", R"({"box": {"size": [2, 1]}})"},
    {"vertices", "polygon", R"({"polygon": {"vertices": [[0, 0], [1, 0], [0, 1]]}})"},
    {"width", "size", R"("size": [width, height])"},
    {"height", "size", R"("size": [width, height])"},
};

// What the kinds of joints are called elsewhere.
constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {
    {"hinge", "revolute"}, {"pin", "revolute"},    {"slider", "prismatic"}, {"rope", "distance"},
    {"rod", "distance"},   {"spring", "distance"}, {"fixed", "weld"},
};

// True for #rgb and #rrggbb.
bool is_color(const std::string& text) {
    return (text.size() == 4 || text.size() == 7) && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

class Reader {
public:
    Reader(Diagnostics& diagnostics, bool for_query) : diagnostics_(diagnostics), for_query_(for_query) {}

    void error(const Place& place, const std::string& message, const std::string& hint = "",
               Diagnostics::At at = Diagnostics::At::value) {
        diagnostics_.error(pointer_to(place), message, hint, at);
    }

    void wrong(const Place& place, const std::string& wanted, const Json& got, const std::string& hint = "") {
        error(place, "must be " + wanted + ", got " + describe(got), hint);
    }

    void read(const Json& value, const Place& place, const Field& field, double& out) {
        if (!value.is_number()) return wrong(place, "a number", value);
        if (in_range(value, place, field)) out = value.get<double>() + 0.0;  // + 0.0 turns -0 into 0
    }

    template <std::integral Integer>
    void read(const Json& value, const Place& place, const Field& field, Integer& out) {
        if (!value.is_number()) return wrong(place, "a whole number", value);
        if (value.is_number_float() && value.get<double>() != std::floor(value.get<double>()))
            return wrong(place, "a whole number", value);
        if (in_range(value, place, field)) out = value.get<Integer>();
    }

    void read(const Json& value, const Place& place, const Field&, bool& out) {
        if (!value.is_boolean()) return wrong(place, "true or false", value);
        out = value.get<bool>();
    }

    void read(const Json& value, const Place& place, const Field& field, std::string& out) {
        if (!value.is_string()) return wrong(place, "a string", value);
        out = value.get<std::string>();
        if (field.text == Text::name && (out.empty() || out.size() > kMaxNameBytes))
            wrong(place, "a name of 1 to " + std::to_string(kMaxNameBytes) + " bytes", value);
        if (field.text == Text::color && !is_color(out))
            wrong(place, "a colour, \"#rgb\" or \"#rrggbb\"", value, "for example \"#d33\"");
    }

    template <class Enum>
    requires std::is_enum_v<Enum>
    void read(const Json& value, const Place& place, const Field&, Enum& out) {
        if (!value.is_string()) return wrong(place, "a string", value);
        const std::string& text = value.get_ref<const std::string&>();
        std::vector<std::string_view> names;
        for (const auto& [enumerator, name] : kEnumNames<Enum>) {
            if (name == text) {
                out = enumerator;
                return;
            }
            names.push_back(name);
        }
        error(place, "must be one of " + join_words(names) + ", got " + describe(value), did_you_mean(text, names));
    }

    void read(const Json& value, const Place& place, const Field& field, DVec2& out) {
        const bool is_object = value.is_object() && value.contains("x") && value.contains("y");
        read_two(value, place, field, out.x, out.y, "a vector [x, y]",
                 is_object           ? "[" + compact_text(value["x"]) + ", " + compact_text(value["y"]) + "]"
                 : value.is_number() ? "a number for x and one for y: [0, " + compact_text(value) + "]"
                                     : "");
    }

    void read(const Json& value, const Place& place, const Field& field, SceneInterval& out) {
        const std::string number = value.is_number() ? compact_text(value) : "";
        read_two(value, place, field, out.lower, out.upper, "[lower, upper]",
                 number.empty() ? "" : "[" + number + ", " + number + "] for exactly " + number);
        if (out.lower > out.upper)
            error(place, "must be [lower, upper] with lower <= upper, got " + compact_text(value));
    }

    template <class First, class Second>
    void read(const Json& value, const Place& place, const Field& field, std::pair<First, Second>& out) {
        read_two(value, place, field, out.first, out.second, "an array of 2");
    }

    template <class T>
    void read(const Json& value, const Place& place, const Field& field, std::optional<T>& out) {
        read(value, place, field, out.emplace());
    }

    template <class T>
    void read(const Json& value, const Place& place, const Field& field, std::vector<T>& out) {
        if (!value.is_array()) return wrong(place, "an array", value);
        if (value.size() < field.min_items)
            return wrong(place, "an array of at least " + std::to_string(field.min_items), value);
        if (value.size() > field.max_items)
            return wrong(place, "an array of at most " + std::to_string(field.max_items), value);
        out.resize(value.size());
        for (std::size_t i = 0; i < value.size(); ++i) read(value[i], child(place, i), field, out[i]);
    }

    template <class... T>
    void read(const Json& value, const Place& place, const Field&, std::variant<T...>& out);

    template <class T>
    requires std::is_class_v<T>
    void read(const Json& value, const Place& place, const Field&, T& out);

    template <class First, class Second>
    void read_two(const Json& value, const Place& place, const Field& field, First& first, Second& second,
                  const std::string& wanted, const std::string& hint = "") {
        if (!value.is_array() || value.size() != 2) return wrong(place, wanted, value, hint);
        read(value[0], child(place, 0), field, first);
        read(value[1], child(place, 1), field, second);
    }

    // Not known to the table: "did you mean" without the list, which the message has.
    static std::string did_you_mean(const std::string& text, const std::vector<std::string_view>& names) {
        for (const auto& [other, name] : kOtherNames)
            if (text == other && std::ranges::find(names, name) != names.end())
                return "here it is called '" + std::string(name) + "'";
        return nearest_word(text, names).empty() ? "" : suggestion(text, names);
    }

private:
    bool in_range(const Json& value, const Place& place, const Field& field) {
        const Range& range = field.range;
        const double number = value.get<double>();
        const bool above_min = range.above_min && !(for_query_ && range.zero_in_queries);
        if (above_min ? number <= range.min : number < range.min) {
            wrong(place, (above_min ? "greater than " : "at least ") + number_text(range.min), value);
            return false;
        }
        // 2^64 itself is the double next to the largest seed.
        if (number > range.max || (number == range.max && number == 0x1p64 && !value.is_number_unsigned())) {
            wrong(place, "at most " + number_text(range.max), value);
            return false;
        }
        return true;
    }

    Diagnostics& diagnostics_;
    bool for_query_ = false;
};

// Visits the fields of `out` with the members of one JSON object.
template <class T>
class ObjectReader {
public:
    ObjectReader(Reader& reader, const Json& value, const Place& place, T& out)
        : reader_(reader), value_(value), place_(place), out_(out) {}

    void field(const Field& field, auto T::*member) {
        if (const Json* found = find(field)) reader_.read(*found, child(place_, field.name), field, out_.*member);
    }

    void pair(const Field& field, std::string T::*first, std::string T::*second) {
        const Json* found = find(field);
        if (found == nullptr) return;
        reader_.read_two(*found, child(place_, field.name), field, out_.*first, out_.*second, "an array of 2 names");
    }

    template <class Element>
    void named(const Field& field, std::vector<Element> T::*member) {
        const Json* found = find(field);
        if (found == nullptr) return;
        const Place place = child(place_, field.name);
        if (!found->is_object()) return reader_.wrong(place, "an object", *found);
        for (const auto& [name, value] : found->items()) {
            Element& element = (out_.*member).emplace_back();
            element.name = name;
            if (name.empty()) reader_.error(place, "has an empty name as a key");
            reader_.read(value, child(place, name), field, element);
        }
    }

    void json(const Field& field, std::string T::*member) {
        if (const Json* found = find(field)) out_.*member = compact_text(*found);
    }

    void constant(const Field& field, int number) {
        const Json* found = find(field);
        if (found == nullptr || *found == number) return;
        reader_.wrong(child(place_, field.name), std::to_string(number), *found);
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

    // After all fields: reports unknown keys, and what is missing unless an unknown key looks like it.
    void finish() {
        std::vector<std::string_view> guesses;
        for (const auto& [key, element] : value_.items()) {
            if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
            guesses.push_back(nearest_word(key, known_));
            reader_.error(child(place_, key), "unknown key " + quoted(key), hint_for(key), Diagnostics::At::key);
        }
        for (const Missing& missing : missing_) {
            const bool guessed = std::any_of(missing.names.begin(), missing.names.end(), [&](std::string_view name) {
                return std::find(guesses.begin(), guesses.end(), name) != guesses.end();
            });
            if (!guessed) reader_.error(place_, missing.message);
        }
    }

    // The whole of an object that is a variant, as a repeater is.
    template <class Variant>
    static void read_variant(Reader& reader, const Json& value, const Place& place, Variant& out) {
        struct Holder {
            Variant variant;
        } holder;
        ObjectReader<Holder> object(reader, value, place, holder);
        object.one_of({}, &Holder::variant);
        object.finish();
        out = holder.variant;
    }

private:
    struct Missing {
        std::vector<std::string_view> names;
        std::string message;
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
            object.reader_.read(*value, child(object.place_, name), Field{}, out.template emplace<Alternative>());
        }
    };

    const Json* find(const Field& field) {
        known_.push_back(field.name);
        const auto found = value_.find(field.name);
        if (found != value_.end()) return &*found;
        if (field.required)
            missing_.push_back({{field.name}, "the key " + quoted(std::string(field.name)) + " is missing"});
        return nullptr;
    }

    // What was meant, or where the key belongs.
    std::string hint_for(const std::string& key) const {
        for (const Habit& habit : kHabits)
            if (habit.key == key && std::ranges::find(known_, habit.beside) != known_.end())
                return std::string(habit.hint);
        if (!nearest_word(key, known_).empty()) return suggestion(key, known_);
        if (has_field<SceneMaterial>(key)) return quoted(key) + " belongs to a material, and the material to a shape";
        if (has_field<SceneBody>(key)) return quoted(key) + " belongs to a body";
        if (has_field<SceneSettings>(key)) return quoted(key) + " belongs to the world";
        return suggestion(key, known_);
    }

    void require_one(const std::vector<std::string_view>& names, const std::vector<std::string_view>& found) {
        if (found.empty()) missing_.push_back({names, "needs one of the keys " + join_words(names)});
        if (found.size() > 1) refuse_together(found);
    }

    void refuse_together(const std::vector<std::string_view>& found) {
        reader_.error(child(place_, found[1]), "has the keys " + join_words(found) + ": only one of them is allowed",
                      "", Diagnostics::At::key);
    }

    Reader& reader_;
    const Json& value_;
    const Place& place_;
    T& out_;
    std::vector<std::string_view> known_;
    std::vector<Missing> missing_;
};

template <class... T>
void Reader::read(const Json& value, const Place& place, const Field&, std::variant<T...>& out) {
    if (!value.is_object()) return wrong(place, "an object", value);
    ObjectReader<Scene>::read_variant(*this, value, place, out);
}

template <class T>
requires std::is_class_v<T>
void Reader::read(const Json& value, const Place& place, const Field&, T& out) {
    if (!value.is_object()) return wrong(place, "an object", value);
    ObjectReader<T> object(*this, value, place, out);
    visit_fields(object, Type<T>{});
    object.finish();
}

}  // namespace

std::string describe(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return value.empty() ? "an empty array" : "an array of " + std::to_string(value.size());
    const std::string text = compact_text(value);
    return text.size() <= kLongestQuote ? text : quoted(value.get<std::string>().substr(0, kLongestQuote)) + "...";
}

Scene read_scene(const Json& value, Diagnostics& diagnostics) {
    Scene scene;
    Reader(diagnostics, false).read(value, Place{}, Field{}, scene);
    return scene;
}

ShapeGeometry read_query_geometry(const Json& value, Diagnostics& diagnostics) {
    SceneShape shape;
    Reader(diagnostics, true).read(value, Place{}, Field{}, shape);
    return shape.geometry;
}

}  // namespace tumble::scene
