// The published schema and the reader agree, by the word of an independent validator.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "scene/bad_scenes.hpp"
#include "scene/example.hpp"
#include "scene/shipped.hpp"
#include "tumble/scene.hpp"

using namespace tumble;

namespace {

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

class SchemaValidator {
public:
    SchemaValidator() {
        document_ = nlohmann::json::parse(scene_schema());
        valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
        parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document_), schema_);
    }

    bool accepts(const std::string& text) {
        const nlohmann::json value = nlohmann::json::parse(text, nullptr, true, true);
        return validator_.validate(schema_, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
    }

private:
    nlohmann::json document_;
    valijson::Schema schema_;
    valijson::Validator validator_;
};

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
    SchemaValidator schema;
    for (const std::filesystem::path& file : test::shipped_scenes())
        CHECK_MESSAGE(schema.accepts(read_text(file)), file.filename());
    CHECK(schema.accepts(test::kExample));
    CHECK(schema.accepts(R"({"format": 1})"));
}

TEST_CASE("the schema rejects what the reader rejects field by field") {
    SchemaValidator schema;
    int expressible = 0;
    for (const test::BadScene& bad : test::kBadScenes) {
        if (!bad.schema_knows) continue;
        ++expressible;
        CHECK_MESSAGE(!schema.accepts(bad.text), bad.text);
    }
    CHECK(expressible > 20);
}

TEST_CASE("every property of the schema has a title and a description that say something") {
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
