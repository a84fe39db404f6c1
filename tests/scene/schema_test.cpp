// The published schema, tested with an independent validator, agrees with the reader.
#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "scene/bad_scenes.hpp"
#include "scene/example.hpp"
#include "scene/schema_validator.hpp"
#include "scene/shipped.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

// Calls `visit(name, property)` for every property of every object in the schema.
template <class Visit>
void for_each_property(const nlohmann::json& schema, const Visit& visit) {
    if (schema.is_object() && schema.contains("properties") && schema["properties"].is_object() &&
        schema.value("type", "") == "object") {
        for (const auto& [name, property] : schema["properties"].items()) visit(name, property);
    }
    if (!schema.is_structured()) return;
    for (const auto& [key, element] : schema.items())
        if (key != "default") for_each_property(element, visit);
}

}  // namespace

TEST_CASE("scenes/scene.schema.json is the schema of this version") {
    CHECK(read_text(std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes/scene.schema.json") == scene_schema());
}

TEST_CASE("the schema accepts every shipped scene and the example") {
    test::SchemaValidator schema;
    for (const std::filesystem::path& file : test::shipped_scenes())
        CHECK_MESSAGE(schema.accepts_text(read_text(file)), file.filename());
    CHECK(schema.accepts_text(test::kExample));
    CHECK(schema.accepts_text(R"({"format": 1})"));
}

TEST_CASE("the schema accepts a scene that the reader rejects only if no schema can express the reason") {
    test::SchemaValidator schema;
    int by_both = 0;
    std::map<std::string, int> by_reader_alone;
    for (const test::BadScene& bad : test::kBadScenes) {
        CAPTURE(bad.text);
        CHECK(schema.accepts_text(bad.text) == !bad.only_reader.empty());
        ++(bad.only_reader.empty() ? by_both : by_reader_alone[bad.only_reader]);
    }
    CHECK(by_both > 40);
    CHECK(by_reader_alone.size() == 8);
    for (const auto& entry : by_reader_alone) CHECK_MESSAGE(entry.second >= 2, entry.first);
}

TEST_CASE("the validator checks each keyword of the schema") {
    struct Case {
        const char *schema, *accepted, *refused;
    };
    const Case cases[] = {
        {R"({"type": "integer"})", "1", "1.5"},
        {R"({"type": "number"})", "1", "\"1\""},
        {R"({"enum": ["a", "b"]})", "\"b\"", "\"c\""},
        {R"({"const": 1})", "1", "2"},
        {R"({"type": "number", "minimum": -0.5})", "-0.5", "-0.75"},
        {R"({"type": "number", "maximum": 2.5})", "2.5", "2.75"},
        {R"({"type": "number", "exclusiveMinimum": 0})", "1e-9", "0"},
        {R"({"type": "string", "minLength": 1})", "\"a\"", "\"\""},
        {R"({"type": "string", "pattern": "^#([0-9a-f]{3}|[0-9a-f]{6})$"})", "\"#12ab56\"", "\"#12ab5\""},
        {R"({"type": "array", "items": {"type": "boolean"}})", "[true]", "[true, 1]"},
        {R"({"type": "array", "minItems": 2})", "[1, 2]", "[1]"},
        {R"({"type": "array", "maxItems": 2})", "[1, 2]", "[1, 2, 3]"},
        {R"({"properties": {"a": {"type": "string"}}})", R"({"a": "x"})", R"({"a": 1})"},
        {R"({"properties": {"a": {}}, "additionalProperties": false})", R"({"a": 1})", R"({"b": 1})"},
        {R"({"additionalProperties": {"type": "string"}})", R"({"b": "x"})", R"({"b": 1})"},
        {R"({"properties": {"a": {}}, "required": ["a"]})", R"({"a": 1})", "{}"},
        {R"({"allOf": [{"not": {"required": ["a", "b"]}}]})", R"({"a": 1})", R"({"a": 1, "b": 1})"},
        {R"({"oneOf": [{"required": ["a"]}, {"required": ["b"]}]})", R"({"a": 1})", R"({"a": 1, "b": 1})"},
        {R"({"definitions": {"n": {"type": "null"}}, "properties": {"a": {"allOf": [{"$ref": "#/definitions/n"}]}}})",
         R"({"a": null})", R"({"a": 1})"},
    };
    for (const Case& entry : cases) {
        CAPTURE(entry.schema);
        test::SchemaValidator schema(nlohmann::json::parse(entry.schema));
        CHECK(schema.accepts_text(entry.accepted));
        CHECK_FALSE(schema.accepts_text(entry.refused));
    }
    CHECK_THROWS_AS(test::SchemaValidator(nlohmann::json{{"uniqueItems", true}}), std::invalid_argument);
}

TEST_CASE("every property of the schema has a title and a description") {
    int properties = 0;
    for_each_property(nlohmann::json::parse(scene_schema()),
                      [&](const std::string& name, const nlohmann::json& property) {
                          ++properties;
                          CHECK_MESSAGE(property.value("title", "").size() >= 2, name);
                          CHECK_MESSAGE(property.value("description", "").size() >= 6, name);
                      });
    CHECK(properties > 80);
}

TEST_CASE("the defaults that the schema shows are those of the structs") {
    const nlohmann::json schema = nlohmann::json::parse(scene_schema());
    const nlohmann::json& world = schema["properties"]["world"]["properties"];
    CHECK(world["gravity"]["default"] == nlohmann::json({0, -10}));
    CHECK(world["gravity"]["unit"] == "m/s^2");
    CHECK(world["duration"]["default"] == 5);
    const nlohmann::json& body = schema["definitions"]["body"]["properties"];
    CHECK(body["gravity_scale"]["default"] == 1);
    CHECK(body["type"]["default"] == "dynamic");
}
